// Trigonometry for Batch. acos, asin, sin, cos and atan are Highway's own (hwy/contrib/math: on a
// reduced argument, polynomials in Estrin's form), here with arguments kept inside their domain;
// atan2, which Highway lacks, is built on atan. scalar_math.h has the same for double and float.
//
// The errors stated hold with and without fused multiply-add.
#pragma once

#include <hwy/contrib/math/math-inl.h>

#include "rasterizer/batch.h"

namespace scanlit {
inline namespace HWY_NAMESPACE {

/// Radians in [0, pi]. x is clamped to [-1, 1]: the cosine of two rounded unit vectors may exceed
/// 1, where the angle would be NaN. Maximum error: 1.5e-7 relative, also where x is near 1 and the
/// angle near 0; but there a rounded cosine has lost the angle already, which angle(Cosine) has
/// not. NaN gives pi.
inline Batch acos(Batch x) { return hn::Acos(Batch::tag, min(max(x, -1.0f), 1.0f).raw); }

/// Radians in [-pi/2, pi/2]; x is clamped to [-1, 1]. Maximum error: 3e-7 relative, also near 0.
/// NaN gives -pi/2.
inline Batch asin(Batch x) { return hn::Asin(Batch::tag, min(max(x, -1.0f), 1.0f).raw); }

/// Sine and cosine of x in radians. Domain: |x| <= 1e4, to which x is clamped: beyond Highway's
/// domain (39000) the polynomial would give anything. Maximum error: 1.5e-7, absolute: a sine may
/// exceed 1 by so much.
inline Batch sin(Batch x) { return hn::Sin(Batch::tag, min(max(x, -1e4f), 1e4f).raw); }
inline Batch cos(Batch x) { return hn::Cos(Batch::tag, min(max(x, -1e4f), 1e4f).raw); }

/// The angle of the point (x, y) from the x axis, in radians in [-pi, pi], with the sign of y.
/// Domain: finite x and y. Maximum error: 2.5e-7 relative where the larger of |x| and |y| is at
/// least 2^-126; below, 0/0 is kept out and (0, 0) has the angle 0. As std::atan2, except that a
/// zero x has no sign.
inline Batch atan2(Batch y, Batch x) {
  const Batch ax = abs(x), ay = abs(y);
  const Batch ratio = min(ax, ay) / max(max(ax, ay), 1.17549435e-38f);
  const Batch octant = hn::Atan(Batch::tag, ratio.raw);
  const Batch quadrant = select(ay > ax, Batch(1.57079633f) - octant, octant);
  const Batch half = select(x < 0.0f, Batch(3.14159265f) - quadrant, quadrant);
  return hn::CopySign(half.raw, y.raw);
}

/// The largest whole number not above x; exact.
inline Batch floor(Batch x) { return hn::Floor(x.raw); }

}  // namespace HWY_NAMESPACE
}  // namespace scanlit
