// (7) Scan conversion, of a tile where triangles hide one another: what lies behind everything a
// block of pixels holds need not be scan-converted.
#pragma once

#include "rasterizer/pipeline.h"

namespace scanlit {

/// For each block of pixels the least depth in it, or less: what stands there may be out of date,
/// because depth only grows, and is brought up to date where that may help.
class CoarseDepth {
 public:
  /// Nothing is covered: of tile.touched alone.
  void reset(const VisibilityTile& tile);

  /// Whether everything in `pixels` is nearer than `nearest` at each sample.
  bool hides(const Rect& pixels, float nearest, const VisibilityTile& tile);

  /// A triangle with these pixels in its box was drawn.
  void wrote(const Rect& pixels);

 private:
  static constexpr int block_width = 16, block_height = 8;

  struct Block {
    float least = 0;
    int pixels_written = 0;  // at most, since `least` was found
  };

  /// Calls use(block, its pixels) for every block that meets `pixels`, until it returns false.
  template <class Use>
  bool all_blocks(const Rect& pixels, const Use& use);

  static float least_depth(const Rect& pixels, const VisibilityTile& tile);

  Rect rect_{};
  int columns_ = 0, full_ = 0;  // full_: as many writes may have filled a block
  std::vector<Block> blocks_;
};

}  // namespace scanlit
