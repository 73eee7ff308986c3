// Trigonometry in Batch, float and double, held to the errors that batch_trigonometry.h and
// cosines.h state.
#include "rasterizer/batch_trigonometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "rasterizer/formula_model.h"
#include "tests/unit/batch_lanes.h"

namespace scanlit {
namespace {

using namespace test;

constexpr double pi = std::numbers::pi;

/// check(function(t)) for a t of each type; of a Batch, the first lane.
template <class Function, class Check>
void in_all_precisions(Function function, Check check) {
  check(function(double{}));
  check(double(function(float{})));
  check(double(lanes_of(function(Batch{}))[0]));
}

const auto acos_batch = [](Batch x) { return acos(x); };
const auto asin_batch = [](Batch x) { return asin(x); };
const auto acos_double = [](double x) { return std::acos(x); };
const auto asin_double = [](double x) { return std::asin(x); };

TEST(BatchAcos, StatedRelativeErrorOverItsDomain) {
  const Worst acute = worst_relative_error(acos_batch, acos_double, 0, bits(1.0f), stride);
  EXPECT_LE(acute.error, 1.5e-7) << "at " << acute.at;
  const Worst obtuse =
      worst_relative_error(acos_batch, acos_double, bits(-0.0f), bits(-1.0f), stride);
  EXPECT_LE(obtuse.error, 1.5e-7) << "at " << obtuse.at;
  // Where the angle goes to 0 an absolute error would be enough to spoil a narrow lobe.
  const Worst small = worst_relative_error(acos_batch, acos_double, bits(0.999f), bits(1.0f), 1);
  EXPECT_LE(small.error, 1.5e-7) << "at " << small.at;
}

TEST(BatchAsin, StatedRelativeErrorOverItsDomain) {
  const auto least = bits(smallest_normal);
  const Worst positive = worst_relative_error(asin_batch, asin_double, least, bits(1.0f), stride);
  EXPECT_LE(positive.error, 3e-7) << "at " << positive.at;
  const Worst negative =
      worst_relative_error(asin_batch, asin_double, bits(-smallest_normal), bits(-1.0f), stride);
  EXPECT_LE(negative.error, 3e-7) << "at " << negative.at;
}

TEST(ArcFunctions, ClampTheirArgumentInAllPrecisions) {
  for (const float beyond : {1.0000001f, 1.5f, 1e10f, largest, infinity}) {
    in_all_precisions([&](auto t) { return acos(decltype(t)(beyond)); },
                      [](double angle) { EXPECT_EQ(angle, 0); });
    in_all_precisions([&](auto t) { return acos(decltype(t)(-beyond)); },
                      [](double angle) { EXPECT_NEAR(angle, pi, 3e-7); });
    in_all_precisions([&](auto t) { return asin(decltype(t)(beyond)); },
                      [](double angle) { EXPECT_NEAR(angle, pi / 2, 2e-7); });
    in_all_precisions([&](auto t) { return asin(decltype(t)(-beyond)); },
                      [](double angle) { EXPECT_NEAR(angle, -pi / 2, 2e-7); });
  }
  in_all_precisions([](auto t) { return acos(decltype(t)(nan)); },
                    [](double angle) { EXPECT_NEAR(angle, pi, 3e-7); });
  in_all_precisions([](auto t) { return asin(decltype(t)(nan)); },
                    [](double angle) { EXPECT_NEAR(angle, -pi / 2, 2e-7); });
}

TEST(BatchSinCos, StatedAbsoluteErrorOverTheirDomain) {
  const auto absolute = [](double value, double exact) { return std::abs(value - exact); };
  for (const float sign : {1.0f, -1.0f}) {
    const Worst sine =
        worst_error([](Batch x) { return sin(x); }, [](double x) { return std::sin(x); },
                    bits(sign * 0.0f), bits(sign * 1e4f), stride, absolute);
    EXPECT_LE(sine.error, 1.5e-7) << "at " << sine.at;
    const Worst cosine =
        worst_error([](Batch x) { return cos(x); }, [](double x) { return std::cos(x); },
                    bits(sign * 0.0f), bits(sign * 1e4f), stride, absolute);
    EXPECT_LE(cosine.error, 1.5e-7) << "at " << cosine.at;
  }
}

TEST(BatchSinCos, OutsideTheirDomainAreThoseOfItsEnd) {
  for (const float beyond : {10001.0f, 1e10f, largest, infinity}) {
    EXPECT_NEAR(lanes_of(sin(Batch(beyond)))[0], std::sin(1e4), 1.5e-7);
    EXPECT_NEAR(lanes_of(cos(Batch(-beyond)))[0], std::cos(1e4), 1.5e-7);
  }
}

TEST(BatchAtan2, StatedRelativeError) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  double worst = 0;
  for (int round = 0; round < 500000; ++round) {
    // Directions of all quadrants, and very close to the axes and diagonals.
    const double size = std::exp2(60 * unit(random)), close = std::exp2(-20 - 20 * unit(random));
    auto x = float(size * unit(random)), y = float(size * unit(random));
    if (round % 3 == 1) x = float(size * close * unit(random));
    if (round % 3 == 2) y = x * float(1 + close * unit(random));
    const double exact = std::atan2(double(y), double(x));
    const double error = std::abs((lanes_of(atan2(Batch(y), Batch(x)))[0] - exact) / exact);
    worst = std::max(worst, or_infinity(error));
  }
  EXPECT_LE(worst, 2.5e-7);
}

TEST(Atan2, OnTheAxesAndAtTheOriginInAllPrecisions) {
  const auto expect = [](float y, float x, double angle) {
    in_all_precisions([&](auto t) { return atan2(decltype(t)(y), decltype(t)(x)); },
                      [&](double value) {
                        EXPECT_NEAR(value, angle, 2e-7) << y << ' ' << x;
                        EXPECT_EQ(std::signbit(value), std::signbit(y)) << y << ' ' << x;
                      });
  };
  expect(0, 0, 0), expect(-0.0f, 0, 0);
  for (const float r : {smallest_normal, 1e-20f, 1.0f, 1e20f, largest}) {
    expect(0, r, 0), expect(-0.0f, r, 0);
    expect(0, -r, pi), expect(-0.0f, -r, -pi);
    expect(r, 0, pi / 2), expect(-r, 0, -pi / 2);
    expect(r, r, pi / 4), expect(-r, -r, -3 * pi / 4);
  }
}

TEST(Floor, IsExactInAllPrecisions) {
  for (const float x : {0.0f, 0.5f, 0.99999994f, 1.0f, -0.5f, -1.0f, -1.5f, 1e-30f, -1e-30f,
                        8388607.5f, -8388607.5f, 1e20f, -1e20f})
    in_all_precisions([&](auto t) { return floor(decltype(t)(x)); },
                      [&](double value) { EXPECT_EQ(value, std::floor(double(x))) << x; });
}

TEST(CosineAngle, StatedErrorDownToZero) {
  for (const double versine : {0.0, 1e-30, 1e-12, 1e-8, 1e-6, 1e-4, 0.01, 0.1, 0.5, 0.75, 1.0}) {
    const double given = float(versine);
    const double exact = 2 * std::asin(std::sqrt(given / 2));
    in_all_precisions([&](auto t) { return angle(Cosine<decltype(t)>::of_versine(given)); },
                      [&](double value) { EXPECT_NEAR(value, exact, 4e-7 * exact) << versine; });
    in_all_precisions(
        [&](auto t) { return angle2(Cosine<decltype(t)>::of_versine(given)); },
        [&](double value) { EXPECT_NEAR(value, exact * exact, 8e-7 * exact * exact) << versine; });
  }
}

TEST(CosineAngle, StatedErrorOverItsDomain) {
  const Worst worst =
      worst_relative_error([](Batch versine) { return angle(Cosine<Batch>::of_versine(versine)); },
                           [](double versine) { return 2 * std::asin(std::sqrt(versine / 2)); },
                           bits(1e-30f), bits(1.0f), stride);
  EXPECT_LE(worst.error, 4e-7) << "at versine " << worst.at;
}

}  // namespace
}  // namespace scanlit
