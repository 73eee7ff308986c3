// The complementary error function in all precisions, for Beckmann's masking.
#pragma once

#include <cmath>

#include "rasterizer/batch.h"

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

}  // namespace HWY_NAMESPACE
}  // namespace scanlit
