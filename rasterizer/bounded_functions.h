// exp, log, pow and trigonometry of Bounded numbers. Each gives the interval of a function that is
// monotonic there, padded by more than twice the error that Batch's own states, and the largest
// first and second derivative in it.
#pragma once

#include "rasterizer/bounded.h"
#include "rasterizer/cosines.h"

namespace scanlit {
inline namespace HWY_NAMESPACE {

inline Bounded exp(const Bounded& x) {
  const Batch hi = exp(x.hi);
  return chain(x, Bounded::rounded_outwards(exp(x.lo), hi, Bounded::padding), hi, hi);
}

/// e^-x of a sum of squares, near enough: of an x >= 0 with x'^2 <= steepness x, of whose x'' a
/// part is not negative and at most `convex`. So x' is small where the exponential is large, and in
/// e^-x (x'^2 - x'') the two do not add up. Of y e^-y and y e^-2y the largest are at 1 and 1/2.
inline Bounded exp_minus(const Bounded& x, const Batch& steepness, const Batch& convex) {
  const Batch from = max(x.lo, Batch(0)), to = max(x.hi, Batch(0)), hi = exp(-from), hi2 = hi * hi;
  const Batch y_e_y = select(from >= Batch(1), from * hi, min(to * hi, Batch(0.36788f)));
  const Batch y_e_2y = select(from >= Batch(0.5f), from * hi2, min(to * hi2, Batch(0.18394f)));
  const Batch slope = min(sqrt(steepness * y_e_2y), hi * x.slope) + Batch(0) * x.slope;
  const Batch steep = min(steepness * y_e_y, hi * x.slope * x.slope);
  const Batch rest = max(x.curvature - convex, Batch(0));
  return Bounded::rounded_outwards(exp(-to), hi, mul_add(to, 6e-7f, Bounded::padding), slope,
                                   mul_add(hi, rest, max(steep, hi * convex)), hi * x.kink);
}

/// Nothing is known where x may be 0.
inline Bounded log(const Bounded& x) {
  const Batch r = Batch(1) / x.lo;
  const Bounded log_x = Bounded::rounded_outwards(log(x.lo), log(x.hi), Bounded::padding);
  return known_where(x.lo > Batch(1e-30f), chain(x, log_x, r, r * r));
}
inline Bounded log_sum(const Bounded& x, const Bounded& low) { return log(x + low); }

/// x^n from the logarithms of its ends: the derivatives n x^(n-1) and n (n-1) x^(n-2) are monotonic
/// too, and so largest at one end. The power magnifies the error of the logarithm.
inline Bounded power_of_logs(const Bounded& x, const Batch& log_lo, const Batch& log_hi,
                             const Batch& n) {
  const auto largest = [&](const Batch& m) { return max(exp(m * log_lo), exp(m * log_hi)); };
  const Batch a = exp(n * log_lo), b = exp(n * log_hi);
  const auto padding = [&](const Batch& log_x) {
    return mul_add(abs(n * log_x), 6e-7f, Bounded::padding);
  };
  const Batch lo = min(a, b), hi = max(a, b);  // n < 0: falling
  const Batch relative = min(max(padding(log_lo), padding(log_hi)), Batch(1));
  const Batch fall = abs(n), bend = abs(n * (n - Batch(1)));
  return chain(x, Bounded::rounded_outwards(lo, hi, relative), fall * largest(n - Batch(1)),
               bend * largest(n - Batch(2)));
}

/// x^y, x >= 0. Negative x is taken for 0, as Batch does.
inline Bounded pow(const Bounded& x, const Bounded& y) {
  // At 0 the derivatives of a low power are infinite; at 1e-20 they are as good as that.
  const Batch lo = max(x.lo, Batch(1e-20f)), hi = max(x.hi, Batch(1e-20f));
  const auto constant = (y.slope <= Batch(0)) & (y.hi - y.lo <= abs(y.hi) * Batch(1e-6f));
  Bounded fixed = power_of_logs(x, log(lo), log(hi), y.hi);
  // What the power of a parameter's rounding adds.
  const Batch loose = abs(y.hi * log(lo)) * Batch(1e-6f);
  fixed = pick(constant, fixed.widened(min(loose, Batch(1))), fixed);
  // 0^y is 0 for y > 0, but not for y < 0, where it is said to be 0 and is about to be infinite.
  fixed.lo = select(x.lo <= Batch(1e-20f), min(fixed.lo, Batch(0)), fixed.lo);
  return pick(constant, fixed, exp(y * log(x)));
}

/// cos^n from the versine, as for the other types: the rounding of the cosine is not magnified.
inline Bounded pow(const Cosine<Bounded>& c, const Bounded& n) {
  const auto log_of = [](const Batch& versine) {
    const Batch rounded = max(Batch(1) - versine, Batch(1e-20f));
    const Batch lost = select(versine < Batch(1), (Batch(1) - rounded) - versine, Batch(0));
    return log_sum(rounded, lost);
  };
  const Bounded& u = c.versine;
  const Batch log_lo = log_of(u.hi), log_hi = log_of(max(u.lo, Batch(0)));
  Bounded power = power_of_logs(u, log_lo, log_hi, n.hi);
  // Where Batch multiplies the cosine instead (cosines.h), it magnifies the cosine's rounding.
  const Batch multiplied = select(n.hi <= Batch(64), n.hi * Batch(2e-7f), Batch(0));
  const Batch loose = min(mul_add(abs(n.hi * log_lo), 1e-6f, multiplied), Batch(1));
  power = power.widened(loose);
  // At and below 0 the power is 0; for n = 0 it is 1, or 0.
  power.lo = select(u.hi >= Batch(1), min(power.lo, Batch(0)), power.lo);
  const auto kink = (u.hi >= Batch(1)) & (n.lo < Batch(2)), jump = kink & (n.lo < Batch(1));
  power.curvature = select(kink, Batch(Bounded::no_limit), power.curvature);
  power.slope = select(jump, Batch(Bounded::no_limit) + Batch(0) * power.slope, power.slope);
  const auto fixed = (n.slope <= Batch(0)) & (n.hi - n.lo <= n.hi * Batch(1e-6f));
  const auto varied = [&] { return exp(n * log(max(c.cos, Bounded(1e-20f)))); };
  if (none((n.slope > Batch(0)) | (n.hi - n.lo > n.hi * Batch(1e-6f)))) return power;
  return pick(fixed, power, varied());
}

/// In it nothing is lost by taking the middle, because |sin'| and |sin''| are at most 1.
inline Bounded sin(const Bounded& x) {
  const Batch middle = Batch(0.5) * (x.lo + x.hi), value = sin(middle);
  const Batch away = mul_add(Batch(0.5), x.hi - x.lo, mul_add(x.magnitude(), 3e-7f, 5e-7f));
  const Batch one(1.000001f);  // Batch's sine exceeds 1 by rounding
  const Bounded result{max(value - away, -one), min(value + away, one), x.slope,
                       x.curvature + x.slope * x.slope, x.kink};
  const auto far = x.magnitude() > Batch(1e4f);  // where Batch clamps
  return pick(far, {-one, one, x.slope, Bounded::no_limit}, result);
}
inline Bounded cos(const Bounded& x) { return sin(x + Bounded(1.5707963267948966)); }

/// Clamped to [-1, 1], where the slope is infinite.
inline Bounded asin(const Bounded& x) {
  const Batch size = x.magnitude(), room = (Batch(1) - size) * (Batch(1) + size);
  const Batch r = Batch(1) / sqrt(max(room, Batch(1e-12f)));
  const Bounded angle = Bounded::rounded_outwards(asin(x.lo), asin(x.hi), 7e-7f);
  const Bounded smooth = chain(x, angle, r, size * r * r * r);
  const auto steep = room < Batch(1e-12f);
  const Batch limit = Batch(Bounded::no_limit) + Batch(0) * x.slope;
  return {angle.lo, angle.hi, select(steep, limit, smooth.slope),
          select(steep, limit, smooth.curvature), smooth.kink};
}
inline Bounded acos(const Bounded& x) { return Bounded(1.5707963267948966) - asin(x); }

/// The angle's square from the versine u: with cos a = 1 - u, d(a^2)/du = 2 a / sin a and its
/// derivative 2 (1 - a cot a) / sin^2 a. Both grow with the angle, up to pi and 2 at pi/2; beyond
/// nothing is known.
inline Bounded angle2(const Cosine<Bounded>& c) {
  const Bounded& u = c.versine;
  const auto angle_of = [](const Batch& versine) {
    return Batch(2) * asin(sqrt(Batch(0.5) * max(versine, Batch(0))));
  };
  const Batch from = angle_of(u.lo), to = angle_of(u.hi);
  const Bounded value = Bounded::rounded_outwards(from * from, to * to, 2e-6f);
  const Batch versine = max(u.hi, Batch(1e-12f)), a = angle_of(versine);
  const Batch first = Batch(2.00001f) * a / sqrt(versine * (Batch(2) - versine));
  return known_where(u.hi <= Batch(1.00001f), chain(u, value, first, 2.0001f));
}
inline Bounded angle(const Cosine<Bounded>& c) { return sqrt(angle2(c)); }

/// Nothing but the range is known where (x, y) may be the origin or cross the negative x axis,
/// where the angle jumps.
inline Bounded atan2(const Bounded& y, const Bounded& x) {
  const Batch a = atan2(y.lo, x.lo), b = atan2(y.lo, x.hi), c = atan2(y.hi, x.lo),
              d = atan2(y.hi, x.hi);
  const Batch away_x = max(x.least_magnitude(), Batch(0)),
              away_y = max(y.least_magnitude(), Batch(0));
  const Batch r2 = mul_add(away_x, away_x, away_y * away_y), r = Batch(1) / sqrt(r2);
  const Batch speed = (x.slope + y.slope) * r,
              turn = (x.curvature + y.curvature) * r + speed * speed;
  const Bounded smooth =
      Bounded::rounded_outwards(min(min(a, b), min(c, d)), max(max(a, b), max(c, d)), 6e-7f, speed,
                                turn, (x.kink + y.kink) * r);
  const Batch pi(3.1415930f), limit = Batch(Bounded::no_limit) + Batch(0) * (x.slope + y.slope);
  const auto apart = (r2 > Batch(1e-30f)) & ((x.lo > Batch(0)) | (y.least_magnitude() > Batch(0)));
  return pick(apart, smooth, {-pi, pi, limit, limit});
}

}  // namespace HWY_NAMESPACE
}  // namespace scanlit
