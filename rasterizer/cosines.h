// The angles that formulas are written in, as cosines, from unit normal, direction to the light and
// direction to the viewer; in double, float or Batch.
#pragma once

#include <cmath>
#include <type_traits>

#include "rasterizer/batch.h"
#include "rasterizer/batch_trigonometry.h"
#include "rasterizer/light_source.h"
#include "rasterizer/reflection_model.h"
#include "rasterizer/scalar_math.h"

namespace scanlit {

/// A cosine that also knows its angle's versine, 1 - cos. Used as a number it is the cosine. Near 1
/// a float cosine has lost the angle; the versine, formed as a sum of squares, has not.
template <class T>
struct Cosine {
  T cos{};
  T versine{};
  operator const T&() const { return cos; }

  static Cosine of_versine(const T& versine) { return {.cos = T(1) - versine, .versine = versine}; }

  /// sin^2 of the angle, without the cancellation of 1 - cos^2 near 0.
  T sin2() const { return versine * (T(1) + cos); }
};

/// The angles of the lecture, as cosines.
template <class T>
struct Cosines {
  T n_l;          // N.L, in (-1, 1]
  T n_v;          // N.V, in [min_n_v, 1]
  Cosine<T> n_h;  // N.H, H half-way between L and V
  T v_h;          // V.H = L.H, in [0, 1]
  // 1 - N.L and 1 - N.V as sums of squares: what a formula in angles has near the normal, where the
  // cosines have lost them. They cost nothing where they are not used.
  T n_l_versine, n_v_versine;
};

/// The directions in the shading frame: x tangent, y bitangent, z normal; unit.
template <class T>
struct ShadingFrame {
  Vec3<T> l, v, h;
};

/// cos^n for n >= 0. Maximum error in float and Batch: (1 + |n log cos|) * 1.6e-7 relative, also
/// for n = 1e5, because the logarithm is taken of 1 - versine unrounded: the rounding of the cosine
/// would be magnified n times.
template <class T>
T pow(const Cosine<T>& c, const T& n) {
  const T one(1), zero(0);
  const T lost =
      (one - c.cos) - c.versine;  // by rounding to the cosine; both differences are exact
  const T power = exp(n * log_sum(max(c.cos, T(1e-37)), lost));
  return select(c.cos > zero, power, select(n > zero, zero, one));
}

/// The same where n is one number for all points. In vectors, whole ones up to 64 by
/// multiplications alone, in a third of the time. Maximum error of those: 1e-7 n, of the 1 at the
/// peak.
template <class T>
requires(!std::is_same_v<T, double>) T pow(const Cosine<T>& c, double n) {
  if constexpr (requires { T::lanes; })
    if (n >= 0 && n <= 64 && n == std::floor(n)) {
      T power(1), square = max(c.cos, T(0));  // cos^(2^i)
      for (auto bits = unsigned(n); bits != 0; bits >>= 1, square = square * square)
        if (bits & 1) power = power * square;
      return power;
    }
  return pow(c, T(n));
}

/// The angle in radians, from its versine: alpha = 2 asin(sqrt(versine / 2)). Maximum error in
/// float and Batch, versine in [0, 1]: 4e-7 relative, also near 0, where the acos of a rounded
/// cosine would be off by up to 2.4e-4 rad.
template <class T>
T angle(const Cosine<T>& c) {
  return T(2) * asin(sqrt(T(0.5) * c.versine));
}
/// Its square, for lobes in alpha^2. Maximum error: 8e-7 relative.
template <class T>
T angle2(const Cosine<T>& c) {
  const T alpha = angle(c);
  return alpha * alpha;
}

/// H, and what else of l and v alone the cosines are made of.
template <class T>
HalfWay<T> half_way(const Vec3<T>& l, const Vec3<T>& v) {
  const Vec3<T> s = l + v;
  const T s2 = dot(s, s), inverse_length = inverse_sqrt(max(s2, T(HalfWay<T>::none)));  // not 0/0
  return {.h = s * inverse_length, .v_h = min(T(1), T(0.5) * (s2 * inverse_length)), .s2 = s2};
}

/// The cosines of unit n, l and v, without cancellation: 1 - N.H = |H - N|^2 / 2. This is the one
/// place where N.V is clamped (min_n_v). None exceeds 1, as the dot product of two rounded unit
/// vectors may: sqrt(1 - n_l * n_l) would be NaN. Where H has no direction it is taken as
/// perpendicular to N.
template <class T>
Cosines<T> cosines(const Vec3<T>& n, const Vec3<T>& l, const Vec3<T>& v, const HalfWay<T>& half) {
  const Vec3<T> h_n = half.h - n, l_n = l - n, v_n = v - n;
  const T versine = select(half.s2 < T(HalfWay<T>::none), T(1), T(0.5) * dot(h_n, h_n));
  return {.n_l = min(T(1), dot(n, l)),
          .n_v = min(T(1), max(dot(n, v), T(min_n_v))),
          .n_h = Cosine<T>::of_versine(versine),
          .v_h = half.v_h,
          .n_l_versine = T(0.5) * dot(l_n, l_n),
          .n_v_versine = min(T(0.5) * dot(v_n, v_n), T(1 - min_n_v))};
}
template <class T>
Cosines<T> cosines(const Vec3<T>& n, const Vec3<T>& l, const Vec3<T>& v) {
  return cosines(n, l, v, half_way(l, v));
}

/// Directions into the shading frame of unit n and tangent t (perpendicular to n).
template <class T>
ShadingFrame<T> shading_frame(const Vec3<T>& n, const Vec3<T>& t, const Vec3<T>& l,
                              const Vec3<T>& v, const Vec3<T>& h) {
  const Vec3<T> b = cross(n, t);
  const auto local = [&](const Vec3<T>& d) { return Vec3<T>{dot(t, d), dot(b, d), dot(n, d)}; };
  return {.l = local(l), .v = local(v), .h = local(h)};
}
template <class T>
ShadingFrame<T> shading_frame(const Vec3<T>& n, const Vec3<T>& t, const Vec3<T>& l,
                              const Vec3<T>& v) {
  return shading_frame(n, t, l, v, half_way(l, v).h);
}

}  // namespace scanlit
