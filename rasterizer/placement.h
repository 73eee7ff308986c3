// (9) Where the points of a span are in the world, and from where they are seen: what the model's
// span is made of besides the surface itself.
#pragma once

#include "rasterizer/surface.h"

namespace scanlit {

/// World space. What nobody needs is left as it is.
struct Places {
  alignas(cache_line) float position[3][SurfaceSpan::padded];
  float to_viewer[3][SurfaceSpan::padded];  // unit
};

/// Whether positions come to world space.
inline bool places_positions(const Frame& frame, const Draw& draw) {
  return draw.illumination.near_lights || !frame.settings.skips.unused_attributes;
}

/// Brings `surface.normal` to world space, unit, and fills `places`. A normal of no length is taken
/// to face the viewer.
void place(const Frame& frame, const Draw& draw, SurfaceSpan& surface, Places& places);

}  // namespace scanlit
