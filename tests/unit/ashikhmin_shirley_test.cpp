// Ashikhmin-Shirley against the paper's formulas written down with angles.
#include <cmath>
#include <numbers>

#include "models/albedo.h"
#include "tests/unit/model_queries.h"

namespace scanlit {
namespace {

using namespace test;
using std::numbers::pi;

struct Parameters {
  double rd, rs, nu, nv;

  std::string specification() const {
    return "ashikhmin-shirley:rd=" + text(rd) + ",rs=" + text(rs) + ",nu=" + text(nu) +
           ",nv=" + text(nv);
  }
};

double fresnel(double rs, double cosine) { return rs + (1 - rs) * std::pow(1 - cosine, 5); }

double diffuse(const Parameters& p, const glm::dvec3& l, const glm::dvec3& v) {
  const double f = 28 * p.rd / (23 * pi) * (1 - p.rs) * (1 - std::pow(1 - l.z / 2, 5)) *
                   (1 - std::pow(1 - v.z / 2, 5));
  return pi * f * l.z;
}

double glossy(const Parameters& p, const glm::dvec3& l, const glm::dvec3& v) {
  const glm::dvec3 h = glm::normalize(l + v);
  const double phi = std::atan2(h.y, h.x), v_h = glm::dot(v, h);
  const double e = p.nu * std::pow(std::cos(phi), 2) + p.nv * std::pow(std::sin(phi), 2);
  const double f = std::sqrt((p.nu + 1) * (p.nv + 1)) / (8 * pi) * std::pow(h.z, e) *
                   fresnel(p.rs, v_h) / (v_h * std::max(l.z, v.z));
  return pi * f * l.z;
}

TEST(AshikhminShirley, IsThePapersFormula) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 20000; ++round) {
    const Parameters p{unit(random), unit(random), std::pow(10, 4 * unit(random)),
                       std::pow(10, 4 * unit(random))};
    glm::dvec3 l = direction(random), v = direction(random);
    l.z = std::abs(l.z), v.z = std::abs(v.z);
    if (std::min(l.z, v.z) < min_n_v) continue;
    const auto value = in_double(*models::make(p.specification()).model, l, v);
    EXPECT_NEAR(value[0], diffuse(p, l, v), 1e-12);
    const double expected = glossy(p, l, v);
    EXPECT_NEAR(value[3], expected, 1e-9 * std::max(1.0, expected)) << p.specification();
  }
}

TEST(AshikhminShirley, WhereHIsTheNormalThePowerIsOne) {
  for (const double exponent : {0.0, 10.0, 1e5})
    for (const double cosine : {1.0, 0.6, 0.01}) {
      const Parameters p{0.5, 0.3, exponent, 2 * exponent / 3};
      const glm::dvec3 l = at(cosine, 1), v(-l.x, -l.y, l.z);
      const double expected =
          std::sqrt((p.nu + 1) * (p.nv + 1)) / 8 * fresnel(p.rs, cosine) / cosine;
      EXPECT_NEAR(in_double(*models::make(p.specification()).model, l, v)[3], expected,
                  1e-9 * expected);
    }
}

TEST(AshikhminShirley, TheSmallerExponentDrawsTheHighlightOut) {
  const auto model = models::make("ashikhmin-shirley:rd=0,rs=1,nu=10,nv=1000").model;
  const glm::dvec3 n(0, 0, 1);
  EXPECT_GT(in_double(*model, at(0.9, 0), n)[3], 100 * in_double(*model, at(0.9, pi / 2), n)[3]);
}

TEST(AshikhminShirley, ReflectsAtMostWhatItGets) {
  double largest = 0;
  for (const double rs : {0.05, 1.0})
    for (const double nu : {0.0, 300.0})
      for (const double nv : {0.0, 10.0, 1e5})
        for (const double theta_deg : {0.0, 60.0, 89.0}) {
          const auto model = models::make(Parameters{1, rs, nu, nv}.specification()).model;
          const glm::dvec3 v = at(std::cos(theta_deg * pi / 180), 0.3);
          const auto albedo = models::directional_albedo(*model, {v.x, v.y, v.z}, 1e-3, 100000);
          largest = std::max(largest, albedo.value.r - albedo.error.r);
        }
  EXPECT_LE(largest, 1 + 1e-6);
  EXPECT_GE(largest, 0.99) << "a smooth white mirror loses nothing";
}

}  // namespace
}  // namespace scanlit
