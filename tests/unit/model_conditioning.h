// How well float can know a reflection model's value.
#pragma once

#include <algorithm>

#include "tests/unit/model_queries.h"

namespace scanlit::test {

/// How sharp the lobe is, as an exponent of N.H: for a width m it is 2 / m^2.
inline double sharpness(const models::NamedModel& model) {
  double largest = 0;
  for (const auto& [key, value] : model.values) {
    const auto* number = std::get_if<double>(&value);
    if (!number) continue;
    for (const char* exponent : {"n", "nu", "nv", "ex", "ey"})
      if (key == exponent) largest = std::max(largest, *number);
    for (const char* width : {"m", "a", "ax", "ay", "beta"})
      if (key == width) largest = std::max(largest, 2 / (*number * *number));
  }
  return largest;
}

/// By how much the exact value changes at most when one coordinate of l or v changes by a rounding
/// of float: 2^-24. No arithmetic in float can do better than that.
inline double conditioning(const ReflectionModel& model, const Pair& pair, std::size_t channel) {
  const double exact = in_double(model, pair.l, pair.v)[channel];
  double largest = 0;
  for (int coordinate = 0; coordinate < 6; ++coordinate)
    for (const double step : {0x1p-24, -0x1p-24}) {
      glm::dvec3 l(pair.l), v(pair.v);
      (coordinate < 3 ? l : v)[coordinate % 3] += step;
      largest = std::max(largest, std::abs(in_double(model, l, v)[channel] - exact));
    }
  return largest;
}

}  // namespace scanlit::test
