// (9) By how much a straight line along a row misses what the lights make of a triangle. For
// strides.h.
#pragma once

#include "rasterizer/screen_group.h"

namespace scanlit {

constexpr int strides[] = {2, 4, 8, 16};
constexpr int stride_count = 4;

/// What the triangles' colours do along a row, summed over the lights.
struct Misses {
  Batch least[3];                 // the colour is at least this
  Batch missed[stride_count][3];  // by a straight line between pixels so far apart
};

/// Adds a light to `sum`; false where nothing is known of the model. n, v and position are those
/// of the group's cells, in world space.
bool add_light(const ReflectionModel& model, const LightSource& light, const ScreenGroup& group,
               const BoundedDirection& n, const BoundedDirection& v, const BoundedVector& position,
               Misses& sum);

}  // namespace scanlit
