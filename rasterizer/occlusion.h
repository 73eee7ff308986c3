// (6) Which clusters lie behind a few large triangles, as furniture does behind walls: their
// vertices need not even be transformed.
//
// Before the rest is assembled, those few triangles (the occluders) are asked what they cover. Of
// each block of pixels the least depth is kept (occluder_depth.h); what is farther in all blocks
// that it can touch is hidden, whatever is drawn later, because depth only grows.
#pragma once

#include "rasterizer/cluster_culling.h"
#include "rasterizer/occluder_depth.h"
#include "rasterizer/pipeline.h"
#include "rasterizer/tile.h"

namespace scanlit {

class Occlusion {
 public:
  /// Nothing is hidden.
  void reset(const Frame& frame);
  /// What a tile's occluders cover. Of several tiles at a time.
  void put(const Rect& tile, const OccluderDepth& occluders);

  bool hides(const ScreenBounds& bounds) const;

 private:
  // Tiles consist of whole ones.
  static constexpr int block_width = OccluderBlock::width, block_height = OccluderBlock::height;

  Rect picture_{};
  int columns_ = 0;
  std::vector<float> least_;  // depth in each block, row by row
};

/// If it is likely to pay: (3) to (6) of the occluders alone, and what of the other objects they
/// hide. Clusters can be asked for in frame.occlusion then. Occluders are the objects of one
/// cluster.
void find_hidden(Frame& frame, Workers& workers, Occlusion& occlusion);

}  // namespace scanlit
