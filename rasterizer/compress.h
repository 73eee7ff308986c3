// The lanes of a vector that are in a mask, moved together.
#pragma once

#include <array>

#include "rasterizer/batch.h"

namespace scanlit {
inline namespace HWY_NAMESPACE {

/// The lanes of each mask, in order; then lane 0.
template <int lanes>
struct LanesOfMasks {
  alignas(64) std::array<std::array<std::int32_t, lanes>, 1 << lanes> of{};

  constexpr LanesOfMasks() {
    for (std::size_t mask = 0; mask < of.size(); ++mask)
      for (int lane = 0, count = 0; lane < lanes; ++lane)
        if (mask >> lane & 1) of[mask][std::size_t(count++)] = lane;
  }
};
template <int lanes>
inline constexpr LanesOfMasks<lanes> lanes_of_masks;

/// The lanes of `v` in the mask; after them any. AVX-512 has an instruction for it. Elsewhere
/// hn::Compress (Highway 1.0.3) looks them up as well, but GCC 12 copies its table to the stack
/// each time: a frame of a few large triangles took three times as long.
template <class V, class D = hn::DFromV<V>>
V compressed(V v, hn::Mask<D> mask) {
  if constexpr (Batch::lanes == 16) {
    return hn::Compress(v, mask);
  } else {
    const unsigned bits = bits_of(Batch::Mask{hn::RebindMask(Batch::tag, mask)});
    const auto& lanes = lanes_of_masks<Batch::lanes>.of[bits];
    return hn::TableLookupLanes(v, hn::SetTableIndices(D(), lanes.data()));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace scanlit
