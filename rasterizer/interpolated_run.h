// (9) The colours of all pixels of a run that was shaded every few pixels (strides.h).
#pragma once

#include <algorithm>
#include <bit>

#include "rasterizer/batch.h"
#include "rasterizer/fragment_span.h"
#include "rasterizer/vec.h"

namespace scanlit {

/// Linear between two neighbouring fragments. `colour` has those of the run's span.
class InterpolatedRun {
 public:
  InterpolatedRun(const Run& run, const float (&colour)[3][FragmentSpan::padded])
      : shift_(std::countr_zero(unsigned(run.stride))),
        last_(run.size - 2),
        inverse_stride_(1.0f / float(run.stride)),
        inverse_last_(1.0f / float(run.pixels - 1 - (last_ << shift_))) {
    for (int c = 0; c < 3; ++c) colour_[c] = colour[c] + run.first;
  }

  /// Of the run's pixels i, i + 1, ...; beyond its last one anything.
  Rgb<Batch> at(int i) const {
    const hn::RebindToSigned<Batch::Tag> ints;
    const int first = std::min(i >> shift_, last_);
    const auto pixel = hn::Iota(ints, i), last = hn::Set(ints, last_);
    const auto interval = hn::Min(hn::ShiftRightSame(pixel, shift_), last);
    const Batch from = hn::ConvertTo(Batch::tag, hn::ShiftLeftSame(interval, shift_));
    const Batch inverse = hn::IfThenElse(hn::RebindMask(Batch::tag, hn::Eq(interval, last)),
                                         inverse_last_.raw, inverse_stride_.raw);
    const Batch share = (Batch(hn::ConvertTo(Batch::tag, pixel)) - from) * inverse;
    const auto lane = hn::IndicesFromVec(Batch::tag, hn::Sub(interval, hn::Set(ints, first)));
    const auto channel = [&](const float* colour) {
      const Batch left = hn::TableLookupLanes(hn::LoadU(Batch::tag, colour + first), lane);
      const Batch right = hn::TableLookupLanes(hn::LoadU(Batch::tag, colour + first + 1), lane);
      return mul_add(share, right - left, left);
    };
    return {channel(colour_[0]), channel(colour_[1]), channel(colour_[2])};
  }

 private:
  int shift_, last_;
  Batch inverse_stride_, inverse_last_;
  const float* colour_[3];
};

}  // namespace scanlit
