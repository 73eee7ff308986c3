// (7) Scan conversion of a whole tile: in which order, and what need not be.
#pragma once

#include "rasterizer/coarse_depth.h"
#include "rasterizer/pipeline.h"

namespace scanlit {

/// A tile's triangles, gathered from the bins of all chunks. Kept from tile to tile for its memory.
class TileTriangles {
 public:
  /// Fills visibility.triangles and makes the tile ready for them.
  void gather(const Frame& frame, int tile, VisibilityTile& visibility);

  /// Scan-converts each, nearest first where many hide one another, and calls drawn(id) after it.
  template <class AfterEach>
  void scan_convert_all(VisibilityTile& visibility, FrameStats& stats, const AfterEach& drawn) {
    VisibleColumns columns;
    for (TriangleId id = 0; id < TriangleId(visibility.triangles.size()); ++id) {
      // After sorting they come from all over memory.
      if (id + 4 < visibility.triangles.size()) __builtin_prefetch(visibility.triangles[id + 4]);
      if (deep_ && !visible(*visibility.triangles[id], visibility, columns)) {
        ++stats.hidden;
        continue;
      }
      scan_convert(id, visibility, deep_ ? &columns : nullptr);
      drawn(id);
    }
  }

 private:
  bool visible(const DrawnTriangle& triangle, const VisibilityTile& visibility,
               VisibleColumns& columns);
  void sort_nearest_first();

  struct Entry {
    const DrawnTriangle* triangle;
    float nearest;
  };
  std::vector<Entry> entries_, sorted_;
  std::vector<std::uint32_t> position_;
  CoarseDepth coarse_;
  bool deep_ = false;
};

}  // namespace scanlit
