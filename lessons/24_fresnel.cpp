// New idea: F, the share that a facet mirrors, grows to 1 towards grazing light, whatever it is of.
// Builds on: lesson 22, facets that mirror.
// Try: --eta 1.33; --metal aluminium; at which angle is p-polarised light not mirrored at all?
#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/trigonometric.hpp>

#include "lessons/studio/drawing/chart.h"
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "models/fresnel.h"
#include "models/metals.h"
#include "rasterizer/formula_model.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// Fresnel's equations. c = V.H is the cosine of the angle of incidence; eta is the index of
/// refraction, with the absorption of a metal as its imaginary part: n + i k.
struct Fresnel {
  double s, p;  // light that swings across the plane of incidence, and within it

  Fresnel(double c, std::complex<double> eta) {
    const auto q = std::sqrt(eta * eta - 1.0 + c * c);  // eta times the refracted cosine
    s = std::norm((c - q) / (c + q));
    p = std::norm((eta * eta * c - q) / (eta * eta * c + q));
  }
  double F() const { return (s + p) / 2; }  // light that swings in all directions alike
};

/// Schlick's approximation, from F at normal incidence alone.
double schlick(double c, double f0) { return f0 + (1 - f0) * std::pow(1 - c, 5); }
// end of new idea

/// A smooth object under a white sky shows of it at every point the share F(N.V).
struct UnderTheSky {
  double n, k;

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    return {.diffuse = {}, .glossy = Rgb<T>(models::conductor_reflectance(c.n_v, T(n), T(k)))};
  }
};

int main(int argc, char** argv) {
  studio::Lesson lesson("F, Fresnel's reflectance, of glass and of a metal.", 1640, 1180);
  double eta = 1.5, nm = 589;
  std::string name = "iron";
  lesson.knob("--eta", eta, {1.01, 20}, "index of refraction of the glass");
  lesson.knob("--metal", name, "the metal: aluminium, copper, gold, ...");
  lesson.knob("--nm", nm, {380, 780}, "wavelength at which it is seen");

  return lesson.run(argc, argv, [&] {
    const models::OpticalConstants metal = models::find_metal(name).at(nm);
    const std::complex<double> indices[] = {eta, {metal.n, metal.k}};
    const std::string names[] = {"glass", name};

    const auto chart = [&](int material, int width, int height) {
      studio::Chart sheet(width, height, {0, 90, "angle of incidence, in degrees"}, {0, 1, "F"},
                          lesson.height());
      std::vector<glm::dvec2> s, p, F;
      double lost = 0, f0 = Fresnel(1, indices[material]).F();
      for (double degrees = 0; degrees <= 90; degrees += .5) {
        const double c = std::cos(glm::radians(degrees));
        const Fresnel fresnel(c, indices[material]);
        s.emplace_back(degrees, fresnel.s), p.emplace_back(degrees, fresnel.p);
        F.emplace_back(degrees, fresnel.F());
        lost = std::max(lost, std::abs(schlick(c, f0) - fresnel.F()));
        if (int(2 * degrees) % 6 == 0) sheet.dot({degrees, schlick(c, f0)}, ink::black, 8);
      }
      sheet.curve(s, ink::sky), sheet.curve(p, ink::vermilion), sheet.curve(F, ink::black, 9);
      sheet.words(s[130] + glm::dvec2(-4, .04), "s", ink::black);
      sheet.words(p[160] + glm::dvec2(2.5, -.04), "p", ink::black);
      lesson.figure(names[material] + ", F at 0 degrees", studio::fixed(f0, 3));
      lesson.figure(names[material] + ", Schlick is off by up to", studio::fixed(lost, 3));
      return sheet.finish();
    };
    const auto teapot = [&](int material, int width, int height) {
      const UnderTheSky model{indices[material].real(), indices[material].imag()};
      Scene scene = studio::make_stage({studio::make_object(
          "teapot:32", std::make_shared<const FormulaModel<UnderTheSky>>(model))});
      const Camera camera{.eye = {1, 2, 5}, .projection = Projection::orthographic};
      scene.lights = {studio::far_light(camera.eye, 1)};
      return studio::photograph(scene, studio::fitted(camera, scene, double(width) / height), width,
                                height);
    };
    return studio::panels(
        lesson.width(), lesson.height(), 2,
        {"glass: s, p, their mean F; dots: Schlick", name + ": s, p, F; dots: Schlick",
         "smooth glass under a white sky", "smooth " + name + " under a white sky"},
        [&](int panel, int width, int height) {
          return panel < 2 ? chart(panel, width, height) : teapot(panel - 2, width, height);
        });
  });
}
