// The complementary error function in all precisions, for Beckmann's masking.
#pragma once

#include <cmath>

#include "rasterizer/bounded.h"

namespace scanlit {

using std::erfc;

inline namespace HWY_NAMESPACE {

/// erfc(x) = 1 - erf(x). Domain: x >= 0. Maximum error: 6e-7, absolute.
/// Source: Hastings 1955, in Abramowitz and Stegun 1964, 7.1.26, whose own error is 1.5e-7; the
/// rest is rounding.
inline Batch erfc(Batch x) {
  const Batch t = Batch(1) / mul_add(x, 0.3275911, 1);
  const Batch high = mul_add(mul_add(t, 1.061405429, -1.453152027), t, 1.421413741);
  return t * mul_add(mul_add(high, t, -0.284496736), t, 0.254829592) * exp(-(x * x));
}

/// Falls; its derivatives are -2 / sqrt(pi) exp(-x^2) and -2 x times that, at most .968.
inline Bounded erfc(const Bounded& x) {
  const Batch lo = max(x.lo, Batch(0)), steepest = Batch(1.1283793) * exp(-(lo * lo));
  const Batch error(1.5e-6f);
  const Bounded value(max(erfc(max(x.hi, Batch(0))) - error, Batch(0)), erfc(lo) + error, 0, 0);
  return known_where(x.lo >= Batch(0), chain(x, value, steepest, 0.9681f));
}

}  // namespace HWY_NAMESPACE
}  // namespace scanlit
