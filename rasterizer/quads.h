// (7), (8) Four numbers that stand side by side, of as many places in memory as a vector has lanes.
#pragma once

#include "rasterizer/batch.h"

namespace scanlit {
inline namespace HWY_NAMESPACE {

/// Number c of the four at at(lane) becomes lane `lane` of v[c]. A gather for each of the four
/// would load each place four times.
template <class At>
void load_quads(const At& at, Batch (&v)[4]) {
  const hn::Full128<float> quad;
  const auto load = [&](int lane) { return hn::LoadU(quad, at(lane)); };
  // Of lanes i, i + 4, i + 8, ..., a quad of each.
  const auto every_fourth = [&](int i) {
    if constexpr (Batch::lanes == 4) {
      return load(i);
    } else if constexpr (Batch::lanes == 8) {
      return hn::Combine(Batch::tag, load(i + 4), load(i));
    } else {
      const hn::Half<Batch::Tag> half;
      return hn::Combine(Batch::tag, hn::Combine(half, load(i + 12), load(i + 8)),
                         hn::Combine(half, load(i + 4), load(i)));
    }
  };
  const hn::Repartition<double, Batch::Tag> pairs;
  const auto q0 = every_fourth(0), q1 = every_fourth(1);
  const auto q2 = every_fourth(2), q3 = every_fourth(3);
  const auto low_01 = hn::BitCast(pairs, hn::InterleaveLower(Batch::tag, q0, q1));
  const auto low_23 = hn::BitCast(pairs, hn::InterleaveLower(Batch::tag, q2, q3));
  const auto high_01 = hn::BitCast(pairs, hn::InterleaveUpper(Batch::tag, q0, q1));
  const auto high_23 = hn::BitCast(pairs, hn::InterleaveUpper(Batch::tag, q2, q3));
  v[0] = hn::BitCast(Batch::tag, hn::InterleaveLower(pairs, low_01, low_23));
  v[1] = hn::BitCast(Batch::tag, hn::InterleaveUpper(pairs, low_01, low_23));
  v[2] = hn::BitCast(Batch::tag, hn::InterleaveLower(pairs, high_01, high_23));
  v[3] = hn::BitCast(Batch::tag, hn::InterleaveUpper(pairs, high_01, high_23));
}

}  // namespace HWY_NAMESPACE
}  // namespace scanlit
