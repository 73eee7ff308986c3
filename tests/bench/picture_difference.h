// Whether two renderers drew the same picture.
#pragma once

#include <cstdint>
#include <string>

#include "rasterizer/aligned_vector.h"

namespace scanlit::bench {

/// RGBA, 8 bits each, row 0 on top.
using Picture = AlignedVector<std::uint8_t>;

/// Of several pictures the worst of each figure; `covered` is the first one's.
struct PictureDifference {
  std::int64_t covered[2] = {};       // pixels: alpha above 0
  std::int64_t coverage_differs = 0;  // pixels covered in one picture alone
  // Over the pixels covered in both, in steps of 8 bits:
  int max = 0;                 // of any channel
  double mean = 0;             // of all channels
  double share_above_two = 0;  // of the pixels, those with a channel that differs by more than 2

  /// A mean of at most half a step, at most 2 steps on 99.9 % of the covered pixels, and equal
  /// coverage but for .01 % of them: what separates two ways to round, and no more.
  bool same() const;
  /// What is beyond that, in words.
  std::string words() const;

  void take_worse(const PictureDifference& other);
};

/// Pictures of equal size.
PictureDifference compare(const Picture& a, const Picture& b);

}  // namespace scanlit::bench
