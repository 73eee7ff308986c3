// Directional albedo: the share of the light from one direction that a surface reflects, or, by
// reciprocity, how bright it looks from there in a white furnace.
//
//   albedo(v) = integral of f_r(l, v) (n.l) over the hemisphere of l
//
// The integral is taken over half vectors, in polar angles about the normal: there the lobe of
// every microfacet model, and of both Phongs, is centred at 0 for every v.
#pragma once

#include <cstdint>

#include "rasterizer/reflection_model.h"

namespace scanlit::models {

struct Albedo {
  Rgb<double> value;
  Rgb<double> error;  // absolute; estimated, and on the safe side: see albedo.cpp
  std::int64_t evaluations = 0;
};

/// The albedo towards v (unit, shading frame; below the horizon it is 0), by adaptive cubature
/// until the estimated error of each channel is at most `tolerance`, or `max_evaluations` are used
/// up: the error then says how far it got. Also for lobes as sharp as n = 1e5 or m = .001, at any
/// angle, and wherever the lobe is: it is searched for. The point of the surface is the origin.
Albedo directional_albedo(const ReflectionModel& model, const Vec3<double>& v,
                          double tolerance = 1e-6, std::int64_t max_evaluations = 20'000'000);

}  // namespace scanlit::models
