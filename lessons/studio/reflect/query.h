// Asking a model one question at a time, in double: directions by angle, both parts in one.
#pragma once

#include <cmath>
#include <numbers>

#include "rasterizer/reflection_model.h"

namespace scanlit::studio {

inline double radians_of(double degrees) { return degrees * std::numbers::pi / 180; }

/// In the shading frame: theta_deg from the normal, phi_deg from the tangent. A negative theta_deg
/// leans to the other side.
inline Vec3<double> direction_at(double theta_deg, double phi_deg) {
  const double theta = radians_of(theta_deg), phi = radians_of(phi_deg);
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// pi f_r (n.l), diffuse and glossy together.
inline Rgb<double> reflected(const ReflectionModel& model, const Vec3<double>& l,
                             const Vec3<double>& v) {
  const Reflection<double> value = model.evaluate(l, v);
  return value.diffuse + value.glossy;
}

/// Rec. 709, of linear light.
inline double luminance(const Rgb<double>& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

}  // namespace scanlit::studio
