// Polynomials through chosen points of a smooth curve: what would cost too much at every fragment
// is computed there once.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "rasterizer/bounded.h"
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

/// Over bounds, about the middle m of the interval, where the coefficients c_k of (x - m)^k show
/// what the terms' signs cancel: P is c_0 within sum |c_k| r^k, |x - m| <= r, and its derivatives
/// likewise. What Horner's rule rounds, here and in Batch, is less than 4e-7 n of the same sums
/// with |p_k| and |x|.
template <std::size_t n>
Bounded value_at(const Bounded& x, const Polynomial<n>& p) {
  const Batch middle = Batch(0.5f) * (x.lo + x.hi), largest = x.magnitude();
  const Batch r = Batch(1.000001f) * max(x.hi - middle, middle - x.lo);
  Batch c[n];
  for (std::size_t k = 0; k < n; ++k) c[k] = Batch(p[k]);
  for (std::size_t k = 0; k + 1 < n; ++k)
    for (std::size_t i = n - 1; i-- > k;) c[i] = mul_add(c[i + 1], middle, c[i]);
  Batch away = 0, first = 0, second = 0, all = 0, all_first = 0, all_second = 0;
  for (std::size_t k = n; k-- > 0;) {
    const Batch of_c = abs(c[k]), of_p(std::abs(p[k]));
    const auto add = [](const Batch& by, const Batch& last, Batch& sum) {
      sum = mul_add(sum, by, last);
    };
    if (k >= 1) add(r, of_c, away), add(r, Batch(int(k)) * of_c, first);
    if (k >= 2) add(r, Batch(int(k * (k - 1))) * of_c, second);
    add(largest, of_p, all);
    if (k >= 1) add(largest, Batch(int(k)) * of_p, all_first);
    if (k >= 2) add(largest, Batch(int(k * (k - 1))) * of_p, all_second);
  }
  const Batch lost = 4e-7f * float(n), slack = 1 + 1e-6f * float(n);
  const Batch off = mul_add(away * r, slack, all * lost);
  return chain(x, {c[0] - off, c[0] + off, Batch(0), Batch(0)},
               mul_add(first, slack, all_first * lost), mul_add(second, slack, all_second * lost));
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
