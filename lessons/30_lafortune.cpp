// New idea: three numbers C turn the light's direction into the one about which a lobe stands.
// Builds on: lesson 18, Phong's R.V; lesson 28, polar plots.
// Try: --cz .4; --n 5; with which C does a lobe stand on the normal, wherever the light is?
#include <algorithm>
#include <cmath>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/polar.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/reflect/query.h"
#include "rasterizer/formula_model.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// f_r = rd / pi + (Cx lx vx + Cy ly vy + Cz lz vz)^n, one of Lafortune's lobes with Cx = Cy. The
/// sum is V.(C L): C L is the light's direction with each component stretched or turned around.
struct Lobe {
  double cx, cz, n;
  Rgb<double> rd, colour;

  template <class T>
  Vec3<T> stretched(const Vec3<T>& l) const {
    return {T(cx) * l.x, T(cx) * l.y, T(cz) * l.z};
  }
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    const T cosine = max(dot(stretched(f.l), f.v), T(0));
    return {.diffuse = rd * c.n_l, .glossy = colour * (pow(cosine, T(n)) * c.n_l)};
  }
};
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("Lafortune's lobes: mirror, off-specular, backwards.", 1740, 940);
  double n = 20, cz = .6, theta = 60;
  lesson.knob("--n", n, {1, 200}, "exponent of the lobes");
  lesson.knob("--cz", cz, {.05, .99}, "Cz of the lobe off the mirror direction");
  lesson.knob("--light", theta, {0, 85}, "angle of the light in the plots, in degrees");

  return lesson.run(argc, argv, [&] {
    const std::string names[] = {"mirror", "off-specular", "backwards"};
    const double cxs[] = {-1, -1, 1}, czs[] = {1, cz, 1};
    const auto draw = [&](int panel, int width, int height) {
      const int i = panel % 3;
      // The lobe's largest value is (C L)^n: 1 for the plotted light, whatever C.
      Lobe lobe{cxs[i], czs[i], n, Rgb<double>(0), Rgb<double>(1)};
      const Vec3<double> L = studio::direction_at(-theta, 0), axis = lobe.stretched(L);
      const double length = std::sqrt(dot(axis, axis));
      lobe.cx /= length, lobe.cz /= length;
      if (panel < 3) {
        const FormulaModel<Lobe> model(lobe);
        studio::Polar plot(width, height, 1, lesson.height());
        plot.light(theta, ink::black);
        plot.lobe(
            [&](double theta_v) {
              const auto seen = studio::reflected(model, L, studio::direction_at(theta_v, 0));
              return seen.g / L.z;
            },
            ink::vermilion);
        lesson.figure(
            "light at " + studio::text_of(theta) + " degrees, " + names[i] + ", lobe stands at",
            studio::fixed(std::atan2(axis.x, axis.z) * 180 / std::numbers::pi, 1));
        return plot.finish();
      }
      lobe.rd = {.03, .09, .12}, lobe.colour = {.85, .75, .55};
      Scene scene = studio::make_stage(
          {studio::make_object("teapot:32", std::make_shared<const FormulaModel<Lobe>>(lobe))});
      scene.lights = {studio::far_light({-.65, .4, -.7}, 2), studio::far_light({.5, .5, 1}, .9)};
      return studio::photograph(scene, {1.5, 1.8, 5}, width, height);
    };
    const auto text = [&](int i) {
      return "C = (" + studio::text_of(cxs[i]) + ", " + studio::text_of(cxs[i]) + ", " +
             studio::text_of(czs[i]) + "): " + names[i];
    };
    return studio::panels(lesson.width(), lesson.height(), 3,
                          {text(0), text(1), text(2), names[0], names[1], names[2]}, draw);
  });
}
