// The directional albedo against closed forms, and its error estimate against the true error.
#include "models/albedo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "models/registry.h"
#include "rasterizer/formula_model.h"

namespace scanlit {
namespace {

using models::Albedo;
using std::numbers::pi;

Vec3<double> direction(double theta_deg, double phi_deg = 53) {
  const double theta = theta_deg * pi / 180, phi = phi_deg * pi / 180;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Albedo albedo(const std::string& specification, double theta_deg, double tolerance) {
  return models::directional_albedo(*models::make(specification).model, direction(theta_deg),
                                    tolerance);
}

/// The value, the error it admits (beyond rounding) and the error it was asked for.
void expect_albedo(const Albedo& albedo, double expected, double tolerance,
                   const std::string& what) {
  EXPECT_NEAR(albedo.value.r, expected, tolerance) << what;
  EXPECT_LE(std::abs(albedo.value.r - expected), albedo.error.r + 1e-14) << what;
  EXPECT_LE(albedo.error.r, tolerance) << what;
}

const double all_angles_deg[] = {0, 30, 60, 75, 85, 89};

TEST(Albedo, OfADiffuserIsItsReflectanceAtEveryAngle) {
  for (const double theta_deg : all_angles_deg) {
    const Albedo colour = albedo("lambert:kd=.8/.5/.2", theta_deg, 1e-9);
    expect_albedo(colour, 0.8, 1e-9, std::to_string(theta_deg));
    EXPECT_NEAR(colour.value.g, 0.5, 1e-9);
    EXPECT_NEAR(colour.value.b, 0.2, 1e-9);
  }
}

TEST(Albedo, OfTheLecturesLobesAtNormalIncidence) {
  for (const double n : {0.0, 1.0, 10.0, 1e3, 1e5}) {
    const std::string power = ":kd=0,ks=1,n=" + std::to_string(n);
    const double phong = 2 / (n + 1);
    const double blinn_phong = 8 * (1 - std::exp2(-(n + 2) / 2)) / (n + 2);
    expect_albedo(albedo("phong" + power, 0, 1e-7 * phong), phong, 1e-7 * phong, power);
    expect_albedo(albedo("blinn-phong" + power, 0, 1e-7 * blinn_phong), blinn_phong,
                  1e-7 * blinn_phong, power);
  }
}

TEST(Albedo, OfALobeThatTheHorizonDoesNotCut) {
  for (const double theta_deg : {30.0, 60.0, 75.0, 85.0})
    expect_albedo(albedo("phong:kd=0,ks=1,n=100000", theta_deg, 1e-11), 2 / 100001.0, 1e-11,
                  std::to_string(theta_deg));
  // At 89 degrees the lobe's far tail is: by the normal distribution's, 1.7e-8 of it.
  expect_albedo(albedo("phong:kd=0,ks=1,n=100000", 89, 1e-11), 2 / 100001.0 * (1 - 1.7e-8), 1e-11,
                "89");
}

// A mirror that sends light back where it came from: a lobe far from the normal's half vector.
struct RetroReflector {
  double n = 1e5;
  template <class T>
  Reflection<T> operator()(const Cosines<T>&, const ShadingFrame<T>& f) const {
    const Vec3<T> d = f.l - f.v;
    const T value = pow(Cosine<T>::of_versine(T(0.5) * dot(d, d)), T(n));
    return {.diffuse = {}, .glossy = Rgb<T>(value)};
  }
};

TEST(Albedo, OfALobeThatIsNotWhereTheMirrorDirectionIs) {
  const FormulaModel<RetroReflector> model{RetroReflector{}};
  for (const double theta_deg : {0.0, 30.0, 60.0, 75.0, 85.0})
    for (const double phi_deg : {0.0, 53.0, 180.0, 250.0})
      expect_albedo(models::directional_albedo(model, direction(theta_deg, phi_deg), 1e-11),
                    2 / 100001.0, 1e-11, std::to_string(theta_deg));
}

// A Beckmann distribution without masking, as f_r (n.l) = D / (4 n.v): at normal incidence the half
// vectors within 45 degrees reflect above the horizon, and 1 - exp(-tan^2(45) / m^2) are.
// Anisotropic, in a plane through n the widths differ, and at m = .001, .5 the lobe is a thin line.
struct Beckmann {
  double mx, my;
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    const T x = f.h.x / (T(mx) * f.h.z), y = f.h.y / (T(my) * f.h.z), cos2 = f.h.z * f.h.z;
    const T d = exp(-(x * x + y * y)) / (T(pi * mx * my) * cos2 * cos2);
    return {.diffuse = {}, .glossy = Rgb<T>(T(pi) * d / (T(4) * c.n_v))};
  }
};

// The share of slopes below 1 of a Gaussian with widths mx and my: what 45 degrees let through.
double slopes_below_1(double mx, double my) {
  constexpr int steps = 4000;  // the integrand is periodic: the trapezoidal rule is exact
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double phi = 2 * pi * i / steps, cosine = std::cos(phi), sine = std::sin(phi);
    const double a = cosine * cosine / (mx * mx) + sine * sine / (my * my);
    sum += (1 - std::exp(-a)) / a;
  }
  return sum / steps / (mx * my);
}

TEST(Albedo, OfMicrofacetsBroadSharpAndBrushed) {
  for (const auto& [mx, my] : {std::pair{0.5, 0.5}, {0.2, 0.2}, {0.001, 0.001}, {0.01, 0.5}}) {
    const FormulaModel<Beckmann> model(Beckmann{mx, my});
    expect_albedo(models::directional_albedo(model, {0, 0, 1}, 1e-7), slopes_below_1(mx, my), 1e-7,
                  std::to_string(mx));
  }
}

TEST(Albedo, OfAThinMirrorNearGrazing) {
  // No masking, m = .001, n.v = cos 85: as good as all slopes count, and their mean is 0.
  const FormulaModel<Beckmann> model(Beckmann{0.001, 0.001});
  expect_albedo(models::directional_albedo(model, direction(85), 1e-5), 1, 1e-5, "85");
}

TEST(Albedo, StopsAtItsLimitAndAdmitsTheError) {
  const auto model = models::make("blinn-phong").model;
  const Albedo rough = models::directional_albedo(*model, direction(85), 0, 100'000);
  EXPECT_LE(rough.evaluations, 101'000);
  EXPECT_GT(rough.error.r, 0);
}

TEST(Albedo, BelowTheHorizonIsZero) {
  EXPECT_EQ(albedo("lambert", 90.1, 1e-6).value, Rgb<double>(0.0));
  EXPECT_EQ(albedo("lambert", 180, 1e-6).value, Rgb<double>(0.0));
  EXPECT_TRUE(std::isfinite(albedo("phong", 89.99999, 1e-6).value.r));
}

}  // namespace
}  // namespace scanlit
