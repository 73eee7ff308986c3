// A3 as it should be, for any variant.
#pragma once

#include <cstdint>
#include <vector>

#include "lessons/assignments/A3_visibility/visibility.h"

namespace scanlit::assignments::visibility {

using a3::Corner, a3::Fragment, a3::StoredDepth;

/// Never the engine's own, which stores depth as it is, in float.
struct DepthVariant {
  bool smaller_is_nearer;
  int bits;
  bool rounds, last_wins;

  StoredDepth most() const { return (1u << bits) - 1; }
};
DepthVariant depth_variant(std::uint64_t seed);

double right_depth_of(const DepthVariant& variant, double distance, double near, double far);
double right_depth_at(const Corner (&triangle)[3], double x, double y);
StoredDepth right_stored(const DepthVariant& variant, double depth);
StoredDepth right_farthest(const DepthVariant& variant);
bool right_replaces(const DepthVariant& variant, StoredDepth fresh, StoredDepth there);
std::vector<int> right_draw(const DepthVariant& variant, const std::vector<Fragment>& fragments,
                            int width, int height);

}  // namespace scanlit::assignments::visibility
