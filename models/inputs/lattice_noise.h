// Gradient noise: a smooth random function of a point in space, the stuff of procedural patterns.
//
// Ken Perlin, "An image synthesizer", SIGGRAPH 1985, and "Improving noise", SIGGRAPH 2002 (the
// fade). Every point of the lattice of whole numbers has a random gradient; between them the eight
// linear functions of a cell's corners are blended. T is float or Batch; both give the same values
// up to the rounding of the blend, on every processor, because the gradients come from whole
// numbers.
#pragma once

#include <cstdint>

#include "rasterizer/batch.h"
#include "rasterizer/batch_trigonometry.h"
#include "rasterizer/scalar_math.h"
#include "rasterizer/vec.h"

namespace scanlit::models {

/// Unsigned whole numbers, one a lane, as std::uint32_t is for a scalar.
struct BatchOfWholes {
  using Tag = hn::RebindToUnsigned<Batch::Tag>;
  hn::Vec<Tag> raw;

  explicit BatchOfWholes(std::uint32_t x) : raw(hn::Set(Tag(), x)) {}
  explicit BatchOfWholes(hn::Vec<Tag> x) : raw(x) {}
  friend BatchOfWholes operator*(BatchOfWholes a, BatchOfWholes b) {
    return BatchOfWholes(hn::Mul(a.raw, b.raw));
  }
  friend BatchOfWholes operator+(BatchOfWholes a, BatchOfWholes b) {
    return BatchOfWholes(hn::Add(a.raw, b.raw));
  }
  friend BatchOfWholes operator^(BatchOfWholes a, BatchOfWholes b) {
    return BatchOfWholes(hn::Xor(a.raw, b.raw));
  }
  friend BatchOfWholes operator&(BatchOfWholes a, BatchOfWholes b) {
    return BatchOfWholes(hn::And(a.raw, b.raw));
  }
  template <int bits>
  friend BatchOfWholes shift_right(BatchOfWholes a) {
    return BatchOfWholes(hn::ShiftRight<bits>(a.raw));
  }
};

// From whole numbers kept as floats, |x| < 2^31, modulo 2^32, and back (x < 2^31).
inline BatchOfWholes to_wholes(Batch x) {
  const hn::RebindToSigned<Batch::Tag> ints;
  return BatchOfWholes(hn::BitCast(BatchOfWholes::Tag(), hn::ConvertTo(ints, x.raw)));
}
inline Batch to_floats(BatchOfWholes x) {
  const hn::RebindToSigned<Batch::Tag> ints;
  return hn::ConvertTo(Batch::tag, hn::BitCast(ints, x.raw));
}
inline std::uint32_t to_wholes(float x) { return std::uint32_t(std::int32_t(x)); }
inline float to_floats(std::uint32_t x) { return float(x); }
template <int bits>
std::uint32_t shift_right(std::uint32_t x) {
  return x >> bits;
}

/// A lattice point's random number. The mixing is Chris Wellons' "lowbias32" (hash-prospector,
/// 2018); the three odd factors are arbitrary.
template <class T>
auto lattice_hash(const Vec3<T>& whole) {
  auto x = to_wholes(whole.x), y = to_wholes(whole.y), z = to_wholes(whole.z);
  using Wholes = decltype(x);
  auto h = x * Wholes(0x8da6b343u) + y * Wholes(0xd8163841u) + z * Wholes(0xcb1ab31fu);
  h = (h ^ shift_right<16>(h)) * Wholes(0x7feb352du);
  h = (h ^ shift_right<15>(h)) * Wholes(0x846ca68bu);
  return h ^ shift_right<16>(h);
}

/// A lattice point's gradient: each component in [-1, 1], from ten bits.
template <class T>
Vec3<T> lattice_gradient(const Vec3<T>& whole) {
  const auto h = lattice_hash(whole);
  using Wholes = std::remove_const_t<decltype(h)>;
  const Wholes ten_bits(1023u);
  const auto component = [](Wholes bits) { return to_floats(bits) * T(2.0 / 1023) - T(1); };
  return {component(h & ten_bits), component(shift_right<10>(h) & ten_bits),
          component(shift_right<20>(h) & ten_bits)};
}

/// In [-1, 1], of mean 0, with features about as large as 1; 0 at lattice points. Domain: all
/// points; beyond |x| = 2^20, where float has no fractions left to speak of, it is the bound's.
template <class T>
T gradient_noise(const Vec3<T>& point) {
  const auto in_reach = [](const T& x) { return min(max(x, T(-1048576.0)), T(1048576.0)); };
  const Vec3<T> p{in_reach(point.x), in_reach(point.y), in_reach(point.z)};
  const Vec3<T> cell{floor(p.x), floor(p.y), floor(p.z)}, d = p - cell;
  const T zero(0), one(1);
  const auto corner = [&](const T& x, const T& y, const T& z) {
    const Vec3<T> offset{x, y, z};
    return dot(lattice_gradient(cell + offset), d - offset);
  };
  const auto fade = [](const T& t) { return t * t * t * (t * (t * T(6) - T(15)) + T(10)); };
  const auto mix = [](const T& a, const T& b, const T& t) { return a + (b - a) * t; };
  const Vec3<T> t{fade(d.x), fade(d.y), fade(d.z)};
  const auto row = [&](const T& y, const T& z) {
    return mix(corner(zero, y, z), corner(one, y, z), t.x);
  };
  const auto layer = [&](const T& z) { return mix(row(zero, z), row(one, z), t.y); };
  // Values beyond 1/2 are rare (they want eight gradients to agree), beyond 1 all but impossible.
  return min(max(T(2) * mix(layer(zero), layer(one), t.z), T(-1)), one);
}

/// Several noises, each twice as fine as the one before and half as strong, in [-1, 1]. The lattice
/// is turned from one to the next: its directions and its zeros would add up to a visible grid.
template <class T>
T fractal_noise(Vec3<T> p, int octaves) {
  T sum(0);
  double strength = 1, total = 0;
  for (int i = 0; i < octaves; ++i) {
    // A rotation by 90 degrees about (1, 2, 2), which is no axis of the lattice.
    const Vec3<T> turned{(p.x - T(4) * p.y + T(8) * p.z) * T(1.0 / 9),
                         (T(8) * p.x + T(4) * p.y + p.z) * T(1.0 / 9),
                         (T(-4) * p.x + T(7) * p.y + T(4) * p.z) * T(1.0 / 9)};
    const Vec3<T> shift{T(3.37 + i), T(1.71), T(8.13)};
    sum = sum + T(strength) * gradient_noise(turned + shift);
    total += strength * strength;  // independent noises: their squares add up
    strength /= 2;
    p = turned * T(2);
  }
  return min(max(sum * T(1 / std::sqrt(total)), T(-1)), T(1));
}

/// From 0 where x <= from to 1 where x >= to, smoothly.
template <class T>
T smooth_step(double from, double to, const T& x) {
  const T t = min(max((x - T(from)) * T(1 / (to - from)), T(0)), T(1));
  return t * t * (T(3) - T(2) * t);
}

}  // namespace scanlit::models
