// A2 as it should be, for any variant.
#pragma once

#include <cstdint>

#include "lessons/assignments/A2_clipping/clipping.h"

namespace scanlit::assignments::clipping {

using a2::Plane, a2::Polygon, a2::Vertex, a2::Weights;

struct ClipVariant {
  double window;   // less than 1, which would be the picture
  bool near_at_0;  // never the engine's own, which has near at z = w
  bool given_inv_w;
};
ClipVariant clip_variant(std::uint64_t seed);

double right_distance(const ClipVariant& variant, const Vertex& vertex, Plane plane);
Vertex right_cut(const Vertex& inside, const Vertex& outside, double d_inside, double d_outside);
Polygon right_clip(const ClipVariant& variant, const Polygon& polygon, Plane plane);
Polygon right_pieces(const ClipVariant& variant, const Vertex (&triangle)[3]);
Weights right_perspective(const Weights& on_screen, const double (&w)[3]);

}  // namespace scanlit::assignments::clipping
