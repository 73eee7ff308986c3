// (7) Scan conversion of a whole tile: in which order, and what need not be.
#pragma once

#include "rasterizer/coarse_depth.h"
#include "rasterizer/pipeline.h"

namespace scanlit {

/// A tile's triangles, from the bins of all chunks. Kept from tile to tile for its memory.
class TileTriangles {
 public:
  /// Finds the bins, and makes the tile ready for them.
  void gather(const Frame& frame, int tile, VisibilityTile& visibility);

  /// Scan-converts what may be seen, the nearest bin first where many triangles hide one another;
  /// fills visibility.triangles, and calls drawn(id, columns) after each, as scan_convert was
  /// called.
  template <class AfterEach>
  void scan_convert_all(const Frame& frame, VisibilityTile& visibility, FrameStats& stats,
                        const AfterEach& drawn) {
    for (const Part& part : parts_) {
      const Bin& bin = *part.bin;
      if (deep_ && coarse_.hides(bin.touched, part.nearest, visibility)) {
        stats.hidden += bin.end - bin.begin;
        continue;
      }
      for (std::uint32_t i = bin.begin; i < bin.end; ++i) {
        const DrawnTriangle& triangle = part.chunk->triangles[part.chunk->entries[i].triangle];
        if (!frame.settings.skips.unseen_triangles && !worth_drawing(frame, triangle)) continue;
        if (deep_ && !visible(triangle, visibility)) {
          ++stats.hidden;
          continue;
        }
        const auto id = TriangleId(visibility.triangles.size());
        visibility.triangles.push_back(&triangle);
        const VisibleColumns* const seen_in = deep_ ? &columns_ : nullptr;
        scan_convert(id, visibility, seen_in);
        drawn(id, seen_in);
      }
    }
  }

 private:
  /// Whether it may be nearer than what is there; if so, `columns_` says where.
  bool visible(const DrawnTriangle& triangle, const VisibilityTile& visibility);
  static bool worth_drawing(const Frame& frame, const DrawnTriangle& triangle);

  struct Part {
    const Chunk* chunk;
    const Bin* bin;
    float nearest;  // depth of any of its triangles
  };
  std::vector<Part> parts_;
  CoarseDepth coarse_;
  VisibleColumns columns_;
  bool deep_ = false;
};

}  // namespace scanlit
