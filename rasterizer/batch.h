// Batch: one float per vector lane, so that a formula written for one point serves a whole vector.
//
// A thin class over Highway's static target, with exp, log and pow whose results are always finite;
// batch_trigonometry.h has the trigonometric functions. Comparisons give a Mask that does not
// convert to bool: an `if` on a Batch does not compile, `select` is the way.
//
// Two kinds of arithmetic:
//  * operators + - * / and sqrt are single IEEE operations, never fused (the build says
//    -ffp-contract=off): the same to the bit as scalar float on every processor. Whatever decides
//    coverage, ids or depth uses these alone.
//  * mul_add is fused where the processor can (AVX2, AVX-512) and not elsewhere (SSE4); reciprocal
//    and inverse_sqrt start from the processor's own estimate: for shading alone.
#pragma once

#include <hwy/highway.h>

#include <cstdint>

namespace scanlit {

// The namespace bears the instruction set's name: code built for one level does not link with code
// built for another, instead of failing at run time.
inline namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

class Batch {
 public:
  using Tag = hn::ScalableTag<float>;
  using Vector = hn::Vec<Tag>;
  static constexpr Tag tag{};
  static constexpr int lanes = int(hn::MaxLanes(Tag()));
  static_assert(HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL || HWY_TARGET == HWY_AVX2 ||
                    HWY_TARGET == HWY_SSE4 || !HWY_ARCH_X86,
                "the build's -march and HWY_DISABLE_PCLMUL_AES must give SSE4, AVX2 or AVX-512");

  struct Mask {
    hn::Mask<Tag> raw;
    friend Mask operator&(Mask a, Mask b) { return {hn::And(a.raw, b.raw)}; }
    friend Mask operator|(Mask a, Mask b) { return {hn::Or(a.raw, b.raw)}; }
    friend bool none(Mask m) { return hn::AllFalse(tag, m.raw); }
    /// One bit a lane, the first lane's lowest.
    friend unsigned bits_of(Mask m) {
      std::uint64_t bits = 0;
      hn::StoreMaskBits(tag, m.raw, reinterpret_cast<std::uint8_t*>(&bits));
      return unsigned(bits);
    }
  };

  Batch() = default;
  Batch(Vector v) : raw(v) {}
  Batch(float s) : raw(hn::Set(tag, s)) {}
  Batch(double s) : Batch(float(s)) {}
  Batch(int s) : Batch(float(s)) {}

  static Batch load(const float* p) { return hn::LoadU(tag, p); }
  void store(float* p) const { hn::StoreU(raw, tag, p); }
  /// first, first + 1, first + 2, ...; exact while below 2^24. hn::Iota (Highway 1.0.3) adds lane
  /// by lane under GCC 12: frames with AVX2 took up to twice as long.
  static Batch iota(float first) {
    static constexpr float counted[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    static_assert(lanes <= 16);
    return Batch(first) + load(counted);
  }

  friend Batch operator+(Batch a, Batch b) { return hn::Add(a.raw, b.raw); }
  friend Batch operator-(Batch a, Batch b) { return hn::Sub(a.raw, b.raw); }
  friend Batch operator*(Batch a, Batch b) { return hn::Mul(a.raw, b.raw); }
  friend Batch operator/(Batch a, Batch b) { return hn::Div(a.raw, b.raw); }
  friend Batch operator-(Batch a) { return hn::Neg(a.raw); }
  Batch& operator+=(Batch b) { return *this = *this + b; }

  friend Mask operator<(Batch a, Batch b) { return {hn::Lt(a.raw, b.raw)}; }
  friend Mask operator<=(Batch a, Batch b) { return {hn::Le(a.raw, b.raw)}; }
  friend Mask operator>(Batch a, Batch b) { return {hn::Gt(a.raw, b.raw)}; }
  friend Mask operator>=(Batch a, Batch b) { return {hn::Ge(a.raw, b.raw)}; }

  friend Batch select(Mask m, Batch a, Batch b) { return hn::IfThenElse(m.raw, a.raw, b.raw); }
  /// min and max: b where either is NaN.
  friend Batch min(Batch a, Batch b) { return hn::Min(a.raw, b.raw); }
  friend Batch max(Batch a, Batch b) { return hn::Max(a.raw, b.raw); }
  friend Batch abs(Batch a) { return hn::Abs(a.raw); }
  friend Batch sqrt(Batch a) { return hn::Sqrt(a.raw); }
  /// a * b + c, with one rounding where the processor fuses and two elsewhere.
  friend Batch mul_add(Batch a, Batch b, Batch c) { return hn::MulAdd(a.raw, b.raw, c.raw); }

  Vector raw;
};

/// 1/x, for 2^-125 <= |x| <= 2^125. Maximum error: 1.5e-7 relative; a third of a division's time.
/// Two steps of Newton's iteration in one: with e = 1 - x r, 1/x = r / (1 - e) = r (1 + e + e^2
/// ...)
inline Batch reciprocal(Batch x) {
  const Batch r = hn::ApproximateReciprocal(x.raw);  // |e| <= 1.5 * 2^-12
  const Batch e = hn::NegMulAdd(x.raw, r.raw, Batch(1).raw);
  return mul_add(r, mul_add(e, e, e), r);
}

/// 1/sqrt(x), for 2^-125 <= x <= 2^125. Maximum error: 1.5e-7 relative; a quarter of the time that
/// root and division take. With e = 1 - x r^2, 1/sqrt(x) = r (1 - e)^(-1/2) = r (1 + e/2 + 3e^2/8
/// ...)
inline Batch inverse_sqrt(Batch x) {
  const Batch r = hn::ApproximateReciprocalSqrt(x.raw);  // |e| <= 1.5 * 2^-11
  const Batch e = hn::NegMulAdd((x * r).raw, r.raw, Batch(1).raw);
  return mul_add(r * e, mul_add(e, 0.375f, 0.5f), r);
}

/// e^x. Domain: all x. Below -87 the result is 0, above 88 it is e^88 (1.65e38), of NaN it is e^-87
/// (1.65e-38). Maximum error on [-87, 88]: 9e-8 relative.
/// Source: argument reduction x = k ln 2 + r after Cody and Waite 1980, with ln 2 in two parts so
/// that k * ln2_high is exact; Taylor coefficients to r^7 on |r| <= ln(2)/2.
inline Batch exp(Batch x) {
  const auto ints = hn::RebindToSigned<Batch::Tag>();
  const Batch clamped = min(max(x, -87.0f), 88.0f);
  // Adding 1.5 * 2^23 rounds to a whole number, which then stands in the lowest bits.
  const Batch whole(12582912.0f), shifted = mul_add(clamped, 1.44269504f, whole);
  const Batch k = shifted - whole;
  const Batch r = mul_add(k, 2.12194440e-4f, mul_add(k, -0.693359375f, clamped));
  // In pairs, not by Horner's rule: the chain of dependent operations is half as long.
  const Batch r2 = r * r;
  const Batch high =
      mul_add(mul_add(r, 1.0 / 5040, 1.0 / 720), r2, mul_add(r, 1.0 / 120, 1.0 / 24));
  const Batch p = mul_add(mul_add(high, r2, mul_add(r, 1.0 / 6, 0.5)), r2, r) + 1.0f;
  const auto exponent = hn::ShiftLeft<23>(hn::BitCast(ints, shifted.raw));
  const Batch scaled = hn::BitCast(Batch::tag, hn::Add(hn::BitCast(ints, p.raw), exponent));
  return select(x < -87.0f, 0.0f, scaled);
}

/// log(x + low), where low is what rounding to x has dropped: |low| <= 2^-24 x. Domain: x from
/// 2^-126 to sqrt(2), or to infinity where low is 0. Maximum error: 1.3e-7 relative where x >=
/// sqrt(1/2); below, where low matters less and is only partly heeded, 2e-7.
/// Source: x = 2^k m with m in [sqrt(1/2), sqrt(2)); log m = 2 atanh((m-1)/(m+1)) as an odd series,
/// whose truncation error at the ends of the interval is below 2e-9.
inline Batch log_sum(Batch x, Batch low) {
  const auto ints = hn::RebindToSigned<Batch::Tag>();
  // 0x3f3504f3 is sqrt(1/2): what is left of it after whole powers of two goes to k.
  const auto sqrt_half = hn::Set(ints, 0x3f3504f3);
  const auto above = hn::Sub(hn::BitCast(ints, x.raw), sqrt_half);
  const Batch k = hn::ConvertTo(Batch::tag, hn::ShiftRight<23>(above));
  const auto mantissa = hn::And(above, hn::Set(ints, 0x007fffff));
  const Batch m = hn::BitCast(Batch::tag, hn::Add(mantissa, sqrt_half));
  const Batch f = (m - 1.0f) + low;
  const Batch s = f * reciprocal(m + 1.0f);
  const Batch s2 = s * s;
  const Batch p = mul_add(mul_add(s2, 2.0 / 9, 2.0 / 7), s2 * s2, mul_add(s2, 2.0 / 5, 2.0 / 3));
  // 2 atanh(s) = f - s f + s^3 p, because 2 s = f - s f: the leading term f is exact.
  const Batch tail = mul_add(s * s2, p, mul_add(k, -2.12194440e-4f, -(s * f)));
  return mul_add(k, 0.693359375f, f + tail);
}

/// Natural logarithm. Domain: x from 2^-126 to the largest float. Anything below, zero, negative
/// and NaN included, gives log(2^-126) = -87.34; infinity gives log(2^128) = 88.72.
/// Maximum error: 9e-8 relative.
inline Batch log(Batch x) { return log_sum(max(x, 1.17549435e-38f), 0.0f); }

/// x^y for x >= 0. Maximum error: (1 + |y log x|) * 1.4e-7 relative. Results below e^-87 are 0,
/// results above e^88 are e^88; pow(0, y) is 0 but pow(x, 0) = 1 also at x = 0, as std::pow has it;
/// negative x is taken for 0, positive x below 2^-126 for 2^-126.
inline Batch pow(Batch x, Batch y) {
  const Batch power = exp(y * log(x));
  return select(x <= 0.0f, select(abs(y) <= 0.0f, 1.0f, 0.0f), power);
}

}  // namespace HWY_NAMESPACE
}  // namespace scanlit
