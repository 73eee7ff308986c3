// Procedural inputs: noise, wood, vertex colours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "models/inputs/lattice_noise.h"
#include "models/inputs/wood.h"
#include "tests/unit/image_files.h"
#include "tests/unit/reflection_span.h"

namespace scanlit {
namespace {

using models::fractal_noise;
using models::gradient_noise;

Vec3<float> random_point(std::mt19937& random, float reach) {
  std::uniform_real_distribution<float> coordinate(-reach, reach);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

float in_batch(const std::function<Batch(const Vec3<Batch>&)>& noise, const Vec3<float>& p) {
  float values[max_lanes];
  noise({Batch(p.x), Batch(p.y), Batch(p.z)}).store(values);
  return values[0];
}

/// An input's channels at points in object space; their x and y are their u and v too.
std::vector<std::array<float, 3>> values_at(const std::string& call,
                                            const std::vector<Vec3<float>>& at,
                                            const Rgb<float>& vertex_colour = Rgb<float>(1.0f)) {
  const auto input = models::make_input(call, {"test", "", 0});
  const std::size_t padded = at.size() + max_lanes;
  std::vector<float> position[3], colour[3], out[3];
  for (int c = 0; c < 3; ++c) position[c].resize(padded), out[c].resize(padded);
  for (std::size_t i = 0; i < at.size(); ++i)
    position[0][i] = at[i].x, position[1][i] = at[i].y, position[2][i] = at[i].z;
  colour[0].assign(padded, vertex_colour.r);
  colour[1].assign(padded, vertex_colour.g);
  colour[2].assign(padded, vertex_colour.b);
  const PointSpan points{
      .size = at.size(),
      .object_position = {position[0].data(), position[1].data(), position[2].data()},
      .texcoord = {position[0].data(), position[1].data()},
      .vertex_colour = {colour[0].data(), colour[1].data(), colour[2].data()}};
  float* const arrays[3] = {out[0].data(), out[1].data(), out[2].data()};
  input->evaluate(points, 3, arrays);
  std::vector<std::array<float, 3>> result;
  for (std::size_t i = 0; i < at.size(); ++i) result.push_back({out[0][i], out[1][i], out[2][i]});
  return result;
}

TEST(Noise, ScalarAndBatchAgree) {
  std::mt19937 random(1);
  for (const float reach : {2.0f, 100.0f, 1e5f})
    for (int round = 0; round < 2000; ++round) {
      const auto p = random_point(random, reach);
      EXPECT_NEAR(in_batch([](const auto& q) { return gradient_noise(q); }, p), gradient_noise(p),
                  2e-6);
      // Its turned coordinates are rounded with and without fusing: that much more, farther out.
      EXPECT_NEAR(in_batch([](const auto& q) { return fractal_noise(q, 3); }, p),
                  fractal_noise(p, 3), 1e-5 * std::max(1.0f, reach));
    }
}

TEST(Noise, StaysInItsRangeAndUsesIt) {
  std::mt19937 random(2);
  for (const int octaves : {1, 4}) {
    double sum = 0, sum2 = 0;
    constexpr int count = 100000;
    for (int round = 0; round < count; ++round) {
      const float value = fractal_noise(random_point(random, 1000), octaves);
      ASSERT_LE(std::abs(value), 1);
      sum += value, sum2 += value * value;
    }
    EXPECT_NEAR(sum / count, 0, 0.01);
    EXPECT_GT(std::sqrt(sum2 / count), 0.2) << "of standard deviation";
    EXPECT_LT(std::sqrt(sum2 / count), 0.5);
  }
}

TEST(Noise, IsSmooth) {
  std::mt19937 random(3);
  for (int round = 0; round < 10000; ++round) {
    auto p = random_point(random, 50);
    if (round % 2) p.x = std::floor(p.x);  // across the faces of cells
    const float step = 1e-3f;
    const auto q = Vec3<float>{p.x - step, p.y, p.z}, r = Vec3<float>{p.x + step, p.y, p.z};
    const float before = gradient_noise(q), here = gradient_noise(p), after = gradient_noise(r);
    EXPECT_LT(std::abs(after - here), 10 * step);
    EXPECT_LT(std::abs(after - 2 * here + before), 60 * step * step + 2e-6) << "no kink";
  }
}

TEST(Noise, HasNoPreferredDirection) {
  // The mean square of differences over a fixed distance, along directions of the lattice and
  // others: two to one apart, one would see the grid.
  std::mt19937 random(4);
  double least = 1e9, most = 0;
  for (const Vec3<float> d : {Vec3<float>{1, 0, 0},
                              {0, 1, 0},
                              {0, 0, 1},
                              {0.7071f, 0.7071f, 0},
                              {0.577f, 0.577f, 0.577f},
                              {0.36f, 0.48f, 0.8f}}) {
    double sum = 0;
    for (int round = 0; round < 20000; ++round) {
      const auto p = random_point(random, 100);
      const float difference = fractal_noise(p + d * 0.5f, 3) - fractal_noise(p, 3);
      sum += difference * difference;
    }
    least = std::min(least, sum), most = std::max(most, sum);
  }
  EXPECT_LT(most / least, 1.25);
}

TEST(Noise, AnyPointIsFinite) {
  const float inf = std::numeric_limits<float>::infinity();
  for (const float x : {0.0f, -0.0f, 1e-40f, 1e6f, -1e9f, 1e38f, inf, -inf, std::nanf("")})
    for (const auto& p : {Vec3<float>{x, 0, 0}, {0.3f, x, -x}, {x, x, x}}) {
      EXPECT_LE(std::abs(gradient_noise(p)), 1) << x;
      EXPECT_LE(std::abs(in_batch([](const auto& q) { return gradient_noise(q); }, p)), 1) << x;
    }
}

TEST(Noise, MixesItsTwoValues) {
  std::mt19937 random(5);
  std::vector<Vec3<float>> at;
  for (int i = 0; i < 250; ++i) at.push_back(random_point(random, 1));
  for (const auto& value : values_at("noise(a=.2/.5/.9,b=.6/.5/.1,scale=.1)", at)) {
    const double share = (value[0] - 0.2) / 0.4;
    EXPECT_TRUE(share > -1e-6 && share < 1 + 1e-6);
    EXPECT_NEAR(value[1], 0.5, 1e-6);
    EXPECT_NEAR(value[2], 0.9 - 0.8 * share, 1e-5);
  }
  // Twice the scale is the same cloud, twice as large.
  std::vector<Vec3<float>> twice;
  for (const auto& p : at) twice.push_back(p * 2.0f);
  const auto one = values_at("noise(scale=.25)", at), other = values_at("noise(scale=.5)", twice);
  for (std::size_t i = 0; i < at.size(); ++i) EXPECT_NEAR(one[i][0], other[i][0], 1e-5);
}

TEST(VertexColour, IsTheMeshesTimesTheTint) {
  EXPECT_EQ(values_at("vertex-colour", {{0, 0, 0}}, {0.25f, 0.5f, 0.75f})[0],
            (std::array<float, 3>{0.25f, 0.5f, 0.75f}));
  EXPECT_EQ(values_at("vertex-colour(tint=.5/1/0)", {{0, 0, 0}}, {0.25f, 0.5f, 0.75f})[0],
            (std::array<float, 3>{0.125f, 0.5f, 0.0f}));
}

TEST(Checker, FieldsChangeAlongBothCoordinates) {
  // Four fields from 0 to 1, so each is a quarter wide; the one at (0, 0) is a's.
  std::vector<Vec3<float>> at;
  for (int row = -4; row < 4; ++row)
    for (int column = -4; column < 4; ++column)
      for (const float within : {0.01f, 0.24f})
        at.push_back({float(column) / 4 + within, float(row) / 4 + within, 0});
  const auto values = values_at("checker(a=.9/.5/.1,b=.2,count=4)", at);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto field = std::lround(std::floor(4 * at[i].x) + std::floor(4 * at[i].y));
    EXPECT_EQ(values[i], (field % 2 == 0 ? std::array<float, 3>{0.9f, 0.5f, 0.1f}
                                         : std::array<float, 3>{0.2f, 0.2f, 0.2f}))
        << at[i].x << ", " << at[i].y;
  }
}

TEST(Wood, ColoursLieBetweenEarlyAndLate) {
  std::mt19937 random(6);
  std::vector<Vec3<float>> at{{0, 0, 0}, {0, -0.6f, 0}};  // and the pith itself
  for (int i = 0; i < 248; ++i) at.push_back(random_point(random, i < 200 ? 1.0f : 1e4f));
  for (const auto& value : values_at("wood-colour(early=.6/.4/.2,late=.2/.1/.05)", at)) {
    const double share = (0.6 - value[0]) / 0.4;
    EXPECT_TRUE(share > -1e-5 && share < 1 + 1e-5) << share;
    EXPECT_NEAR(value[1], 0.4 - 0.3 * share, 1e-5);
  }
  for (const auto& value : values_at("wood-colour(early=.6,late=.6,pores=1)", at))
    EXPECT_TRUE(value[0] >= 0 && value[0] <= 0.6f + 1e-6f);
}

TEST(Wood, RingsAreCirclesAboutThePith) {
  models::Trunk trunk;
  trunk.axis = {0, 1, 0}, trunk.towards = {0.6, 0.5, 0.8};  // only its part across counts
  trunk.pith = 2, trunk.ring = 0.25, trunk.wander = 0;
  const Vec3<float> pith{1.2f, 0, 1.6f};
  for (const float angle : {0.0f, 1.0f, 4.0f}) {
    const Vec3<float> away{std::cos(angle), 0, std::sin(angle)};
    const auto at = trunk(pith + away * 0.75f + Vec3<float>{0, 7, 0});
    EXPECT_NEAR(at.rings, 3, 1e-4);
    EXPECT_NEAR(at.along, 7, 1e-6);
    EXPECT_NEAR(dot(at.radial, away), 1, 1e-5);
  }
  const auto centre = trunk(pith);
  EXPECT_NEAR(centre.rings, 0, 1e-4);
  EXPECT_LE(dot(centre.radial, centre.radial), 1.001f);
}

TEST(Wood, FibresFollowTheAxisWithinTheirAngles) {
  std::mt19937 random(7);
  std::vector<Vec3<float>> at;
  for (int i = 0; i < 250; ++i) at.push_back(random_point(random, 2));
  const auto largest_angle_deg = [&](const std::string& arguments) {
    double largest = 0;
    for (const auto& u : values_at("wood-fibre(axis=0/0/1," + arguments + ")", at)) {
      const double length = std::hypot(u[0], u[1], u[2]);
      EXPECT_GT(length, 0.9);
      largest = std::max(largest, std::acos(std::min(1.0, u[2] / length)) * 180 / std::numbers::pi);
    }
    return largest;
  };
  EXPECT_LT(largest_angle_deg("unrest=0"), 0.1);
  EXPECT_GT(largest_angle_deg("unrest=5"), 1.5);
  EXPECT_LT(largest_angle_deg("unrest=5"), 7.5);
  EXPECT_GT(largest_angle_deg("unrest=0,curl=12"), 8);
  EXPECT_LT(largest_angle_deg("unrest=0,curl=12"), 18);
}

TEST(Inputs, BadArguments) {
  const auto refusal = [](const std::string& call) {
    return test::error_of([&] { models::make_input(call, {"test", "", 0}); });
  };
  EXPECT_EQ(refusal("noise(scale=0)"),
            "test, noise: 'scale' wants a number from 1e-06 to 1e+06, not 0");
  EXPECT_EQ(refusal("noise(octaves=9)"),
            "test, noise: 'octaves' wants a number from 1 to 8, not 9");
  EXPECT_EQ(refusal("noise(a=checker)"),
            "test, noise: 'a' cannot vary; it wants one value, not 'checker'");
  EXPECT_EQ(refusal("wood-fibre(axis=0/0/0)"),
            "test, wood-fibre: 'axis' wants a direction, and 0/0/0 is none");
  EXPECT_EQ(refusal("wood-fiber"), "unknown input 'wood-fiber'; did you mean 'wood-fibre'?");
  EXPECT_EQ(refusal("noise(.5)"), "test, noise: expected key=value, not '.5'");
}

}  // namespace
}  // namespace scanlit
