// Directions by their angles.
#pragma once

#include <cmath>

#include "rasterizer/vec.h"

namespace scanlit::models {

/// Unit, in the shading frame: theta from the normal, phi from the tangent towards the bitangent,
/// in radians.
inline Vec3<double> spherical_direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

}  // namespace scanlit::models
