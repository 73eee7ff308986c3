// Bounds of the directions that a reflection model sees across a triangle, as cones: and from them
// of its cosines. Each lane is a triangle; `t`, of which slopes speak, is the distance along a row,
// in pixels (bounded.h).
//
// With unit vectors a(t) and b(t), (a.b)' = a'.b + a.b'. As a' is perpendicular to a, |a'.b| is at
// most |a'| sin(a, b): near the top of a lobe, where a = b, the cosine hardly changes. A unit
// vector's a'' has the part -|a'|^2 along a; `turning` is what it has across a.
#pragma once

#include "rasterizer/batch_vec.h"
#include "rasterizer/bounded_functions.h"

namespace scanlit {
inline namespace HWY_NAMESPACE {

/// A vector X(t) of any length.
struct BoundedVector {
  Vec3<Batch> centre;
  Batch radius;          // |X - centre|, at most
  Vec3<Batch> velocity;  // X', ...
  Batch unsteadiness;    // ... which is off by at most so much
  Batch acceleration;    // |X''|, at most
};

/// The way from a moving point to a fixed one.
inline BoundedVector towards(const Vec3<Batch>& end, const BoundedVector& from) {
  return {end - from.centre, from.radius, -from.velocity, from.unsteadiness, from.acceleration};
}

/// How fast a vector grows longer, and how fast it swings round; at most.
struct Motion {
  Batch length, least;   // of the centre; of X
  Vec3<Batch> centre;    // unit
  Batch sine;            // of the angle between X and the centre, at most
  Vec3<Batch> sideways;  // the velocity across the centre
  Batch along, across;
  Batch unsteadiness;  // of the velocity across X

  explicit Motion(const BoundedVector& x) : length(sqrt(dot(x.centre, x.centre))) {
    least = length - x.radius;
    const Batch inverse = Batch(1) / length;
    centre = x.centre * inverse;
    sine = x.radius * inverse;
    const Batch forward = dot(x.velocity, centre);
    sideways = x.velocity - centre * forward;
    const Batch side = sqrt(dot(sideways, sideways));
    along = abs(forward) + side * sine + x.unsteadiness;
    across = side + abs(forward) * sine + x.unsteadiness;
    // Projected along X, not along the centre: a difference of at most the sine.
    unsteadiness = (abs(forward) + side) * sine + x.unsteadiness;
  }

  /// Else X may point anywhere, or nearly so.
  Batch::Mask has_direction() const {
    return (sine < Batch(0.5f)) & scanlit::has_direction(least * least);
  }
};

inline Bounded length(const BoundedVector& x) {
  const Motion motion(x);
  const Bounded result =
      Bounded::rounded_outwards(motion.least, motion.length + x.radius, Batch(1e-6f), motion.along,
                                x.acceleration + motion.across * motion.across / motion.least);
  return known_where(motion.has_direction(), result);
}

/// A unit vector. Where `speed` is NaN nothing is known.
struct BoundedDirection {
  Vec3<Batch> centre;                       // unit
  Batch reach = 0, speed = 0, turning = 0;  // |a - centre|, |a'|, |a''| across a: at most
  Vec3<Batch> velocity{};                   // across the centre: a', ...
  Batch unsteadiness = 0;                   // ... which is off by at most so much

  Batch bend() const { return mul_add(speed, speed, turning); }  // |a''|, at most
};

inline BoundedDirection direction(const BoundedVector& x) {
  const Motion motion(x);
  const Batch inverse = Batch(1) / motion.least, nan = std::numeric_limits<float>::quiet_NaN();
  const Batch speed = select(motion.has_direction(), motion.across * inverse, nan);
  // Of 1 / |X| the centre's is taken: it is off by at most the sine times `inverse`.
  const Batch stretched = sqrt(dot(motion.sideways, motion.sideways)) * motion.sine;
  return {.centre = motion.centre,
          // The chord of an angle of up to 30 degrees is at most 1.036 times its sine.
          .reach = select(motion.has_direction(), Batch(1.04f) * motion.sine, Batch(2)),
          .speed = speed,
          .turning = (x.acceleration + Batch(2) * motion.along * speed) * inverse,
          .velocity = motion.sideways * (Batch(1) / motion.length),
          .unsteadiness = (motion.unsteadiness + stretched) * inverse};
}

/// a x b, and how fast it changes: |a x b - a0 x b0| <= |a - a0| + |b - b0|, and so on.
inline BoundedVector cross(const BoundedDirection& a, const BoundedDirection& b) {
  const Vec3<Batch>&v = a.velocity, &w = b.velocity;
  const Batch fast = sqrt(dot(v, v)), fast_w = sqrt(dot(w, w)), rounding(5e-7f);
  return {.centre = cross(a.centre, b.centre),
          .radius = a.reach + b.reach + rounding,
          .velocity = cross(v, b.centre) + cross(a.centre, w),
          .unsteadiness = a.unsteadiness + b.unsteadiness + fast * b.reach + fast_w * a.reach,
          .acceleration = a.bend() + b.bend() + Batch(2) * a.speed * b.speed};
}

/// L + V.
inline BoundedVector sum(const BoundedDirection& a, const BoundedDirection& b) {
  return {.centre = a.centre + b.centre,
          .radius = a.reach + b.reach,
          .velocity = a.velocity + b.velocity,
          .unsteadiness = a.unsteadiness + b.unsteadiness,
          .acceleration = a.bend() + b.bend()};
}

/// (a.b)' and (a.b)'', at most. Neither of a' and a has a part along the other: a'.b is that of a'
/// across a, times the sine of the angle. With V, W the velocities, off by u and w at most,
///
///   |a'.b + a.b'| <= |V.b0 + a0.W| + (|V| + |W|) (reaches) + (u + w) sine
///   a'' = turning - |a'|^2 a, and so (a.b)'' = turnings' sine + 2 a'.b' - (|a'|^2 + |b'|^2) cos
///
/// where V, W and the cosine's middle give the last two terms but for what they are off.
struct CosineChange {
  Batch slope, curvature;

  CosineChange(const BoundedDirection& a, const BoundedDirection& b, const Batch& sine,
               const Batch& lo, const Batch& hi) {
    const Vec3<Batch>&v = a.velocity, &w = b.velocity;
    const Batch v2 = dot(v, v), w2 = dot(w, w), fast = sqrt(v2), fast_w = sqrt(w2);
    const Batch u = a.unsteadiness, u_w = b.unsteadiness, half(0.5f), two(2);
    const Batch reach = a.reach + b.reach + Batch(2e-6f);
    const Batch directed = abs(dot(v, b.centre) + dot(a.centre, w)) + (fast + fast_w) * reach;
    slope = min(mul_add(u + u_w, sine, directed), (a.speed + b.speed) * sine) +
            Batch(0) * (a.speed + b.speed);

    const Batch steepest = min(Batch(1), max(abs(lo), abs(hi)));
    const Batch middle = two * dot(v, w) - (v2 + w2) * half * (lo + hi);
    const Batch off = two * (fast * u_w + fast_w * u + u * u_w) +
                      (u * (two * fast + u) + u_w * (two * fast_w + u_w)) * steepest;
    const Batch known = abs(middle) + (v2 + w2) * half * (hi - lo) + off;
    const Batch any = two * a.speed * b.speed + (a.speed * a.speed + b.speed * b.speed) * steepest;
    curvature = (a.turning + b.turning) * sine + min(known, any) + Batch(0) * any;
  }
};

/// Of the angle between two directions. The centres enclose theta, and each direction deviates from
/// its centre by an angle of at most 1.05 times its reach (for a reach of up to 1): the cosine lies
/// between those of theta - spread and theta + spread.
[[gnu::always_inline]] inline Cosine<Bounded> cosine(const BoundedDirection& a,
                                                     const BoundedDirection& b) {
  const Vec3<Batch> chord = a.centre - b.centre;
  const Batch reach = a.reach + b.reach, spread = Batch(1.05f) * reach;
  const Batch apart = sqrt(dot(chord, chord)), versine = Batch(0.5f) * apart * apart;
  const Batch cos = Batch(1) - versine, sin = sqrt(max(versine * (Batch(2) - versine), Batch(0)));
  const Batch rounding(2e-6f), room = sin * spread, bulge = Batch(0.5f) * spread * spread;
  const Batch lo = cos - room - max(cos, Batch(0)) * bulge - rounding;
  const Batch hi = cos + room + max(-cos, Batch(0)) * bulge + rounding;

  const Batch one(1), near = max(apart - reach, Batch(0)), far = apart + reach;
  const CosineChange change(a, b, min(one, sin + spread + rounding), max(lo, -one), min(hi, one));
  const Batch slope = change.slope, curvature = change.curvature;
  const auto wide = reach > one;
  // Near 0 the square of the chord is the sharper bound of the versine.
  const Bounded u(Batch(0.5f) * near * near * Batch(1 - 2e-6f),
                  min(Batch(0.5f) * far * far * Batch(1 + 2e-6f), one - lo), slope, curvature);
  return {
      .cos = {select(wide, -one, max(lo, -one)), select(wide, one, min(hi, one)), slope, curvature},
      .versine = {select(wide, Batch(0), u.lo), select(wide, Batch(2), u.hi), slope, curvature}};
}

/// As cosines() of cosines.h. V.H = |L + V| / 2.
inline Cosines<Bounded> cosines(const BoundedDirection& n, const BoundedDirection& l,
                                const BoundedDirection& v) {
  const BoundedVector s = sum(l, v);
  const Cosine<Bounded> n_l = cosine(n, l), n_v = cosine(n, v);
  return {.n_l = n_l.cos,
          .n_v = max(n_v.cos, Bounded(min_n_v)),
          .n_h = cosine(n, direction(s)),
          .v_h = min(Bounded(1), Bounded(0.5f) * length(s)),
          .n_l_versine = n_l.versine,
          .n_v_versine = min(n_v.versine, Bounded(1 - min_n_v))};
}

/// The axes of the shading frame.
struct BoundedAxes {
  BoundedDirection tangent, bitangent, normal;

  BoundedAxes() = default;
  /// As place_tangents() has them, from the way that the surface is brushed. Near the normal
  /// nothing is known: there the projection into the surface magnifies rounding, and then makes a
  /// choice.
  BoundedAxes(const BoundedDirection& n, const BoundedDirection& brushed) : normal(n) {
    BoundedVector across = cross(n, brushed);
    const Motion motion(across);
    across.radius = select(motion.least > Batch(0.1f), across.radius, Batch(Bounded::no_limit));
    bitangent = direction(across);
    tangent = direction(cross(bitangent, n));
  }
};

}  // namespace HWY_NAMESPACE

/// What ReflectionModel::bounds() is asked, and answers. Null: nothing is known of tangents.
struct BoundedCosines {
  Cosines<Bounded> cosines;
  const BoundedAxes* axes = nullptr;
  BoundedDirection l{}, v{};  // only with axes
};
inline ShadingFrame<Bounded> shading_frame(const BoundedCosines& in) {
  const auto local = [&](const BoundedDirection& d) -> Vec3<Bounded> {
    return {cosine(in.axes->tangent, d).cos, cosine(in.axes->bitangent, d).cos,
            cosine(in.axes->normal, d).cos};
  };
  return {.l = local(in.l), .v = local(in.v), .h = local(direction(sum(in.l, in.v)))};
}
struct BoundedReflection {
  Reflection<Bounded> value;
};

}  // namespace scanlit
