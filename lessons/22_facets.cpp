// New idea: a rough surface is many small mirrors, and D says how many of them face H.
// Builds on: lesson 19, where the highlight's width was a number without a meaning.
// Try: --m .05,.4,1; from which m on do you not see a highlight any more?
#include <cmath>
#include <numbers>
#include <random>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "rasterizer/formula_model.h"

using namespace scanlit;
namespace ink = studio::ink;
using std::numbers::pi;

// new idea
/// Torrance and Sparrow's Gaussian: alpha is the angle of N and H, m says how rough the surface is.
template <class T>
T D(const T& alpha, double m) {
  return exp(-(alpha * alpha) * T(1 / (m * m)));
}

/// The k with which k D is a density of facets, in 1/sr. Seen from above, they cover the surface:
/// the integral of k D cos(alpha) over the hemisphere is 1.
double k(double m) {
  double integral = 0, step = pi / 2 / 10000;
  for (double alpha = step / 2; alpha < pi / 2; alpha += step)
    integral += D(alpha, m) * std::cos(alpha) * 2 * pi * std::sin(alpha) * step;
  return 1 / integral;
}

/// As bright as facets are many that mirror the light to the viewer: those that face H.
struct Facets {
  double m;
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    const Rgb<double> gold(.88, .62, .28);
    return {.diffuse = gold * (T(.12) * c.n_l), .glossy = gold * D(angle(c.n_h), m)};
  }
};
// end of new idea

/// A cut through such a surface, and above it D as a lobe: how long it is in the direction of
/// alpha.
Framebuffer cut(double m, int width, int height) {
  studio::Canvas canvas(width, height, {100, 80});
  std::vector<glm::dvec2> lobe, surface{{0, 60}};
  for (double alpha = -pi / 2; alpha <= pi / 2; alpha += pi / 360)
    lobe.push_back(glm::dvec2(50, 50) +
                   44 * D(alpha, m) * glm::dvec2(std::sin(alpha), -std::cos(alpha)));
  canvas.polygon(lobe, ink::sky);
  std::mt19937 random(2);
  std::normal_distribution<double> slope(0, m / std::numbers::sqrt2);  // m: sqrt(2) rms slopes
  while (surface.back().x < 100) {
    const glm::dvec2 a = surface.back(), b = a + glm::dvec2(1.8, 1.8 * slope(random));
    canvas.polygon({a, b, {b.x, 90}, {a.x, 90}}, ink::grid);
    surface.push_back(b);
  }
  canvas.polyline(surface, ink::black, 8);
  canvas.arrow({50, 50}, {50, 2}, ink::black, 8);
  return canvas.finish();
}

int main(int argc, char** argv) {
  studio::Lesson lesson("D, the distribution of facets, and its roughness m.", 1740, 1060);
  std::string list = ".1,.25,.5";
  lesson.knob("--m", list, "three values of m");

  return lesson.run(argc, argv, [&] {
    const glm::dvec3 m = studio::parse_vector("--m", list);
    std::vector<std::string> captions(6);
    for (int i = 0; i < 6; ++i) {
      captions[i] = "m = " + studio::text_of(studio::in_range("--m", m[i % 3], {.01, 1}));
      if (i < 3) lesson.figure(captions[i] + ", k in 1/sr", studio::fixed(k(m[i]), 3));
    }
    return studio::panels(
        lesson.width(), lesson.height(), 3, captions, [&](int panel, int width, int height) {
          if (panel < 3) return cut(m[panel], width, height);
          const auto facets = std::make_shared<const FormulaModel<Facets>>(Facets{m[panel - 3]});
          const Scene scene = studio::make_stage({studio::make_object("teapot:32", facets)});
          return studio::photograph(scene, {1, 2.2, 5}, width, height);
        });
  });
}
