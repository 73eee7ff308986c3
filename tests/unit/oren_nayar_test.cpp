// Oren-Nayar, both forms, against the book's formulas written down with angles.
#include <cmath>
#include <numbers>

#include "models/albedo.h"
#include "tests/unit/model_queries.h"

namespace scanlit {
namespace {

using namespace test;
using std::numbers::pi;

struct Angles {
  double a, b, cos_phi;  // the larger and the smaller polar angle; 0 where phi is undefined

  Angles(const glm::dvec3& l, const glm::dvec3& v) {
    const double theta_l = std::atan2(std::hypot(l.x, l.y), l.z);
    const double theta_v = std::atan2(std::hypot(v.x, v.y), v.z);
    a = std::max(theta_l, theta_v), b = std::min(theta_l, theta_v);
    cos_phi = b > 0 ? std::cos(std::atan2(l.y, l.x) - std::atan2(v.y, v.x)) : 0;
  }
};

/// pi f_r (n.l) as the paper has it.
double qualitative(double rho, double sigma, const glm::dvec3& l, const glm::dvec3& v) {
  const Angles at(l, v);
  const double s2 = sigma * sigma;
  return rho * l.z *
         (1 - 0.5 * s2 / (s2 + 0.33) +
          0.45 * s2 / (s2 + 0.09) * std::max(0.0, at.cos_phi) * std::sin(at.a) * std::tan(at.b));
}

double full(double rho, double sigma, const glm::dvec3& l, const glm::dvec3& v) {
  const Angles at(l, v);
  const double s2 = sigma * sigma, c = at.cos_phi, b = 2 * at.b / pi;
  const double c1 = 1 - 0.5 * s2 / (s2 + 0.33);
  const double c2 = 0.45 * s2 / (s2 + 0.09) * (std::sin(at.a) - (c < 0 ? b * b * b : 0));
  const double c3 = 0.125 * s2 / (s2 + 0.09) * std::pow(4 * at.a * at.b / (pi * pi), 2);
  const double once =
      c1 + c * c2 * std::tan(at.b) + (1 - std::abs(c)) * c3 * std::tan((at.a + at.b) / 2);
  const double twice = 0.17 * s2 / (s2 + 0.13) * (1 - c * b * b);
  return std::max(0.0, l.z * (rho * once + rho * rho * twice));
}

std::shared_ptr<const ReflectionModel> make(const std::string& name, double rho, double sigma) {
  return models::make(name + ":rho=" + text(rho) + ",sigma=" + text(sigma)).model;
}

/// Above the horizon, and the viewer above the clamp.
glm::dvec3 upper(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double z = unit(random) < 0.5 ? unit(random) : std::pow(10, -3 * unit(random));
  return at(std::max(2 * min_n_v, z), 2 * pi * unit(random));
}

TEST(OrenNayar, IsThePapersFormula) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 20000; ++round) {
    const double rho = unit(random), sigma = pi / 2 * unit(random);
    const glm::dvec3 l = upper(random), v = upper(random);
    EXPECT_NEAR(in_double(*make("oren-nayar", rho, sigma), l, v)[0], qualitative(rho, sigma, l, v),
                1e-12);
    EXPECT_NEAR(in_double(*make("oren-nayar-full", rho, sigma), l, v)[0], full(rho, sigma, l, v),
                1e-12);
  }
}

TEST(OrenNayar, WhereTheAzimuthIsUndefined) {
  const glm::dvec3 n(0, 0, 1);
  for (const glm::dvec3& d : {n, at(0.6, 1), at(0.01, 2)}) {
    EXPECT_NEAR(in_double(*make("oren-nayar", 1, 0.5), n, d)[0], qualitative(1, 0.5, n, d), 1e-12);
    EXPECT_NEAR(in_double(*make("oren-nayar-full", 1, 0.5), n, d)[0], full(1, 0.5, n, d), 1e-12);
    EXPECT_NEAR(in_double(*make("oren-nayar-full", 1, 0.5), d, n)[0], full(1, 0.5, d, n), 1e-12);
  }
}

TEST(OrenNayar, FloatAndBatchHoldAtGrazingAndNearTheNormal) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Pair> pairs;
  const auto near_normal = [&] {
    const double tilt = std::pow(10, -6 * unit(random)), phi = 2 * pi * unit(random);
    return glm::normalize(glm::dvec3(tilt * std::cos(phi), tilt * std::sin(phi), 1));
  };
  for (int round = 0; round < 20000; ++round) {
    pairs.push_back({upper(random), upper(random)});
    pairs.push_back({near_normal(), near_normal()});
    pairs.push_back({near_normal(), upper(random)});
  }
  Span span = span_of(pairs);
  for (const char* name : {"oren-nayar", "oren-nayar-full"})
    for (const double sigma : {0.05, 0.4, 1.5}) {
      const auto model = make(name, 1, sigma);
      const auto batch = span.evaluate(*model);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto& [l, v] = pairs[i];
        const double exact = in_double(*model, l, v)[0];
        ASSERT_NEAR(in_float(*model, l, v)[0], exact, 2e-6) << name << ' ' << l.z << ' ' << v.z;
        ASSERT_NEAR(batch[i][0], exact, 2e-6) << name << ' ' << l.z << ' ' << v.z;
      }
    }
}

double albedo(const ReflectionModel& model, double theta_deg) {
  const glm::dvec3 v = at(std::cos(theta_deg * pi / 180), 0);
  return models::directional_albedo(model, {v.x, v.y, v.z}, 1e-5).value.r;
}

TEST(OrenNayar, InAWhiteFurnace) {
  const auto model = make("oren-nayar-full", 1, 40 * pi / 180);
  const double expected[][2] = {{0, 0.8361},  {30, 0.8395}, {60, 0.8713},
                                {75, 0.9088}, {85, 0.9483}, {89, 0.9742}};
  for (const auto& [theta_deg, value] : expected)
    EXPECT_NEAR(albedo(*model, theta_deg), value, 1e-4) << theta_deg;
}

TEST(OrenNayar, ExceedsOneByAsMuchAsItsDescriptionSays) {
  double largest[2] = {};
  for (double sigma = 0; sigma < pi / 2; sigma += 0.05)
    for (const double theta_deg : {0.0, 60.0, 80.0, 89.0, 89.9}) {
      largest[0] = std::max(largest[0], albedo(*make("oren-nayar", 1, sigma), theta_deg));
      largest[1] = std::max(largest[1], albedo(*make("oren-nayar-full", 1, sigma), theta_deg));
    }
  EXPECT_NEAR(largest[0], 1.015, 0.001);
  EXPECT_NEAR(largest[1], 1.05, 0.002);
}

TEST(OrenNayar, SmoothIsLambert) {
  const auto lambert = models::make("lambert:kd=.7").model;
  std::mt19937 random(3);
  for (int round = 0; round < 100; ++round) {
    const glm::dvec3 l = upper(random), v = upper(random);
    for (const char* name : {"oren-nayar", "oren-nayar-full"})
      EXPECT_NEAR(in_double(*make(name, 0.7, 0), l, v)[0], in_double(*lambert, l, v)[0], 1e-15);
  }
}

}  // namespace
}  // namespace scanlit
