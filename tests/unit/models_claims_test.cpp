// Every model of the registry is held to what all of them promise, and to what its own description
// claims: reciprocity, a bound on energy. What it does not claim must be seen to be violated.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/albedo.h"
#include "tests/unit/tested_models.h"

namespace scanlit {
namespace {

using namespace test;

class EveryModel : public testing::TestWithParam<std::string> {
 protected:
  const Tested model_ = tested(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Models, EveryModel, testing::ValuesIn(all_names()), word);

class Analytic : public EveryModel {};
INSTANTIATE_TEST_SUITE_P(Models, Analytic, testing::ValuesIn(analytic_names()), word);

template <class Values>
bool good(const Values& values) {
  return std::all_of(values.begin(), values.end(),
                     [](auto x) { return std::isfinite(x) && x >= 0; });
}

void expect_finite_and_not_negative(const std::string& specification, std::size_t count,
                                    unsigned seed) {
  const std::vector<Pair> pairs = direction_pairs(count, seed);
  Span span = span_of(pairs);
  const auto model = models::make(specification).model;
  const auto batch = span.evaluate(*model);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [l, v] = pairs[i];
    ASSERT_TRUE(good(in_double(*model, l, v)) && good(in_float(*model, l, v)) && good(batch[i]))
        << specification << " at l " << l.x << ' ' << l.y << ' ' << l.z << ", v " << v.x << ' '
        << v.y << ' ' << v.z;
    if (l.z > 0) continue;
    ASSERT_EQ(in_double(*model, l, v), (std::array<double, 6>{})) << specification;
    ASSERT_EQ(batch[i], (std::array<float, 6>{})) << specification;
  }
}

// The sanitizers make everything some 20 times slower.
#ifdef __SANITIZE_ADDRESS__
constexpr unsigned rounds = 2;
#else
constexpr unsigned rounds = 40;
#endif

// A million each of random, grazing, near-mirror and half-grazing pairs of directions.
TEST_P(EveryModel, FiniteAndNotNegativeAtFourMillionDirections) {
  for (unsigned round = 0; round < rounds; ++round)
    expect_finite_and_not_negative(model_.specifications.front(), 100000, 100 + round);
}

TEST_P(EveryModel, FiniteAndNotNegativeForEveryParameter) {
  for (const std::string& specification : model_.specifications)
    expect_finite_and_not_negative(specification, 20000, 2);
}

/// The largest difference between f_r(l, v) and f_r(v, l), of the larger of them.
double largest_asymmetry(const ReflectionModel& model) {
  std::mt19937 random(3);
  double largest = 0;
  for (int round = 0; round < 20000; ++round) {
    glm::dvec3 l = direction(random), v = direction(random);
    l.z = std::abs(l.z), v.z = std::abs(v.z);
    // The engine raises the viewer's cosine to min_n_v, but not the light's.
    if (std::min(l.z, v.z) < min_n_v) continue;
    const auto one = in_double(model, l, v), other = in_double(model, v, l);
    for (std::size_t c = 0; c < 3; ++c) {
      const double a = (one[c] + one[3 + c]) * v.z, b = (other[c] + other[3 + c]) * l.z;
      // Below 1e-200 a lobe's tail is made of subnormal numbers, which have lost their digits.
      if (a + b > 1e-200) largest = std::max(largest, std::abs(a - b) / std::max(a, b));
    }
  }
  return largest;
}

TEST_P(Analytic, ReciprocalIfItClaimsItAndOnlyThen) {
  double largest = 0;
  for (const std::string& specification : model_.specifications) {
    const double asymmetry = largest_asymmetry(*models::make(specification).model);
    if (model_.info.reciprocal) {
      EXPECT_LT(asymmetry, 1e-9) << specification;
    }
    largest = std::max(largest, asymmetry);
  }
  if (!model_.info.reciprocal) {
    EXPECT_GT(largest, 1e-3);
  }
}

double largest_albedo(const ReflectionModel& model) {
  double largest = 0;
  for (const double theta_deg : {0, 30, 60, 80, 88}) {
    const glm::dvec3 v = at(std::cos(theta_deg * std::numbers::pi / 180), 0.3);
    const Rgb<double> albedo = models::directional_albedo(model, {v.x, v.y, v.z}, 1e-4).value;
    largest = std::max({largest, albedo.r, albedo.g, albedo.b});
  }
  return largest;
}

TEST_P(Analytic, BoundedInEnergyIfItClaimsItAndOnlyThen) {
  double largest = 0;
  for (const std::string& specification : model_.specifications) {
    const double albedo = largest_albedo(*models::make(specification).model);
    if (model_.info.energy_bounded) {
      EXPECT_LE(albedo, 1 + 1e-3) << specification;
    }
    largest = std::max(largest, albedo);
  }
  if (!model_.info.energy_bounded) {
    EXPECT_GT(largest, 1 + 1e-2);
  }
}

TEST_P(EveryModel, IsotropicUnlessItAsksForTangents) {
  std::mt19937 random(4);
  for (const std::string& specification : model_.specifications) {
    const auto model = models::make(specification).model;
    if (model->needs().frame) continue;
    for (int round = 0; round < 1000; ++round) {
      const glm::dvec3 l = direction(random), v = direction(random);
      const double turn = 0.01 * round, c = std::cos(turn), s = std::sin(turn);
      const auto turned = [&](const glm::dvec3& d) {
        return glm::dvec3(c * d.x - s * d.y, s * d.x + c * d.y, d.z);
      };
      const auto one = in_double(*model, l, v), other = in_double(*model, turned(l), turned(v));
      for (std::size_t k = 0; k < 6; ++k)
        EXPECT_NEAR(one[k], other[k], 1e-9 * std::max(1.0, one[k])) << specification;
    }
  }
}

TEST_P(EveryModel, TheSameForEveryOrientationOfTheSurface) {
  std::mt19937 random(5);
  constexpr std::size_t size = 1000;
  Span world = random_span(size, random), local(size);
  for (std::size_t i = 0; i < size; ++i) {
    const glm::dvec3 n = world.get(i, Span::normal), t = world.get(i, Span::tangent);
    const glm::dvec3 b = glm::cross(n, t);
    const auto to_local = [&](int which) {
      const glm::dvec3 d = world.get(i, which);
      return glm::dvec3(glm::dot(t, d), glm::dot(b, d), glm::dot(n, d));
    };
    local.put(i, {0, 0, 1}, to_local(Span::to_light), to_local(Span::to_viewer));
    local.put(i, Span::tangent, {1, 0, 0});
    for (const int which : {Span::position, Span::texcoord, Span::colour})
      local.put(i, which, world.get(i, which));
  }
  const auto model = models::make(model_.specifications.front()).model;
  const auto in_world = world.evaluate(*model), in_frame = local.evaluate(*model);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t c = 0; c < 6; ++c)
      // Rounding the directions into the other frame moves a lobe; a table's borders, too.
      EXPECT_NEAR(in_world[i][c], in_frame[i][c],
                  (model_.measured ? 2e-2 : 1e-4) * std::max(1.0f, in_frame[i][c]));
}

TEST_P(EveryModel, APointsValueDoesNotDependOnTheSpanItIsIn) {
  const std::vector<Pair> pairs = direction_pairs(40, 6);
  const auto model = models::make(model_.specifications.front()).model;
  const auto whole = span_of(pairs).evaluate(*model);
  for (std::size_t first = 0; first < 3; ++first)
    for (std::size_t size = 1; first + size <= 40; ++size) {
      const auto begin = pairs.begin() + std::ptrdiff_t(first);
      const auto part = span_of({begin, begin + std::ptrdiff_t(size)}).evaluate(*model);
      for (std::size_t i = 0; i < size; ++i)
        EXPECT_EQ(part[i], whole[first + i]) << i << " of " << size;
    }
}

TEST(Models, LambertsAlbedoIsKd) {
  const auto model = models::make("lambert:kd=.7").model;
  for (const double cos_theta : {1.0, 0.5, 0.05}) {
    const glm::dvec3 v = at(cos_theta, 1);
    EXPECT_NEAR(models::directional_albedo(*model, {v.x, v.y, v.z}, 1e-9).value.r, 0.7, 1e-9);
  }
}

}  // namespace
}  // namespace scanlit
