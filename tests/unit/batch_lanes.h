// Lanes of a Batch as an array, values that break arithmetic, and the error of a function of Batch.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "rasterizer/batch.h"

namespace scanlit::test {

using Lanes = std::array<float, Batch::lanes>;

inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr float nan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float smallest_normal = std::numeric_limits<float>::min();
inline constexpr float largest = std::numeric_limits<float>::max();
inline constexpr float subnormal = 1e-40f;

inline Lanes lanes_of(Batch batch) {
  Lanes lanes;
  batch.store(lanes.data());
  return lanes;
}

/// Lane i holds values[i], values again from the start where there are more lanes.
template <std::size_t N>
Batch batch_of(const std::array<float, N>& values, std::size_t first = 0) {
  Lanes lanes;
  for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i] = values[(first + i) % N];
  return Batch::load(lanes.data());
}

inline constexpr std::array<float, 16> awkward = {
    0.0f,     -0.0f,     1.0f, -1.0f, subnormal, -1e-40f, largest,       -largest,
    infinity, -infinity, nan,  3.0f,  1e-20f,    1e20f,   0.3333333433f, smallest_normal};

/// So that a NaN among the errors counts as the worst.
inline double or_infinity(double error) { return std::isnan(error) ? double(infinity) : error; }

inline std::uint32_t bits(float x) { return std::bit_cast<std::uint32_t>(x); }

// A prime: every value of the low mantissa bits comes up.
inline constexpr std::uint32_t stride = 997;

/// The largest error of `batch_function` over bit patterns first, first + stride, ... of floats,
/// and where it is. error(value, exact) is not asked where the two are equal.
struct Worst {
  double error = 0;
  float at = 0;
};
template <class BatchFunction, class Reference, class Error>
Worst worst_error(BatchFunction batch_function, Reference reference, std::uint32_t first,
                  std::uint32_t last, std::uint32_t step, Error error) {
  Worst worst;
  for (std::uint64_t block = first; block <= last; block += std::uint64_t(step) * Batch::lanes) {
    Lanes x;
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = std::bit_cast<float>(
          std::uint32_t(std::min<std::uint64_t>(block + std::uint64_t(step) * i, last)));
    const auto y = lanes_of(batch_function(Batch::load(x.data())));
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double exact = reference(double(x[i]));
      const double e = exact == double(y[i]) ? 0 : error(double(y[i]), exact);
      if (!(e <= worst.error)) worst = {or_infinity(e), x[i]};
    }
  }
  return worst;
}
template <class BatchFunction, class Reference>
Worst worst_relative_error(BatchFunction batch_function, Reference reference, std::uint32_t first,
                           std::uint32_t last, std::uint32_t step) {
  const auto relative = [](double value, double exact) {
    return std::abs((value - exact) / exact);
  };
  return worst_error(batch_function, reference, first, last, step, relative);
}

}  // namespace scanlit::test
