// Polynomials through chosen points of a smooth curve: what would cost too much at every fragment
// is computed there once.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "rasterizer/batch.h"
#include "rasterizer/scalar_math.h"

namespace scanlit::models {

/// Coefficients of x^0, x^1, ..., in the precision of most that evaluates them.
template <std::size_t size>
using Polynomial = std::array<float, size>;

/// By Horner's rule.
template <std::size_t size, class T>
T value_at(const T& x, const Polynomial<size>& p) {
  T sum(p.back());
  for (std::size_t i = size - 1; i-- > 0;) sum = mul_add(sum, x, T(p[i]));
  return sum;
}

/// Chebyshev's nodes in (0, 1): a polynomial through these points of a curve misses it about
/// equally far everywhere in between.
template <std::size_t size>
std::array<double, size> chebyshev_nodes() {
  std::array<double, size> nodes;
  for (std::size_t i = 0; i < size; ++i)
    nodes[i] = 0.5 * (1 + std::cos(std::numbers::pi * (double(i) + 0.5) / double(size)));
  return nodes;
}

/// The polynomial through the points (x[i], y[i]): Newton's divided differences, multiplied out.
template <std::size_t size>
Polynomial<size> interpolate(const std::array<double, size>& x, std::array<double, size> y) {
  for (std::size_t order = 1; order < size; ++order)
    for (std::size_t i = size - 1; i >= order; --i)
      y[i] = (y[i] - y[i - 1]) / (x[i] - x[i - order]);
  std::array<double, size> p{};
  for (std::size_t i = size; i-- > 0;) {  // p = p * (x - x[i]) + y[i]
    for (std::size_t j = size - 1; j > 0; --j) p[j] = p[j - 1] - x[i] * p[j];
    p[0] = y[i] - x[i] * p[0];
  }
  Polynomial<size> rounded;
  for (std::size_t i = 0; i < size; ++i) rounded[i] = float(p[i]);
  return rounded;
}

}  // namespace scanlit::models
