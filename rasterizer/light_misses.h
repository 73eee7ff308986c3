// (8) By how much a straight line along a row misses what the lights make of a triangle. For
// strides.h.
#pragma once

#include <span>

#include "rasterizer/screen_group.h"

namespace scanlit {

constexpr double rounding_codes = 0.1;  // of all places that a colour is made of, together

/// What the colours of a vector of triangles do, summed over the lights, per channel.
struct Misses {
  static constexpr std::size_t most = 4;
  Batch least[3];         // the colour is at least this
  Batch missed[most][3];  // for each spacing
};

/// Finds them for up to Misses::most spacings, the narrowest first; false if it is certain that
/// none will do, or where nothing is known of the model.
bool add_lights(const Frame& frame, const Draw& draw, const ScreenGroup& group,
                const BoundedSurface& surface, std::span<const Spacing> spacings, Misses& sum);

/// Where RenderSettings::tolerance allows for what a spacing misses.
Batch::Mask within_tolerance(const Frame& frame, const Misses& sum, std::size_t spacing);

}  // namespace scanlit
