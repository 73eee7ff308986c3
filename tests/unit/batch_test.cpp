// Batch: every operation against scalar float or double, held to the error that batch.h states.
#include "rasterizer/batch.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "rasterizer/scalar_math.h"
#include "tests/unit/batch_lanes.h"

namespace scanlit {
namespace {

using namespace test;

bool same_bits_or_both_nan(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

TEST(Batch, ArithmeticIsScalarFloatToTheBit) {
  std::mt19937 random(1);
  for (int round = 0; round < 20000; ++round) {
    std::array<float, 16> a, b;
    for (std::size_t i = 0; i < a.size(); ++i) {
      a[i] = round < 16 ? awkward[i] : std::bit_cast<float>(std::uint32_t(random()));
      b[i] = round < 16 ? awkward[(i + std::size_t(round)) % 16]
                        : std::bit_cast<float>(std::uint32_t(random()));
    }
    const Batch x = batch_of(a), y = batch_of(b);
    const auto sum = lanes_of(x + y), difference = lanes_of(x - y), product = lanes_of(x * y),
               quotient = lanes_of(x / y), root = lanes_of(sqrt(x)), negative = lanes_of(-x),
               magnitude = lanes_of(abs(x)), least = lanes_of(min(x, y)),
               greatest = lanes_of(max(x, y)), unfused = lanes_of(x * y + x);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      SCOPED_TRACE(testing::Message() << a[i] << " and " << b[i]);
      ASSERT_PRED2(same_bits_or_both_nan, sum[i], a[i] + b[i]);
      ASSERT_PRED2(same_bits_or_both_nan, difference[i], a[i] - b[i]);
      ASSERT_PRED2(same_bits_or_both_nan, product[i], a[i] * b[i]);
      ASSERT_PRED2(same_bits_or_both_nan, quotient[i], a[i] / b[i]);
      ASSERT_PRED2(same_bits_or_both_nan, root[i], std::sqrt(a[i]));
      ASSERT_PRED2(same_bits_or_both_nan, negative[i], -a[i]);
      ASSERT_PRED2(same_bits_or_both_nan, magnitude[i], std::fabs(a[i]));
      ASSERT_PRED2(same_bits_or_both_nan, least[i], min(a[i], b[i]));
      ASSERT_PRED2(same_bits_or_both_nan, greatest[i], max(a[i], b[i]));
      const float rounded_product = a[i] * b[i];
      ASSERT_PRED2(same_bits_or_both_nan, unfused[i], rounded_product + a[i]);
    }
  }
}

// The processor's own estimate is refined: a step less, or one of a coarser estimate, shows.
TEST(Batch, ReciprocalAndInverseSqrtKeepToTheirErrors) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> power(-125, 125);
  for (int round = 0; round < 20000; ++round) {
    std::array<float, 16> x;
    for (float& a : x) a = float(std::exp2(power(random)));
    if (round == 0) x[0] = 0x1p-125f, x[1] = 0x1p125f;
    const auto r = lanes_of(reciprocal(batch_of(x))), minus = lanes_of(reciprocal(-batch_of(x))),
               root = lanes_of(inverse_sqrt(batch_of(x)));
    for (std::size_t i = 0; i < r.size(); ++i) {
      const double a = double(x[i]);
      ASSERT_LE(std::abs(double(r[i]) * a - 1), 1.5e-7) << a;
      ASSERT_EQ(minus[i], -r[i]) << a;
      ASSERT_LE(std::abs(double(root[i]) * std::sqrt(a) - 1), 1.5e-7) << a;
    }
  }
}

TEST(Batch, MulAddIsRoundedOnceOrTwice) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> number(-10, 10);
  for (int round = 0; round < 10000; ++round) {
    const float a = number(random), b = number(random), c = number(random);
    const float result = lanes_of(mul_add(Batch(a), Batch(b), Batch(c)))[0];
    EXPECT_TRUE(result == std::fma(a, b, c) || result == a * b + c) << a << ' ' << b << ' ' << c;
  }
}

TEST(Batch, ComparisonsSelectLaneByLane) {
  for (std::size_t shift = 0; shift < awkward.size(); ++shift) {
    const Batch x = batch_of(awkward), y = batch_of(awkward, shift);
    const auto yes_no = [](Batch::Mask mask) { return lanes_of(select(mask, 1.0f, 0.0f)); };
    const auto less = yes_no(x < y), less_equal = yes_no(x <= y), greater = yes_no(x > y),
               greater_equal = yes_no(x >= y), both = yes_no((x <= y) & (x >= y)),
               either = yes_no((x < y) | (x > y));
    for (std::size_t i = 0; i < less.size(); ++i) {
      const float a = awkward[i], b = awkward[(i + shift) % awkward.size()];
      SCOPED_TRACE(testing::Message() << a << " and " << b);
      EXPECT_EQ(less[i], float(a < b));
      EXPECT_EQ(less_equal[i], float(a <= b));
      EXPECT_EQ(greater[i], float(a > b));
      EXPECT_EQ(greater_equal[i], float(a >= b));
      EXPECT_EQ(both[i], float(a == b));
      EXPECT_EQ(either[i], float(a < b || a > b));
    }
  }
}

TEST(Batch, NoneTellsWhetherAnyLaneIsSet) {
  const Batch numbers = Batch::iota(0);
  EXPECT_TRUE(none(numbers < 0.0f));
  EXPECT_FALSE(none(numbers < 1.0f));  // only the first lane
  EXPECT_FALSE(none(numbers >= float(Batch::lanes - 1)));
}

TEST(Batch, IotaCountsOnExactlyUpTo2To24) {
  const float first = 16777216.0f - Batch::lanes;
  const auto numbers = lanes_of(Batch::iota(first));
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], first + float(i));
}

TEST(BatchExp, StatedErrorOverItsDomain) {
  const auto exp_batch = [](Batch x) { return exp(x); };
  const auto exp_double = [](double x) { return std::exp(x); };
  const Worst up = worst_relative_error(exp_batch, exp_double, 0, bits(88.0f), stride);
  EXPECT_LE(up.error, 9e-8) << "at " << up.at;
  const Worst down = worst_relative_error(exp_batch, exp_double, bits(-0.0f), bits(-87.0f), stride);
  EXPECT_LE(down.error, 9e-8) << "at " << down.at;
}

TEST(BatchExp, OutsideItsDomain) {
  const auto at = [](float x) { return lanes_of(exp(Batch(x)))[0]; };
  EXPECT_EQ(at(0), 1);
  EXPECT_EQ(at(-0.0f), 1);
  EXPECT_EQ(at(subnormal), 1);
  for (const float below : {std::nextafter(-87.0f, -infinity), -87.4f, -88.0f, -1e10f, -infinity})
    EXPECT_EQ(at(below), 0) << below;
  for (const float above : {88.1f, 89.0f, 1e10f, largest, infinity})
    EXPECT_EQ(at(above), at(88)) << above;
  EXPECT_EQ(at(nan), at(-87));
}

TEST(BatchLog, StatedErrorOverAllPositiveNormalFloats) {
  const auto log_batch = [](Batch x) { return log(x); };
  const auto log_double = [](double x) { return std::log(x); };
  const Worst all =
      worst_relative_error(log_batch, log_double, bits(smallest_normal), bits(largest), stride);
  EXPECT_LE(all.error, 9e-8) << "at " << all.at;
  // Where the logarithm crosses zero an absolute error would be enough to spoil a power.
  const Worst near_one = worst_relative_error(log_batch, log_double, bits(0.9f), bits(1.1f), 7);
  EXPECT_LE(near_one.error, 9e-8) << "at " << near_one.at;
}

TEST(BatchLog, OutsideItsDomain) {
  const auto at = [](float x) { return lanes_of(log(Batch(x)))[0]; };
  EXPECT_EQ(at(1), 0);
  for (const float below : {subnormal, 0.0f, -0.0f, -subnormal, -1.0f, -largest, -infinity, nan})
    EXPECT_EQ(at(below), at(smallest_normal)) << below;
  EXPECT_NEAR(at(smallest_normal), -126 * std::log(2.0), 1e-5);
  EXPECT_NEAR(at(infinity), 128 * std::log(2.0), 1e-5);
}

TEST(BatchLogSum, StatedError) {
  // A sum of two floats that float cannot hold, such as 1 - sin^2.
  const auto error_at = [](float x, float low) {
    const double exact = std::log1p((double(x) - 1) + low);
    return or_infinity(std::abs(lanes_of(log_sum(Batch(x), Batch(low)))[0] - exact) / -exact);
  };
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  double worst_above = 0, worst_below = 0;
  for (int round = 0; round < 500000; ++round) {
    const double one_less = std::exp2(-40 * unit(random));
    const auto x = float(1 - one_less);
    if (x < smallest_normal) continue;
    const auto low = float((1 - double(x)) - one_less);
    double& worst = x * x >= 0.5f ? worst_above : worst_below;
    worst = std::max(worst, error_at(x, low));
  }
  EXPECT_LE(worst_above, 1.3e-7);
  EXPECT_LE(worst_below, 2e-7);
  EXPECT_FLOAT_EQ(lanes_of(log_sum(Batch(1.0f), Batch(-1e-10f)))[0], -1e-10f);
}

TEST(BatchPow, StatedError) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  double worst = 0;
  for (int round = 0; round < 500000; ++round) {
    // Half over all normal floats, half close to 1, where large exponents are of use.
    const double spread = std::exp2(-22 * unit(random));
    const auto x = float(round % 2 ? std::exp2(-126 + 253.9 * unit(random))
                                   : 1 + (unit(random) - 0.5) * spread);
    if (x == 1) continue;
    const double log_x = std::log(double(x));
    const auto y = float((2 * unit(random) - 1) * std::min(1e5, 86.9 / std::abs(log_x)));
    const double exact = std::pow(double(x), double(y));
    const double result = lanes_of(pow(Batch(x), Batch(y)))[0];
    const double error = std::abs(result - exact) / exact / (1 + std::abs(y * log_x));
    worst = std::max(worst, or_infinity(error));
  }
  EXPECT_LE(worst, 1.4e-7);
}

TEST(BatchPow, SpecialValues) {
  const auto at = [](float x, float y) { return lanes_of(pow(Batch(x), Batch(y)))[0]; };
  for (const float x : {0.0f, -0.0f, -3.0f, subnormal, 1.0f, 7.0f, largest, infinity, nan})
    EXPECT_EQ(at(x, 0), 1) << x;
  for (const float x : {0.0f, -0.0f, -subnormal, -1.0f, -infinity})
    for (const float y : {0.5f, 2.0f, -1.0f, 1e5f, infinity})
      EXPECT_EQ(at(x, y), 0) << x << ' ' << y;
  EXPECT_EQ(at(0.5f, 1e5f), 0);
  EXPECT_EQ(at(2, 1e5f), lanes_of(exp(Batch(88)))[0]);
  EXPECT_EQ(at(infinity, 2), lanes_of(exp(Batch(88)))[0]);
  EXPECT_EQ(at(infinity, -2), 0);
  EXPECT_EQ(at(subnormal, 0.5f), at(smallest_normal, 0.5f));
}

TEST(BatchMathematics, NeverGivesInfinityOrNaN) {
  for (const float x : awkward)
    for (const float y : awkward) {
      EXPECT_TRUE(std::isfinite(lanes_of(exp(Batch(x)))[0])) << x;
      EXPECT_TRUE(std::isfinite(lanes_of(log(Batch(x)))[0])) << x;
      EXPECT_TRUE(std::isfinite(lanes_of(pow(Batch(x), Batch(y)))[0])) << x << ' ' << y;
    }
}

// A branch on a Batch would take one way for all lanes: it must not compile.
template <class T>
concept Branches = requires(T a) {
  a < a ? 1 : 0;
};
static_assert(Branches<float>);
static_assert(!Branches<Batch>);

}  // namespace
}  // namespace scanlit
