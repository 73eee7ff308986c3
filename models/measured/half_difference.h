// The half-difference angles in which isotropic measured tables are stored: where the half vector H
// lies, and where the light lies as seen from H. A highlight is near theta_h = 0 whatever the
// light.
//
// Szymon M. Rusinkiewicz, "A new change of variables for efficient BRDF representation", EGWR 1998.
//
//   theta_h   angle of N and H
//   theta_d   angle of H and L (and of H and V)
//   phi_d     azimuth of L about H; 0 where L leaves H away from N
//
// The paper turns L by -phi_h about z and by -theta_h about y. With S = L + V and D = L - V, which
// are perpendicular, the same angles need no turning and, on an isotropic surface, no tangent:
//
//   tan theta_h = |N x S| / N.S     tan theta_d = |D| / |S|     tan phi_d = (N x S).D / (-N.D |S|)
//
// Written as arc tangents they lose no digits at theta_h = 0 or L = V, where arc cosines would.
#pragma once

#include <cmath>

#include "rasterizer/batch_trigonometry.h"
#include "rasterizer/reflection_model.h"
#include "rasterizer/scalar_math.h"

namespace scanlit::models {

/// In radians: theta_h and theta_d in [0, pi/2] where L and V are above the horizon, phi_d in
/// [-pi, pi]. phi_d has no meaning, and is any number, where N = H or L = V.
template <class T>
struct HalfDifference {
  T theta_h, theta_d, phi_d;
};

/// Of unit n, l and v, in any one space.
template <class T>
HalfDifference<T> half_difference(const Vec3<T>& n, const Vec3<T>& l, const Vec3<T>& v) {
  const Vec3<T> s = l + v, d = l - v, n_s = cross(n, s);
  const T s_length = sqrt(dot(s, s));
  return {.theta_h = atan2(sqrt(dot(n_s, n_s)), dot(n, s)),
          .theta_d = atan2(sqrt(dot(d, d)), s_length),
          .phi_d = atan2(dot(n_s, d), -dot(n, d) * s_length)};
}

/// Directions in the shading frame.
struct LightAndViewer {
  Vec3<double> l, v;
};

/// The way back, with H turned by phi_h about the normal.
inline LightAndViewer directions(const HalfDifference<double>& angles, double phi_h = 0) {
  const double sin_h = std::sin(angles.theta_h), cos_h = std::cos(angles.theta_h);
  const double sin_d = std::sin(angles.theta_d), cos_d = std::cos(angles.theta_d);
  // Along H, and across it: x away from N in the plane of N and H, y perpendicular to both.
  const Vec3<double> h = {sin_h * std::cos(phi_h), sin_h * std::sin(phi_h), cos_h};
  const Vec3<double> x = {cos_h * std::cos(phi_h), cos_h * std::sin(phi_h), -sin_h};
  const Vec3<double> y = {-std::sin(phi_h), std::cos(phi_h), 0};
  const Vec3<double> across = sin_d * (x * std::cos(angles.phi_d) + y * std::sin(angles.phi_d));
  return {.l = cos_d * h + across, .v = cos_d * h - across};
}

/// The viewer, or, where it is below the engine's clamp of N.V, the one at the clamp: what is
/// visible is not black because an interpolated normal tilts away from the viewer.
template <class T>
Vec3<T> visible(const Vec3<T>& n, const Vec3<T>& v) {
  const Vec3<T> lifted = v + n * max(T(min_n_v) - dot(n, v), T(0));
  return lifted * (T(1) / sqrt(max(dot(lifted, lifted), T(1e-20))));  // 0/0 for v = 0 without
}

}  // namespace scanlit::models
