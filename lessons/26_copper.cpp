// New idea: a metal's colour is its reflectance over the whole spectrum; it changes with the angle.
// Builds on: lesson 24, Fresnel's equations for one wavelength.
// Try: --metal gold; --metal aluminium: which loses most by Schlick's approximation, and where?
#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "lessons/studio/drawing/chart.h"
#include "lessons/studio/drawing/landscape.h"
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/lesson.h"
#include "models/metals.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// What the eye makes of light that a metal has mirrored: the reflectance of every wavelength,
/// summed up as the eye's three kinds of receptors do it.
struct MirroredWhite {
  const models::Metal& metal;

  double F(double nm, double degrees) const {
    return models::reflectance(metal, nm, std::cos(glm::radians(degrees)));
  }
  /// Schlick's: from F at normal incidence alone.
  double schlick(double nm, double degrees) const {
    const double f0 = F(nm, 0), c = std::cos(glm::radians(degrees));
    return f0 + (1 - f0) * std::pow(1 - c, 5);
  }
  Rgb<double> colour(double degrees) const {
    return models::linear_srgb([&](double nm) { return F(nm, degrees); });
  }
  Rgb<double> schlick_colour(double degrees) const {
    return models::linear_srgb([&](double nm) { return schlick(nm, degrees); });
  }
};
// end of new idea

/// Light of about this wavelength, as strong as a screen can show it.
Rgb<double> spectral(double nm) {
  const Rgb<double> c =
      models::linear_srgb([&](double other) { return std::exp(-std::pow((other - nm) / 25, 2)); });
  const Rgb<double> positive(std::max(c.r, 0.), std::max(c.g, 0.), std::max(c.b, 0.));
  return positive * (.6 / std::max({positive.r, positive.g, positive.b})) + Rgb<double>(.2);
}

int main(int argc, char** argv) {
  studio::Lesson lesson("A metal's reflectance over wavelength and angle.", 1740, 1240);
  std::string name = "copper";
  lesson.knob("--metal", name, "the metal");

  return lesson.run(argc, argv, [&] {
    const MirroredWhite metal{models::find_metal(name)};
    const auto landscape = [&](bool lost, int width, int height) {
      const studio::Landscape land{
          .x = {400, 700, "wavelength, nm"},
          .y = {0, 90, "angle"},
          .z = lost ? studio::ChartAxis{-.02, .06, "Schlick - F"} : studio::ChartAxis{0, 1, "F"},
          .height =
              [&](double nm, double degrees) {
                return lost ? metal.schlick(nm, degrees) - metal.F(nm, degrees)
                            : metal.F(nm, degrees);
              },
          .colour = [&](double nm, double) { return spectral(nm); }};
      return studio::draw(land, width, height, lesson.height());
    };
    const auto curves = [&](int width, int height) {
      studio::Chart chart(width, height, {0, 90, "angle of incidence, in degrees"}, {0, 1, "F"},
                          lesson.height());
      for (const double nm : {450., 550., 650.}) {
        std::vector<glm::dvec2> exact;
        double lost = 0;
        for (double angle = 0; angle <= 90; angle += .5) {
          exact.emplace_back(angle, metal.F(nm, angle));
          lost = std::max(lost, std::abs(metal.schlick(nm, angle) - exact.back().y));
          if (std::fmod(angle, 3) == 0) chart.dot({angle, metal.schlick(nm, angle)}, ink::black, 7);
        }
        chart.curve(exact, nm < 500 ? ink::blue : nm < 600 ? ink::green : ink::vermilion);
        lesson.figure(studio::text_of(nm) + " nm, Schlick is off by up to", studio::fixed(lost, 3));
      }
      return chart.finish();
    };
    const auto strips = [&](int width, int height) {
      studio::Canvas canvas(width, height, {90, 90.0 * height / width}, ink::black);
      canvas.letter_for(lesson.height());
      const double row = 30.0 * height / width;
      for (double angle = 0; angle < 90; angle += .25) {
        const Rgb<double> F = metal.colour(angle), schlick = metal.schlick_colour(angle);
        canvas.rectangle({angle, 0}, {angle + .5, row}, F * .95);
        canvas.rectangle({angle, row}, {angle + .5, 2 * row}, schlick * .95);
        canvas.rectangle({angle, 2 * row}, {angle + .5, 3 * row}, (schlick - F) * 10.0);
      }
      canvas.words({2, row - 3}, "Fresnel", ink::black);
      canvas.words({2, 2 * row - 3}, "Schlick", ink::black);
      canvas.words({2, 3 * row - 3}, "10 (Schlick - Fresnel)", ink::white);
      return canvas.finish();
    };
    return studio::panels(
        lesson.width(), lesson.height(), 2,
        {"F of " + name, "what Schlick loses", "at 450, 550 and 650 nm; dots: Schlick",
         "the colour from 0 to 90 degrees"},
        [&](int panel, int width, int height) {
          if (panel < 2) return landscape(panel == 1, width, height);
          return panel == 2 ? curves(width, height) : strips(width, height);
        });
  });
}
