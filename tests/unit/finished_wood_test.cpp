// Finished wood, against the paper's equations written out plainly.
#include "models/finished_wood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tests/unit/model_queries.h"

namespace scanlit {
namespace {

using namespace test;

using std::numbers::pi;

/// Fresnel's transmittance by the form that Cook and Torrance print.
double transmittance(double c, double eta) {
  const double g = std::sqrt(eta * eta + c * c - 1);
  const double a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
  return 1 - 0.5 * a * a * (1 + b * b);
}

glm::dvec3 refracted(const glm::dvec3& w, double eta) {
  const double x = w.x / eta, y = w.y / eta;
  return {x, y, std::sqrt(1 - x * x - y * y)};
}

/// The angle from the plane across the fibre, inside the coat.
double psi(const glm::dvec3& w, const glm::dvec3& u, double eta) {
  return std::asin(std::clamp(glm::dot(refracted(w, eta), u), -1.0, 1.0));
}

/// pi (n.l) T T g / cos^2(psi_d / 2): the fibres' part for kf = 1.
double fibre_part(const glm::dvec3& l, const glm::dvec3& v, const glm::dvec3& u, double beta,
                  double eta) {
  const double psi_l = psi(l, u, eta), psi_v = psi(v, u, eta);
  const double psi_h = psi_v + psi_l, psi_d = psi_v - psi_l;
  const double g = std::exp(-psi_h * psi_h / (2 * beta * beta)) / (beta * std::sqrt(2 * pi));
  return pi * l.z * transmittance(l.z, eta) * transmittance(v.z, eta) * g /
         std::pow(std::cos(psi_d / 2), 2);
}

models::FinishedWood<> wood(const glm::dvec3& u, double beta, double eta) {
  models::FinishedWood<> formula;
  formula.kd = Rgb<double>(0.5), formula.kf = Rgb<double>(1.0), formula.ks = Rgb<double>(0.0);
  formula.u = {u.x, u.y, u.z}, formula.beta = beta, formula.eta = eta;
  return formula;
}

glm::dvec3 above(std::mt19937& random) {
  glm::dvec3 d = direction(random);
  d.z = std::max(std::abs(d.z), 1e-3);  // the model clamps a viewer below min_n_v
  return glm::normalize(d);
}

TEST(FinishedWood, IsThePapersEquations) {
  std::mt19937 random(1);
  for (int round = 0; round < 20000; ++round) {
    const glm::dvec3 l = above(random), v = above(random), u = direction(random);
    const double beta = 0.05 + 0.9 * (round % 10) / 10, eta = 1.05 + 1.9 * (round % 7) / 7;
    const FormulaModel model(wood(u, beta, eta));
    const auto value = in_double(model, l, v);
    const double expected = fibre_part(l, v, u, beta, eta);
    ASSERT_NEAR(value[3], expected, 1e-9 * expected + 1e-12) << beta << ' ' << eta;
    const double t = transmittance(l.z, eta) * transmittance(v.z, eta);
    ASSERT_NEAR(value[0], 0.5 * l.z * t, 1e-12);
  }
}

TEST(FinishedWood, TheHighlightLiesOnTheConePsiVIsMinusPsiL) {
  const double beta = 0.05, eta = 1.5;
  for (const double tilt : {-0.05, 0.0, 0.05})
    for (const double theta_l : {-0.4, 0.0, 0.4})
      for (const double phi_v : {0.0, 0.4}) {
        const glm::dvec3 u(std::cos(tilt), 0, std::sin(tilt)),
            l(std::sin(theta_l), 0, std::cos(theta_l));
        const FormulaModel model(wood(u, beta, eta));
        double psi_best = 0, brightest = 0;
        for (double theta_v = -1.5; theta_v < 1.5; theta_v += 1e-3) {
          const glm::dvec3 v(std::sin(theta_v) * std::cos(phi_v),
                             std::sin(theta_v) * std::sin(phi_v), std::cos(theta_v));
          // What varies slowly is divided off, so that the Gaussian alone decides.
          const double half_d = (psi(v, u, eta) - psi(l, u, eta)) / 2;
          const double value =
              in_double(model, l, v)[3] * std::pow(std::cos(half_d), 2) / transmittance(v.z, eta);
          if (value > brightest) brightest = value, psi_best = psi(v, u, eta);
        }
        EXPECT_NEAR(psi_best, -psi(l, u, eta), 1e-3) << tilt << ' ' << theta_l << ' ' << phi_v;
      }
}

TEST(FinishedWood, AFibresConeIsAsBrightAllRound) {
  // Fibre along x, light in the plane across it: so is the whole highlight, whatever the azimuth.
  const FormulaModel model(wood({1, 0, 0}, 0.17, 1.5));
  const glm::dvec3 l(0, std::sin(0.4), std::cos(0.4));
  for (const double theta : {-1.0, -0.3, 0.2, 0.9}) {
    const glm::dvec3 v(0, std::sin(theta), std::cos(theta));
    const double t = transmittance(l.z, 1.5) * transmittance(v.z, 1.5);
    EXPECT_NEAR(in_double(model, l, v)[3], std::sqrt(pi / 2) / 0.17 * l.z * t, 1e-12);
  }
}

TEST(FinishedWood, TheCoatIsTheMicrofacetTerm) {
  const auto wood = models::make("finished-wood:kd=0,kf=0,ks=.7,a=.2,eta=1.4").model;
  const auto facets =
      models::make("torrance-sparrow:kd=0,ks=.7,D=ggx,a=.2,G=smith-correlated,F=dielectric,eta=1.4")
          .model;
  std::mt19937 random(3);
  for (int round = 0; round < 1000; ++round) {
    const glm::dvec3 l = above(random), v = above(random);
    const double expected = in_double(*facets, l, v)[3];
    EXPECT_NEAR(in_double(*wood, l, v)[3], expected, 1e-12 * (1 + expected));
  }
}

TEST(FinishedWood, FloatAgreesWhereTheLightRunsAlongTheFibre) {
  // s(L).u = 1 - a few roundings: an arc sine there would be off by 1e-3.
  std::mt19937 random(2);
  for (int round = 0; round < 2000; ++round) {
    const glm::dvec3 l = above(random);
    const glm::dvec3 off = direction(random) * std::pow(10.0, -1 - round % 7);
    const glm::dvec3 u = glm::normalize(refracted(l, 1.5) + off);
    const FormulaModel model(wood(u, 0.05, 1.5));
    const glm::dvec3 v = above(random);
    const double peak = 2 * pi / (0.05 * std::sqrt(2 * pi));
    EXPECT_NEAR(in_float(model, l, v)[3], in_double(model, l, v)[3], 2e-5 * peak);
  }
}

}  // namespace
}  // namespace scanlit
