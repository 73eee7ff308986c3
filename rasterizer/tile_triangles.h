// (7) Scan conversion of a whole tile: in which order, and what need not be.
#pragma once

#include "rasterizer/coarse_depth.h"
#include "rasterizer/pipeline.h"
#include "rasterizer/tiny_triangles.h"

namespace scanlit {

/// A tile's triangles, from the bins of all chunks. Kept from tile to tile for its memory.
class TileTriangles {
 public:
  /// Finds the bins, and makes the tile ready for them.
  void gather(const Frame& frame, int tile, VisibilityTile& visibility);

  /// Scan-converts what may be seen, the nearest bin first where many triangles hide one another;
  /// fills visibility.triangles, and calls drawn(id, columns) after each, as scan_convert was
  /// called. Without Skips::hidden_fragments that is before the next is drawn.
  template <class AfterEach>
  void scan_convert_all(const Frame& frame, VisibilityTile& visibility, FrameStats& stats,
                        const AfterEach& drawn) {
    for (const Part& part : parts_) {
      if (hidden(part.bin->touched, part.nearest, visibility)) {
        for (const BinEntry& entry : part.entries()) stats.hidden += entry.end - entry.begin;
        continue;
      }
      for (const BinEntry& entry : part.entries()) {
        if (hidden(entry.touched, entry.nearest, visibility))
          stats.hidden += entry.end - entry.begin;
        else
          scan_convert_entry(frame, part, entry, visibility, stats, drawn);
      }
    }
  }

 private:
  /// What one chunk has in the tile.
  struct Part {
    const Chunk* chunk;
    const Bin* bin;
    float nearest;  // depth of any of its triangles

    std::span<const BinEntry> entries() const {
      return std::span(chunk->entries).subspan(bin->begin, bin->end - bin->begin);
    }
    std::span<const DrawnTriangle> triangles(const BinEntry& entry) const {
      return std::span(chunk->triangles).subspan(entry.begin, entry.end - entry.begin);
    }
  };

  template <class AfterEach>
  void scan_convert_entry(const Frame& frame, const Part& part, const BinEntry& entry,
                          VisibilityTile& visibility, FrameStats& stats, const AfterEach& drawn) {
    std::span<const DrawnTriangle> left = part.triangles(entry);
    const bool tiny = begin_entry(entry);
    while (tiny && !left.empty()) {
      const auto some = left.first(std::min(left.size(), tiny_at_once));
      left = left.subspan(some.size());
      const TriangleId first = number(some, visibility);
      const unsigned others = scan_convert_tiny(some, first, visibility);
      for (std::size_t i = 0; i < some.size(); ++i) {
        if ((others >> i & 1) == 0)
          drawn(first + TriangleId(i), nullptr);
        else
          scan_convert_one(first + TriangleId(i), visibility, stats, drawn);
      }
    }
    for (const DrawnTriangle& triangle : left)
      if (frame.settings.skips.unseen_triangles || worth_drawing(frame, triangle))
        scan_convert_one(number({&triangle, 1}, visibility), visibility, stats, drawn);
  }

  template <class AfterEach>
  void scan_convert_one(TriangleId id, VisibilityTile& visibility, FrameStats& stats,
                        const AfterEach& drawn) {
    if (deep_ && !visible(*visibility.triangles[id], visibility)) {
      ++stats.hidden;
      return;
    }
    const VisibleColumns* const seen_in = deep_ ? &columns_ : nullptr;
    scan_convert(id, visibility, seen_in);
    drawn(id, seen_in);
  }

  /// Whether many of the entry's triangles may be tiny.
  bool begin_entry(const BinEntry& entry);
  /// Appends to the tile's triangles; returns the first one's id.
  static TriangleId number(std::span<const DrawnTriangle> triangles, VisibilityTile& visibility);
  bool hidden(const Rect& pixels, float nearest, const VisibilityTile& visibility) {
    return deep_ && coarse_.hides(pixels, nearest, visibility);
  }
  /// Whether it may be nearer than what is there; if so, `columns_` says where.
  bool visible(const DrawnTriangle& triangle, const VisibilityTile& visibility);
  static bool worth_drawing(const Frame& frame, const DrawnTriangle& triangle);

  std::vector<Part> parts_;
  CoarseDepth coarse_;
  VisibleColumns columns_;
  bool deep_ = false;
  bool one_by_one_ = false;  // none are tiny
};

}  // namespace scanlit
