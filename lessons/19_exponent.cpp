// New idea: the exponent n sets the highlight's width, and 4 times the exponent halves it.
// Builds on: lesson 17, the glossy part; lesson 18, N.H.
// Try: --n 1; --n 20; how many steps does the eye tell apart, and where do they crowd?
#include <cmath>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "lessons/studio/drawing/chart.h"
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// How bright the highlight is where N and H enclose alpha.
double highlight(double alpha, double n) { return std::pow(std::cos(alpha), n); }

/// The alpha at which half of that is left: cos^n(alpha) = 1/2.
double half_angle(double n) { return std::acos(std::pow(0.5, 1 / n)); }

/// For large n nearly sqrt(2 ln 2 / n), from cos(alpha) = 1 - alpha^2 / 2: four times the exponent,
/// half the angle.
double half_angle_nearly(double n) { return std::sqrt(2 * std::numbers::ln2 / n); }
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("The exponent n and the highlight's width.", 1800, 1000);
  double first = 5;
  lesson.knob("--n", first, {1, 100}, "the first exponent; each next one is 4 times as large");

  return lesson.run(argc, argv, [&] {
    const int row = lesson.height() * 2 / 5;
    const Rgb<double> colours[] = {ink::blue, ink::sky, ink::orange, ink::vermilion};
    std::vector<std::string> names;
    studio::Chart chart(lesson.width(), lesson.height() - row, {0, 70, "alpha, in degrees"},
                        {0, 1, "(N.H)^n = cos^n alpha"}, lesson.height());
    for (int k = 0; k < 4; ++k) {
      const double n = first * std::pow(4.0, k), half = glm::degrees(half_angle(n));
      names.push_back("n = " + studio::text_of(n));
      std::vector<glm::dvec2> curve;
      for (double degrees = 0; degrees <= 70; degrees += .25)
        curve.emplace_back(degrees, highlight(glm::radians(degrees), n));
      chart.curve(curve, colours[k]);
      chart.dot({half, .5}, colours[k], 16);
      const double beside = glm::degrees(std::acos(std::pow(.05, 1 / n))) + .7;
      if (beside < 62) chart.words({beside, .06}, names.back(), ink::black);
      lesson.figure(names.back() + ", half as bright at",
                    studio::fixed(half, 2) + " degrees, nearly " +
                        studio::fixed(glm::degrees(half_angle_nearly(n)), 2));
    }
    const auto teapot = [&](int panel, int width, int height) {
      const std::string n = studio::text_of(first * std::pow(4.0, panel));
      const Scene scene = studio::make_stage(
          {studio::make_object("teapot:32", "blinn-phong:kd=.10/.015/.02,ks=.7,n=" + n)});
      return studio::photograph(scene, {1, 2, 5}, width, height);
    };
    return studio::stacked(
        studio::panels(lesson.width(), row, 4, names, teapot, ink::slate, lesson.height()),
        chart.finish());
  });
}
