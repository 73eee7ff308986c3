// Whatever is computed over bounds holds what is computed over numbers: the values, in double and
// in Batch, the speed at which they change, and how far a straight line misses them.
#include "rasterizer/bounded.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "models/microfacet/error_function.h"
#include "models/polynomial.h"
#include "rasterizer/bounded_functions.h"
#include "rasterizer/scalar_math.h"
#include "tests/unit/batch_lanes.h"

namespace scanlit {
namespace {

using namespace test;

/// A number that changes with t from 0 to 1: x + v t + a t^2 / 2.
struct Path {
  double x, v, a;

  double at(double t) const { return x + v * t + a * t * t / 2; }
  double slope() const { return std::max(std::abs(v), std::abs(v + a)); }
  std::pair<double, double> range() const {
    const double turn = a == 0 ? 0 : std::clamp(-v / a, 0.0, 1.0);
    return std::minmax({at(0), at(1), at(turn)});
  }
};

/// Within [from, to], anywhere and of any length: also a single number.
Path random_path(double from, double to, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double room = (to - from) * std::pow(10.0, -6 * unit(random));
  const double start = from + (to - from - room) * unit(random);
  // Of the parabola through three values in the room.
  const double p = start + room * unit(random), q = start + room * unit(random);
  const double bend = (unit(random) < .2 ? 0 : room * unit(random));
  Path path{p, q - p, 0};
  if (unit(random) < .1) path.v = 0;
  path.a = bend, path.v -= bend / 2;
  return path;
}

Bounded bounded(const Path (&paths)[Batch::lanes]) {
  Lanes lo, hi, slope, curvature;
  for (std::size_t i = 0; i < lo.size(); ++i) {
    const auto [least, greatest] = paths[i].range();
    lo[i] = std::nextafter(float(least), -infinity),
    hi[i] = std::nextafter(float(greatest), infinity);
    slope[i] = float(paths[i].slope()) * 1.000001f;
    curvature[i] = float(std::abs(paths[i].a)) * 1.000001f;
  }
  const auto load = [](const Lanes& lanes) { return Batch::load(lanes.data()); };
  return {load(lo), load(hi), load(slope), load(curvature)};
}

struct Checked {
  int limited = 0, of = 0;  // how often more is known than an interval
};

/// One formula of two arguments, in all types.
struct Operation {
  template <class F>
  Operation(const F& f) : over_bounds(f), in_double(f), in_batch(f) {}

  std::function<Bounded(const Bounded&, const Bounded&)> over_bounds;
  std::function<double(double, double)> in_double;
  std::function<Batch(const Batch&, const Batch&)> in_batch;
};

/// An operation over random paths in [from, to] and in [from_2, to_2].
void check(const std::string& name, const Operation& operation, double from, double to,
           double from_2 = 0.1, double to_2 = 3, Checked* counts = nullptr) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  Checked checked;
  for (int round = 0; round < 300; ++round) {
    Path x[Batch::lanes], y[Batch::lanes];
    for (Path& path : x) path = random_path(from, to, random);
    for (Path& path : y) path = random_path(from_2, to_2, random);
    const Bounded f = operation.over_bounds(bounded(x), bounded(y));
    const float h = float(std::pow(10.0, -2 * unit(random))), middle = float(unit(random));
    const Lanes lo = lanes_of(f.lo), hi = lanes_of(f.hi), slope = lanes_of(f.slope),
                curvature = lanes_of(f.curvature), missed = lanes_of(missed_by(f, Spacing::of(h)));
    const double a = (1 - h) * unit(random), b = a + double(h), m = a + double(middle) * double(h);
    Lanes x_m, y_m;
    for (std::size_t i = 0; i < lo.size(); ++i) {
      x_m[i] = float(x[i].at(m)), y_m[i] = float(y[i].at(m));
      if (std::isnan(slope[i])) continue;
      const auto at = [&](double t) { return operation.in_double(x[i].at(t), y[i].at(t)); };
      const double f_a = at(a), f_b = at(b), f_m = at(m);
      const std::string where = name + " of x = " + std::to_string(x[i].at(m)) +
                                ", y = " + std::to_string(y[i].at(m)) +
                                ", h = " + std::to_string(h);
      ASSERT_LE(double(lo[i]), std::min({f_a, f_b, f_m})) << where;
      ASSERT_GE(double(hi[i]), std::max({f_a, f_b, f_m})) << where;
      const double rounding = 1e-12 * std::max({1.0, std::abs(f_a), std::abs(f_b)});
      ASSERT_LE(std::abs(f_b - f_a), double(slope[i]) * h * 1.001 + rounding) << where;
      const double straight = f_a + double(middle) * (f_b - f_a);
      ASSERT_LE(std::abs(f_m - straight), double(missed[i]) + rounding) << where;
      ++checked.of, checked.limited += curvature[i] < 1e30f;
    }
    const Lanes in_batch =
        lanes_of(operation.in_batch(Batch::load(x_m.data()), Batch::load(y_m.data())));
    for (std::size_t i = 0; i < lo.size(); ++i) {
      if (std::isnan(slope[i])) continue;
      ASSERT_LE(lo[i], in_batch[i]) << name << " of " << x_m[i] << ", " << y_m[i];
      ASSERT_GE(hi[i], in_batch[i]) << name << " of " << x_m[i] << ", " << y_m[i];
    }
  }
  if (counts) *counts = checked;
}

/// The same, where nearly always more is known than an interval.
void check_smooth(const std::string& name, const Operation& operation, double from, double to,
                  double from_2 = 0.1, double to_2 = 3) {
  SCOPED_TRACE(name);
  Checked checked;
  check(name, operation, from, to, from_2, to_2, &checked);
  EXPECT_GT(checked.limited, 9 * checked.of / 10);
  EXPECT_GT(checked.of, 1000);
}

TEST(Bounded, HoldsWhatArithmeticGives) {
  for (const double size : {1.0, 1e-6, 1e6}) {
    const double from = -3 * size, to = 2 * size;
    check_smooth(
        "+", [](auto x, auto y) { return x + y; }, from, to);
    check_smooth(
        "-", [](auto x, auto y) { return x - y; }, from, to);
    check_smooth(
        "*", [](auto x, auto y) { return x * y; }, from, to, -1, 1);
    check_smooth(
        "x^2", [](auto x, auto) { return x * x; }, from, to);
    check_smooth(
        "/", [](auto x, auto y) { return x / y; }, from, to);
    check_smooth(
        "mul_add", [](auto x, auto y) { return mul_add(x, y, x); }, from, to);
    check(
        "/ near 0", [](auto x, auto y) { return x / y; }, from, to, -1, 1);
    check(
        "abs", [](auto x, auto) { return abs(x); }, from, to);
    check(
        "floor", [](auto x, auto) { return floor(x); }, from, to);
    check(
        "min", [](auto x, auto y) { return min(x, y); }, from, to, from, to);
    check(
        "max", [](auto x, auto y) { return max(x, y); }, from, to, from, to);
    check(
        "|x| y", [](auto x, auto y) { return abs(x) * y; }, from, to);
    check(
        "y |x|", [](auto x, auto y) { return y * abs(x); }, from, to);
    check(
        "select", [](auto x, auto y) { return select(x < y, y * y, x); }, from, to, from, to);
    check(
        "select", [](auto x, auto y) { return select((x > y) & (x >= -y), x, y + y); }, from, to,
        from, to);
    check(
        "select", [](auto x, auto y) { return select((x <= y) | (y < -x), x, -y); }, from, to, from,
        to);
  }
}

template <class T>
T gauss(const T& x) {
  return exp(-(x * x));
}
Bounded gauss(const Bounded& x) {
  const Batch convex = Batch(2) * x.slope * x.slope;
  return exp_minus(x * x, Batch(2) * convex, convex);
}
TEST(Bounded, HoldsWhatFunctionsGive) {
  for (const double size : {0.1, 1.0, 3.0})
    check_smooth(
        "exp(-x^2)", [](auto x, auto) { return gauss(x); }, -size, size);
  check_smooth(
      "sqrt", [](auto x, auto) { return sqrt(x); }, 1e-3, 4);
  check_smooth(
      "1/sqrt", [](auto x, auto) { return inverse_sqrt(x); }, 1e-3, 4);
  check_smooth(
      "1/x", [](auto x, auto) { return reciprocal(x); }, -4, -1e-3);
  check_smooth(
      "exp", [](auto x, auto) { return exp(x); }, -80, 5);
  check_smooth(
      "log", [](auto x, auto) { return log(x); }, 1e-3, 4);
  check_smooth(
      "sin", [](auto x, auto) { return sin(x); }, -20, 20);
  check_smooth(
      "cos", [](auto x, auto) { return cos(x); }, -20, 20);
  check_smooth(
      "asin", [](auto x, auto) { return asin(x); }, -.99, .99);
  check_smooth(
      "acos", [](auto x, auto) { return acos(x); }, -.99, .99);
  const models::Polynomial<5> cancelling{1, -4, 6, -4, 1};  // (1 - x)^4
  check_smooth(
      "polynomial", [&](auto x, auto) { return models::value_at(x, cancelling); }, -.5, 2);
  check_smooth(
      "erfc", [](auto x, auto) { return erfc(x); }, 0, 5);
  check(
      "sqrt at 0", [](auto x, auto) { return sqrt(max(x, decltype(x)(0))); }, -.1, 1);
  check(
      "asin at 1", [](auto x, auto) { return asin(x); }, -1, 1);
  check(
      "atan2", [](auto x, auto y) { return atan2(x, y); }, -1, 1, -1, 1);
  check_smooth(
      "atan2", [](auto x, auto y) { return atan2(x, y); }, -1, 1);
}

TEST(Bounded, HoldsPowers) {
  for (const double n : {-2.0, 0.0, .3, 1.0, 1.5, 2.0, 2.5, 50.0}) {
    const auto power = [n](auto x, auto) { return pow(x, decltype(x)(n)); };
    check_smooth("x^" + std::to_string(n), power, 1e-2, 1.2);
    if (n >= 0) check("x^" + std::to_string(n) + " at 0", power, 0, 1);
  }
  check(
      "x^y", [](auto x, auto y) { return pow(x, y); }, 1e-2, 1.2);
  for (const double n : {0.0, .3, 1.0, 1.5, 2.0, 32.0, 1e5}) {
    const auto power = [n](auto x, auto) {
      using T = decltype(x);
      return pow(Cosine<T>::of_versine(x), T(n));
    };
    check("cos^" + std::to_string(n), power, 0, 1.5);
    check("cos^" + std::to_string(n), power, 0, 5 / std::max(n, 10.0));
  }
  const auto squared = [](auto x, auto) { return angle2(Cosine<decltype(x)>::of_versine(x)); };
  check_smooth("angle^2", squared, 0, 1);
  check(
      "angle", [](auto x, auto) { return angle(Cosine<decltype(x)>::of_versine(x)); }, 0, 1);
}

// A bound that is far too large would be as useless as one that is too small is wrong.
TEST(Bounded, IsSharpOverAShortWay) {
  const Path paths[2] = {{.8, .02, 0}, {.9, .001, .002}};
  Path x[Batch::lanes];
  std::fill_n(x, Batch::lanes, paths[0]);
  const Bounded f = exp(bounded(x)) * bounded(x);
  const double exact = std::exp(.8) * (.02 * .02) * (2 + .8);  // (x e^x)'' = (2 + x) e^x x'^2
  EXPECT_LT(lanes_of(f.curvature)[0], 1.1 * exact);
  EXPECT_GT(lanes_of(f.curvature)[0], exact);
  EXPECT_NEAR(lanes_of(missed_by(f, Spacing::of(1)))[0], exact / 8, .1 * exact / 8);
}

TEST(Bounded, IsSharpOfPolynomialsWhoseTermsCancel) {
  Path x[Batch::lanes];
  std::fill_n(x, Batch::lanes, Path{.8, .02, 0});
  const Bounded f = models::value_at(bounded(x), models::Polynomial<5>{1, -4, 6, -4, 1});
  EXPECT_LT(lanes_of(f.slope)[0], 1.1 * 4 * std::pow(.2, 3) * .02);
  EXPECT_LT(lanes_of(f.curvature)[0], 1.1 * 12 * std::pow(.2, 2) * .02 * .02);
}

TEST(Bounded, WhatIsNotKnownStaysUnknown) {
  const Bounded zero(Batch(-1), Batch(1), 1, 1), unknown = Bounded(1) / zero;
  for (const Bounded& x :
       {unknown + Bounded(1), Bounded(0) * unknown, max(unknown, Bounded(0)),
        max(Bounded(0), unknown), min(unknown, zero), select(zero > Bounded(0), unknown, zero),
        select(zero > Bounded(0), zero, unknown), exp(unknown), sqrt(unknown), abs(unknown),
        floor(unknown), pow(unknown, Bounded(2)), sin(unknown), asin(unknown),
        atan2(unknown, Bounded(1)), erfc(unknown)})
    EXPECT_TRUE(std::isnan(lanes_of(missed_by(x, Spacing::of(1)))[0]));
}

// 1 / x of a negative and a positive x is anything: nothing is decided by it.
TEST(Bounded, WhatIsNotKnownDecidesNothing) {
  const Bounded x(Batch(-1), Batch(2), 1, 1), unknown = Bounded(1) / x, far(5);
  for (const Bounded& chosen : {max(unknown, far), min(unknown, -far), abs(unknown)})
    EXPECT_TRUE(std::isnan(lanes_of(chosen.slope)[0]));
  const Bounded either = select(unknown < Bounded(3), far, x);
  EXPECT_LE(lanes_of(either.lo)[0], -1);
  EXPECT_GE(lanes_of(either.hi)[0], 5);
  EXPECT_EQ(lanes_of(either.slope)[0], Bounded::no_limit);
}

TEST(Bounded, AnUnknownCurvatureIsNotTakenForNone) {
  const Batch nan = std::numeric_limits<float>::quiet_NaN();
  const Bounded x(Batch(-1), Batch(2), 1, nan), y(Batch(0), Batch(1), 1, 0);
  for (const Bounded& either : {max(x, y), max(y, x), min(x, y), min(y, x), abs(x)})
    EXPECT_EQ(lanes_of(missed_by(either, Spacing::of(1)))[0], Bounded::rounding_slack / 2);
}

}  // namespace
}  // namespace scanlit
