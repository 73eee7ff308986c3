// Every model of the registry is held to what all of them promise, and to what its own description
// claims: reciprocity, a bound on energy. What it does not claim must be seen to be violated.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/unit/model_queries.h"

namespace scanlit {
namespace {

using namespace test;

using models::ModelInfo;

TEST(Models, FiniteAndNotNegativeEverywhere) {
  const std::vector<Pair> pairs = direction_pairs(100000, 2);
  Span span = span_of(pairs);
  const auto good = [](const auto& values) {
    return std::all_of(values.begin(), values.end(),
                       [](auto x) { return std::isfinite(x) && x >= 0; });
  };
  for (const ModelInfo& info : models::list())
    for (const std::string& specification : specifications(info)) {
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
      if (a + b > 0) largest = std::max(largest, std::abs(a - b) / std::max(a, b));
    }
  }
  return largest;
}

TEST(Models, ReciprocalIfTheyClaimItAndOnlyThen) {
  for (const ModelInfo& info : models::list()) {
    if (!info.reciprocal)
      EXPECT_GT(largest_asymmetry(*models::make(info.name).model), 1e-3) << info.name;
    else
      for (const std::string& specification : specifications(info))
        EXPECT_LT(largest_asymmetry(*models::make(specification).model), 1e-9) << specification;
  }
}

/// The share of light from direction v that is reflected: the integral of f_r (n.l) over the
/// hemisphere, by the midpoint rule; the largest of the channels.
double directional_albedo(const ReflectionModel& model, const glm::dvec3& v) {
  constexpr int rows = 100, columns = 200;
  std::array<double, 3> sum{};
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const auto value =
          in_double(model, at((i + 0.5) / rows, 2 * std::numbers::pi * (j + 0.5) / columns), v);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += value[c] + value[3 + c];
    }
  // Equal steps of cos(theta) are equal solid angles, 2 pi / (rows * columns); a model returns pi
  // f.
  return *std::max_element(sum.begin(), sum.end()) * 2 / (rows * columns);
}

double largest_albedo(const ReflectionModel& model) {
  double largest = 0;
  for (const double theta_deg : {0, 30, 60, 80, 88})
    largest = std::max(
        largest, directional_albedo(model, at(std::cos(theta_deg * std::numbers::pi / 180), 0.3)));
  return largest;
}

TEST(Models, BoundedInEnergyIfTheyClaimItAndOnlyThen) {
  for (const ModelInfo& info : models::list()) {
    double largest = 0;
    for (const std::string& specification : specifications(info))
      largest = std::max(largest, largest_albedo(*models::make(specification).model));
    if (info.energy_bounded)
      EXPECT_LE(largest, 1 + 1e-3) << info.name;
    else
      EXPECT_GT(largest, 1 + 1e-2) << info.name;
  }
}

TEST(Models, LambertsAlbedoIsKd) {
  const auto model = models::make("lambert:kd=.7").model;
  for (const double cos_theta : {1.0, 0.5, 0.05})
    EXPECT_NEAR(directional_albedo(*model, at(cos_theta, 1)), 0.7, 1e-9);
}

TEST(Models, IsotropicUnlessTheyAskForTangents) {
  std::mt19937 random(4);
  for (const ModelInfo& info : models::list()) {
    const auto model = models::make(info.name).model;
    if (model->needs().frame) continue;
    for (int round = 0; round < 1000; ++round) {
      const glm::dvec3 l = direction(random), v = direction(random);
      const double turn = 0.01 * round, c = std::cos(turn), s = std::sin(turn);
      const auto turned = [&](const glm::dvec3& d) {
        return glm::dvec3(c * d.x - s * d.y, s * d.x + c * d.y, d.z);
      };
      const auto one = in_double(*model, l, v), other = in_double(*model, turned(l), turned(v));
      for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(one[k], other[k], 1e-12) << info.name;
    }
  }
}

TEST(Models, AreTheSameForEveryOrientationOfTheSurface) {
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
    for (const int which : {Span::position, Span::texcoord})
      local.put(i, which, world.get(i, which));
  }
  for (const ModelInfo& info : models::list()) {
    const auto model = models::make(info.name).model;
    const auto in_world = world.evaluate(*model), in_frame = local.evaluate(*model);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t c = 0; c < 6; ++c)
        EXPECT_NEAR(in_world[i][c], in_frame[i][c], 1e-4) << info.name;
  }
}

TEST(Models, APointsValueDoesNotDependOnTheSpanItIsIn) {
  const std::vector<Pair> pairs = direction_pairs(40, 6);
  for (const ModelInfo& info : models::list()) {
    const auto model = models::make(info.name).model;
    const auto whole = span_of(pairs).evaluate(*model);
    for (std::size_t first = 0; first < 3; ++first)
      for (std::size_t size = 1; first + size <= 40; ++size) {
        const auto begin = pairs.begin() + std::ptrdiff_t(first);
        const auto part = span_of({begin, begin + std::ptrdiff_t(size)}).evaluate(*model);
        for (std::size_t i = 0; i < size; ++i)
          EXPECT_EQ(part[i], whole[first + i]) << info.name << ": " << i << " of " << size;
      }
  }
}

}  // namespace
}  // namespace scanlit
