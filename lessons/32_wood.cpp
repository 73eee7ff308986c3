// New idea: fibres under varnish mirror into a cone; where they tilt, their highlight is elsewhere.
// Builds on: lesson 29, brushed metal, whose strokes lie in the surface.
// Try: --tilt 14; --beta .4; where is the highlight that all three curves would share, the coat's?
#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "lessons/studio/drawing/chart.h"
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/reflect/query.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// w, refracted into the coat: Snell's law shortens what lies along the surface.
Vec3<double> s(const Vec3<double>& w, double eta) {
  const double x = w.x / eta, y = w.y / eta;
  return {x, y, std::sqrt(1 - x * x - y * y)};
}

/// The normal distribution, of standard deviation beta.
double g(double beta, double x) {
  return std::exp(-x * x / (2 * beta * beta)) / (beta * std::sqrt(2 * std::numbers::pi));
}

/// What fibres along u reflect. A smooth fibre is a mirror all around: of light that comes in at
/// psi_l from the plane across it, light goes out at -psi_l to all sides, a cone. psi_h says how
/// far the viewer is from that cone.
double fibres(const Vec3<double>& l, const Vec3<double>& v, const Vec3<double>& u, double eta,
              double beta) {
  const double psi_l = std::asin(dot(s(l, eta), u)), psi_v = std::asin(dot(s(v, eta), u));
  const double psi_h = psi_v + psi_l, psi_d = psi_v - psi_l;
  return g(beta, psi_h) / std::pow(std::cos(psi_d / 2), 2);
}
// end of new idea

/// A board of curly maple: its fibres wave in and out of the surface.
Scene board(double light_x) {
  const std::string trunk = "axis=1/.04/.03,ring=.09,pith=2,towards=0/-.3/-1";
  Scene scene = studio::make_stage({studio::make_object(
      "plane:1", "finished-wood:kd=wood-colour(early=.42/.25/.11,late=.3/.15/.06,streaks=.15," +
                     trunk + "),u=wood-fibre(curl=10,wave=.22," + trunk +
                     "),kf=.075/.05/.026,beta=.15,a=.1")});
  scene.lights = {studio::far_light({light_x, 1, 1}, .9)};
  return scene;
}

int main(int argc, char** argv) {
  studio::Lesson lesson("Finished wood: fibres under a clear coat.", 1740, 1240);
  double tilt = 8, beta = .17, eta = 1.5, light = 30;
  lesson.knob("--tilt", tilt, {0, 30}, "how far fibres come out of the surface, in degrees");
  lesson.knob("--beta", beta, {.05, 1}, "width of the cone, in radians");
  lesson.knob("--eta", eta, {1.05, 3}, "refractive index of the coat");
  lesson.knob("--light", light, {0, 80}, "angle of the light in the plot, in degrees");

  return lesson.run(argc, argv, [&] {
    const int row = lesson.height() / 2;
    std::vector<glm::dvec2> curves[3];
    const Rgb<double> colours[] = {ink::blue, ink::orange, ink::vermilion};
    double highest = 3;
    for (int k = 0; k < 3; ++k) {
      const double t = glm::radians(tilt * (k - 1));
      const Vec3<double> L = studio::direction_at(-light, 0), u{std::cos(t), 0, std::sin(t)};
      for (double theta_v = -90; theta_v <= 90; theta_v += .25)
        curves[k].emplace_back(theta_v, fibres(L, studio::direction_at(theta_v, 0), u, eta, beta));
      highest = std::max(highest, std::ranges::max(curves[k], {}, &glm::dvec2::y).y);
    }
    studio::Chart chart(lesson.width(), lesson.height() - row, {-90, 90, "theta_v, in degrees"},
                        {0, 7 * highest / 6, "g(beta, psi_h) / cos^2(psi_d / 2)"}, lesson.height());
    for (int k = 0; k < 3; ++k) {
      chart.curve(curves[k], colours[k], 12);
      const glm::dvec2 top = std::ranges::max(curves[k], {}, &glm::dvec2::y);
      const std::string name = "tilt " + studio::text_of(tilt * (k - 1));
      const glm::dvec2 above{std::clamp(top.x, -80.0, 80.0), top.y + highest / 12};
      chart.words(above, name, ink::black, Align::centre);
      lesson.figure(name + " degrees, brightest at", studio::fixed(top.x, 1) + " degrees");
    }
    return studio::stacked(
        studio::panels(
            lesson.width(), row, 3, {"light from the left", "from above", "from the right"},
            [&](int panel, int width, int height) {
              return studio::photograph(board(.45 * (panel - 1)), {0, -.8, 3}, width, height);
            },
            ink::slate, lesson.height()),
        chart.finish());
  });
}
