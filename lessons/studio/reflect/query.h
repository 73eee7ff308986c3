// Asking a model one question at a time, in double: directions by angle, both parts in one; and
// what the registry knows of it.
#pragma once

#include <algorithm>
#include <numbers>
#include <string>

#include "models/registry.h"
#include "models/spherical.h"

namespace scanlit::studio {

inline double radians_of(double degrees) { return degrees * std::numbers::pi / 180; }

/// In the shading frame: theta_deg from the normal, phi_deg from the tangent. A negative theta_deg
/// leans to the other side.
inline Vec3<double> direction_at(double theta_deg, double phi_deg) {
  return models::spherical_direction(radians_of(theta_deg), radians_of(phi_deg));
}

/// pi f_r (n.l), diffuse and glossy together.
inline Rgb<double> reflected(const ReflectionModel& model, const Vec3<double>& l,
                             const Vec3<double>& v) {
  const Reflection<double> value = model.evaluate(l, v);
  return value.diffuse + value.glossy;
}

/// Rec. 709, of linear light.
inline double luminance(const Rgb<double>& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

/// The registry's entry under this name; null where there is none.
inline const models::ModelInfo* find_info(const std::string& name) {
  const auto found = std::ranges::find(models::list(), name, &models::ModelInfo::name);
  return found == models::list().end() ? nullptr : &*found;
}
inline const models::ModelInfo* find_info(const models::NamedModel& model) {
  return find_info(models::parse_specification(model.specification).name);
}

/// D, G or F, which is looked at but reflects nothing.
inline bool is_part(const models::NamedModel& model) {
  const models::ModelInfo* info = find_info(model);
  return info && info->kind == models::Kind::part;
}

}  // namespace scanlit::studio
