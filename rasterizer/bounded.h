// Bounded: not a number but what is known of one that changes along a row of pixels. The value lies
// in an interval; slope and curvature say how fast it may change. A formula written once as a
// template is evaluated over it as over double or Batch, and then says of a whole triangle what it
// says of a point: in which range its result lies, and how far a straight line may miss it. As in a
// Batch, each lane is a number of its own.
//
// With t the distance along the row, in any unit, X(t) a function of it, and a, b any two places:
//
//   lo <= X(t) <= hi
//   |X(a) - X(b)|   <= slope |a - b|               1e30 (no_limit): X may jump
//   |X'(a) - X'(b)| <= curvature |a - b| + kink    as min and max have kinks, however many
//
// so that the straight line from X(a) to X(b) misses X between them, h = |b - a|, by at most
//
//   min(h^2 / 8 curvature + h / 4 kink, h / 2 slope, hi - lo)                     (missed_by below)
//
// Its first term is the error of linear interpolation where X' is Lipschitz. Its second: what X has
// gained over the line rises at a rate p for a time and falls at a rate q for the rest, and p + q
// is at most the kink. Where nothing is known the interval is all numbers and the slope is NaN, and
// so is that of whatever depends on it.
//
// Rounding. Intervals are rounded outwards: after each operation by more than twice its maximum
// error in Batch, so that the interval holds the exact result and Batch's own. Slopes and
// curvatures are sums of products of numbers that are not negative: each operation makes them too
// small by at most 2^-23, and no formula has 8,000 in a row: `rounding_slack` makes good for that,
// once, at the end.
//
// Interval arithmetic: Ramon E. Moore, "Interval Analysis", 1966. The chain rule to second order,
// carried along with the value: Louis B. Rall, "Automatic Differentiation", 1981.
#pragma once

#include <limits>

#include "rasterizer/batch.h"
#include "rasterizer/batch_trigonometry.h"

namespace scanlit {
inline namespace HWY_NAMESPACE {

/// What is known of a condition: where `yes`, it holds; where `no`, it does not; else either.
struct Undecided {
  Batch::Mask yes, no;

  friend Undecided operator&(const Undecided& a, const Undecided& b) {
    return {a.yes & b.yes, a.no | b.no};
  }
  friend Undecided operator|(const Undecided& a, const Undecided& b) {
    return {a.yes | b.yes, a.no & b.no};
  }
};

class Bounded {
 public:
  static constexpr float no_limit = 1e30f;
  static constexpr float rounding_slack = 1.001f;
  /// Twice the maximum relative error of Batch's operations, and what is added where the result
  /// may be subnormal and become 0.
  static constexpr float padding = 3e-7f, least = 1e-37f;

  Batch lo, hi;
  Batch slope = 0, curvature = 0, kink = 0;

  Bounded() : lo(0), hi(0) {}
  Bounded(Batch constant) : lo(constant), hi(constant) {}
  Bounded(float constant) : Bounded(Batch(constant)) {}
  /// A double that float does not hold is rounded by the other types.
  Bounded(double constant) : Bounded(Batch(constant)) {
    if (double(float(constant)) != constant) *this = rounded_outwards(lo, hi, padding);
  }
  Bounded(int constant) : Bounded(Batch(constant)) {}
  Bounded(Batch least_value, Batch greatest, Batch max_slope, Batch max_curvature,
          Batch max_kink = 0)
      : lo(least_value), hi(greatest), slope(max_slope), curvature(max_curvature), kink(max_kink) {}

  /// From the bounds that a Batch gives, whose error is at most `relative`, half the padding.
  static Bounded rounded_outwards(Batch lo, Batch hi, Batch relative, Batch slope = 0,
                                  Batch curvature = 0, Batch kink = 0) {
    return {lo - mul_add(abs(lo), relative, least), hi + mul_add(abs(hi), relative, least), slope,
            curvature, kink};
  }
  /// The same, with an interval that is wider by so much.
  Bounded widened(Batch relative) const {
    return rounded_outwards(lo, hi, relative, slope, curvature, kink);
  }
  /// Anything from lo to hi, that may jump.
  static Bounded between(Batch lo, Batch hi) { return {lo, hi, no_limit, no_limit}; }

  /// The greatest |X|.
  Batch magnitude() const { return max(abs(lo), abs(hi)); }
  /// The least |X|; 0 or less where X may be 0.
  Batch least_magnitude() const { return max(lo, -hi); }

  friend Bounded operator-(const Bounded& a) {
    return {-a.hi, -a.lo, a.slope, a.curvature, a.kink};
  }
  [[gnu::always_inline]] friend Bounded operator+(const Bounded& a, const Bounded& b) {
    return rounded_outwards(a.lo + b.lo, a.hi + b.hi, padding, a.slope + b.slope,
                            a.curvature + b.curvature, a.kink + b.kink);
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }
  [[gnu::always_inline]] friend Bounded operator*(const Bounded& a, const Bounded& b) {
    if (&a == &b) return square(a);  // x * x is not negative, which [-1, 1] [-1, 1] would be
    const Batch p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
    const Batch size_a = a.magnitude(), size_b = b.magnitude();
    return rounded_outwards(
        min(min(p, q), min(r, s)), max(max(p, q), max(r, s)), padding,
        size_a * b.slope + a.slope * size_b,
        size_a * b.curvature + Batch(2) * a.slope * b.slope + a.curvature * size_b,
        size_a * b.kink + a.kink * size_b);
  }
  friend Bounded operator/(const Bounded& a, const Bounded& b) { return a * reciprocal(b); }
  Bounded& operator+=(const Bounded& b) { return *this = *this + b; }

  [[gnu::always_inline]] friend Bounded square(const Bounded& a) {
    const Batch size = a.magnitude(), smallest = max(a.least_magnitude(), Batch(0));
    return rounded_outwards(smallest * smallest, size * size, padding, Batch(2) * size * a.slope,
                            Batch(2) * (a.slope * a.slope + size * a.curvature),
                            Batch(2) * size * a.kink);
  }

  /// f of a monotonically growing f whose values are [lo, hi], with |f'| and |f''| at most these.
  friend Bounded chain(const Bounded& a, const Bounded& f, Batch first, Batch second) {
    return {f.lo, f.hi, first * a.slope, first * a.curvature + second * a.slope * a.slope,
            first * a.kink};
  }

  friend Bounded reciprocal(const Bounded& a) {
    const Batch smallest = a.least_magnitude(), r = Batch(1) / smallest, r2 = r * r;
    const Batch from = Batch(1) / a.lo, to = Batch(1) / a.hi;
    const Bounded result =
        chain(a, rounded_outwards(min(from, to), max(from, to), padding), r2, Batch(2) * r2 * r);
    return known_where(smallest > Batch(0), result);
  }
  friend Bounded sqrt(const Bounded& a) {
    // The slope is infinite at 0: from 1e-20 on down it is only said that the root is between.
    const Batch lo = max(a.lo, Batch(0)), r = Batch(0.5) / sqrt(max(lo, Batch(1e-20f)));
    const Bounded root = rounded_outwards(sqrt(lo), sqrt(max(a.hi, Batch(0))), padding);
    const Bounded smooth = chain(a, root, r, Batch(2) * r * r * r);
    const auto steep = lo < Batch(1e-20f);
    return {root.lo, root.hi,
            select(steep, smooth.slope * Batch(0) + Batch(no_limit), smooth.slope),
            select(steep, no_limit, smooth.curvature), smooth.kink};
  }
  friend Bounded inverse_sqrt(const Bounded& a) { return reciprocal(sqrt(a)); }
  friend Bounded mul_add(const Bounded& a, const Bounded& b, const Bounded& c) { return a * b + c; }

  friend Undecided operator<(const Bounded& a, const Bounded& b) {
    return {a.hi < b.lo, a.lo >= b.hi};
  }
  friend Undecided operator<=(const Bounded& a, const Bounded& b) {
    return {a.hi <= b.lo, a.lo > b.hi};
  }
  friend Undecided operator>(const Bounded& a, const Bounded& b) { return b < a; }
  friend Undecided operator>=(const Bounded& a, const Bounded& b) { return b <= a; }

  /// Where it is not decided the result may jump from one to the other.
  friend Bounded select(const Undecided& m, const Bounded& a, const Bounded& b) {
    const Batch either = no_limit + Batch(0) * (a.slope + b.slope);
    const Bounded hull{min(a.lo, b.lo), max(a.hi, b.hi), either, no_limit};
    return pick(m.yes, a, pick(m.no, b, hull));
  }
  /// Where it is not decided there may be kinks, but no jump.
  friend Bounded min(const Bounded& a, const Bounded& b) {
    return decided(a.hi <= b.lo, a, b.hi <= a.lo, b, min(a.lo, b.lo), min(a.hi, b.hi));
  }
  friend Bounded max(const Bounded& a, const Bounded& b) {
    return decided(b.hi <= a.lo, a, a.hi <= b.lo, b, max(a.lo, b.lo), max(a.hi, b.hi));
  }
  friend Bounded abs(const Bounded& a) {
    return decided(a.lo >= Batch(0), a, a.hi <= Batch(0), -a, 0, a.magnitude());
  }
  friend Bounded floor(const Bounded& a) {
    const Batch from = floor(a.lo), to = floor(a.hi), unknown = Batch(0) * a.slope;
    const Batch limit = select(from >= to, Batch(0), Batch(no_limit)) + unknown;
    return {from, to, limit, limit};
  }

  friend Bounded pick(Batch::Mask m, const Bounded& a, const Bounded& b) {
    return {select(m, a.lo, b.lo), select(m, a.hi, b.hi), select(m, a.slope, b.slope),
            select(m, a.curvature, b.curvature), select(m, a.kink, b.kink)};
  }
  /// `a`, of which elsewhere nothing is known.
  friend Bounded known_where(Batch::Mask m, const Bounded& a) {
    const Batch nan = std::numeric_limits<float>::quiet_NaN();
    return {select(m, a.lo, Batch(-no_limit)), select(m, a.hi, Batch(no_limit)),
            select(m, a.slope, nan), select(m, a.curvature, nan), a.kink};
  }

 private:
  /// From lo to hi, where neither a nor b is certain: from the one's slope to the other's.
  static Bounded decided(Batch::Mask is_a, const Bounded& a, Batch::Mask is_b, const Bounded& b,
                         Batch lo, Batch hi) {
    const Batch turn = a.slope + b.slope, bend = a.curvature + b.curvature;
    // Batch's max may drop a NaN.
    const Bounded either{lo, hi, max(a.slope, b.slope) + Batch(0) * turn,
                         max(a.curvature, b.curvature) + Batch(0) * bend,
                         max(a.kink, b.kink) + turn};
    return pick(is_a, a, pick(is_b, b, either));
  }
};

/// What of its rates of change X is missed by, when it is interpolated between known places.
struct Spacing {
  float curvature, kink, slope;

  /// A straight line between two places so far apart.
  static constexpr Spacing of(float h) { return {h * h / 8, h / 4, h / 2}; }
};

/// How far X is missed at most. NaN where nothing is known.
inline Batch missed_by(const Bounded& x, const Spacing& spacing) {
  const Batch smooth = mul_add(spacing.curvature, x.curvature, Batch(spacing.kink) * x.kink);
  const Batch steep = Batch(spacing.slope) * x.slope;
  // Batch's min gives its second argument where either is NaN.
  const Batch least = min(min(smooth, steep), x.hi - x.lo);
  return Batch(Bounded::rounding_slack) * least + Batch(0) * x.slope;
}

}  // namespace HWY_NAMESPACE
}  // namespace scanlit
