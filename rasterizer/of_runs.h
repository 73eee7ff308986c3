// (8), (9) What is the same along a run, for vectors of fragments that lie in several runs.
#pragma once

#include "rasterizer/batch.h"
#include "rasterizer/fragment_span.h"

namespace scanlit {

/// Of an array that has one number a run, the numbers of a vector of fragments. Consecutive
/// fragments are of one run or of consecutive ones: a vector's are among as many numbers as it has
/// lanes, which one load brings and one permutation hands out. Loops over runs of two or three
/// pixels would leave most lanes empty.
class OfRuns {
 public:
  /// The fragments from `run` on, in FragmentSpan::run.
  explicit OfRuns(const std::int32_t* run) : first_(*run) {
    const hn::RebindToSigned<Batch::Tag> ints;
    // Beyond the span's last fragment stands anything.
    const auto after_first = hn::Sub(hn::LoadU(ints, run), hn::Set(ints, first_));
    lane_ = hn::And(after_first, hn::Set(ints, Batch::lanes - 1));
  }

  Batch operator()(const float* per_run) const {
    return hn::TableLookupLanes(hn::LoadU(Batch::tag, per_run + first_),
                                hn::IndicesFromVec(Batch::tag, lane_));
  }

 private:
  std::int32_t first_;
  hn::Vec<hn::RebindToSigned<Batch::Tag>> lane_;
};

/// The columns of a vector of fragments, from fragment i on.
inline Batch columns(const FragmentSpan& span, int i) {
  const hn::RebindToSigned<Batch::Tag> ints;
  const auto packed =
      hn::BitCast(ints, hn::LoadU(hn::RebindToUnsigned<Batch::Tag>(), span.pixel + i));
  return hn::ConvertTo(Batch::tag, hn::And(packed, hn::Set(ints, 0xffff)));
}

}  // namespace scanlit
