// Vec3 and Rgb over any scalar: double (reference), float, or Batch (one value per vector lane).
//
// GLM serves matrices and everything on the host side; these two serve the formulas, whose scalar
// may be a hardware vector.
#pragma once

#include "rasterizer/scalar_math.h"

namespace scanlit {

/// A direction or position. Which space it is in, the variable's name says.
template <class T>
struct Vec3 {
  T x{}, y{}, z{};

  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3 operator*(const Vec3& a, const T& s) { return {a.x * s, a.y * s, a.z * s}; }
  friend Vec3 operator*(const T& s, const Vec3& a) { return a * s; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// Fused in vectors, where the processor can: for shading alone.
template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return mul_add(a.z, b.z, mul_add(a.y, b.y, a.x * b.x));
}

template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Linear-light RGB: radiance, or a dimensionless reflectance, or a model's parameter.
template <class T>
struct Rgb {
  T r{}, g{}, b{};

  Rgb() = default;
  Rgb(const T& red, const T& green, const T& blue) : r(red), g(green), b(blue) {}
  explicit Rgb(const T& grey) : r(grey), g(grey), b(grey) {}

  friend Rgb operator+(const Rgb& p, const Rgb& q) { return {p.r + q.r, p.g + q.g, p.b + q.b}; }
  friend Rgb operator-(const Rgb& p, const Rgb& q) { return {p.r - q.r, p.g - q.g, p.b - q.b}; }
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// Rgb times Rgb or scalar, in the precision T of the second factor, whatever the first one's: a
/// model's parameters are Rgb<double> and meet a cosine of type double, float or Batch.
template <class A, class T>
Rgb<T> operator*(const Rgb<A>& a, const T& s) {
  return {T(a.r) * s, T(a.g) * s, T(a.b) * s};
}
template <class A, class T>
Rgb<T> operator*(const Rgb<A>& a, const Rgb<T>& b) {
  return {T(a.r) * b.r, T(a.g) * b.g, T(a.b) * b.b};
}

}  // namespace scanlit
