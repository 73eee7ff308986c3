// (6) How deep a few large triangles are, block by block: without a depth for each pixel, of which
// their scan conversion would write some two million.
//
// After Hasselgren, Andersson and Akenine-Moeller, "Masked Software Occlusion Culling", High
// Performance Graphics 2016: a block that one triangle covers takes its least depth; one that
// several cover in part keeps a bit a pixel until all are set.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "rasterizer/pipeline.h"

namespace scanlit {

class GreatestDepth;

/// One sample's pixels of a block.
class OccluderBlock {
 public:
  static constexpr int width = 16, height = 8;
  using Pixels = std::array<std::uint16_t, height>;  // a bit for each pixel, row by row

  /// They are covered at this depth, or nearer.
  void cover(const Pixels& pixels, float depth);
  void cover_all(float depth) { least_ = std::max(least_, depth); }

  /// Depth of any of its pixels, or less.
  float least() const { return least_; }

 private:
  float least_ = 0;
  float begun_ = 0;  // depth of the pixels in begun_pixels_, or less
  Pixels begun_pixels_{};
};

/// Of one tile.
class OccluderDepth {
 public:
  /// Nothing is covered. Blocks are counted from the tile's first pixel.
  void reset(const Rect& tile, int samples);
  void add(const DrawnTriangle& drawn);

  /// Of all samples in a block, or less.
  float least(int column, int row) const {
    float depth = 1;
    for (const std::vector<OccluderBlock>& blocks : samples_)
      depth = std::min(depth, blocks[std::size_t(row * columns_ + column)].least());
    return depth;
  }

 private:
  void add(const ScreenTriangle& triangle, const GreatestDepth& opposite,
           std::vector<OccluderBlock>& blocks) const;

  Rect tile_{};
  int columns_ = 0;
  std::vector<std::vector<OccluderBlock>> samples_;
};

}  // namespace scanlit
