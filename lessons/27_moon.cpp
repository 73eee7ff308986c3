// New idea: a rough diffuse surface sends more light back to where it came from, and looks flat.
// Builds on: lesson 17, the diffuse part.
// Try: --phase 60; --phase 120; --sigma 20: where does one see that the ball is of dust?
#include <cmath>
#include <glm/trigonometric.hpp>

#include "lessons/studio/drawing/chart.h"
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/reflect/query.h"
#include "models/inputs/lattice_noise.h"
#include "rasterizer/formula_model.h"

using namespace scanlit;
namespace ink = studio::ink;

template <class T>  // bright highlands and dark plains, carved from noise
Rgb<T> soil(const Vec3<T>& point) {
  const T noise = models::fractal_noise(point * T(1.7) + Vec3<T>{T(.3), T(.9), T(0)}, 6);
  return Rgb<double>(.86, .83, .78) * (T(.45) + T(.55) * models::smooth_step(-.5, .4, noise));
}

// new idea
/// Oren and Nayar, qualitative: grooves with slopes of deviation sigma, whose walls are Lambertian.
struct RoughDiffuse {
  double sigma;  // rad

  template <class T>
  T walls(const Cosines<T>& c) const {
    const double s2 = sigma * sigma;
    const T C1(1 - .5 * s2 / (s2 + .33)), C2(.45 * s2 / (s2 + .09));
    // sin A sin B cos phi: what is left of L.V where both are projected onto the surface.
    const T l_v = T(2) * c.v_h * c.v_h - T(1), across = l_v - c.n_l * c.n_v;
    return c.n_l * (C1 + C2 * max(across, T(0)) / max(c.n_l, c.n_v));  // cos B: the larger cosine
  }
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const SurfacePoint<T>& p) const {
    return {.diffuse = soil(p.object_position) * walls(c), .glossy = {}};
  }
};
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("Oren and Nayar's rough diffuse surface, and the full moon.", 1740, 1140);
  double sigma = 40, phase = 0;
  lesson.knob("--sigma", sigma, {0, 60}, "deviation of the slopes, in degrees");
  lesson.knob("--phase", phase, {0, 170}, "angle of sun and viewer, seen from the moon; degrees");

  return lesson.run(argc, argv, [&] {
    const glm::dvec3 sun(std::sin(glm::radians(phase)), 0, std::cos(glm::radians(phase)));
    const int row = lesson.height() * 27 / 50;
    studio::Chart chart(lesson.width(), lesson.height() - row, {-1, 1.5, "place on the disc"},
                        {0, 1, "brightness over rho, across the disc"}, lesson.height());
    const Rgb<double> colours[] = {ink::blue, ink::orange, ink::vermilion};
    std::vector<std::string> names;
    for (int k = 0; k < 3; ++k) {
      names.push_back(k == 0 ? "Lambert" : "sigma = " + studio::text_of(sigma * k / 2));
      const RoughDiffuse model{glm::radians(sigma * k / 2)};
      const auto seen = [&](double x) {  // with the point's own normal as z
        const double theta = glm::degrees(std::asin(x));
        const auto l = studio::direction_at(phase - theta, 0), v = studio::direction_at(-theta, 0);
        return l.z > 0 ? model.walls(cosines(Vec3<double>{0, 0, 1}, l, v)) : 0;
      };
      std::vector<glm::dvec2> curve;
      for (double x = -.9999; x < 1; x += .0002) curve.emplace_back(x, seen(x));
      chart.curve(curve, colours[k], 12);
      chart.words({1.04, std::max(seen(.9999), .0) + .05 * k}, names.back(), ink::black);
      lesson.figure(names.back() + ", in the middle and at 95 % of the radius",
                    studio::fixed(seen(0), 2) + ", " + studio::fixed(seen(.95), 2));
    }
    const auto moon = [&](int panel, int width, int height) {
      const RoughDiffuse model{glm::radians(sigma * panel / 2)};
      Scene scene = studio::make_stage({studio::make_object(
          "sphere:128", std::make_shared<const FormulaModel<RoughDiffuse>>(model))});
      scene.lights = {studio::far_light(sun, 1)};
      scene.ambient = scene.background = Rgb<double>(.004);
      const Camera far{.projection = Projection::orthographic, .height = 2.15, .far = 9};
      return studio::photograph(scene, far, width, height);
    };
    return studio::stacked(
        studio::panels(lesson.width(), row, 3, names, moon, Rgb<double>(.004), lesson.height()),
        chart.finish());
  });
}
