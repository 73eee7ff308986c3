// (7) Scan conversion, of a tile where triangles hide one another: what lies behind everything a
// block of pixels holds need not be scan-converted.
#pragma once

#include <algorithm>

#include "rasterizer/batch.h"
#include "rasterizer/pipeline.h"

namespace scanlit {

/// Where in a tile a triangle may be seen: pixel columns [begin, end) for each row of blocks.
struct VisibleColumns {
  // Measured on 64 spheres behind one another: with blocks 8, 16 and 32 rows high a frame
  // takes 9.4, 8.5 and 8.2 ms; where triangles are small, no height is faster. Low ones hide more.
  static constexpr int block_height = 16, max_block_rows = 4;

  struct Range {
    int begin, end;
  };
  int y_begin = 0;         // of the first row of blocks
  int first_row, end_row;  // outside of which no range holds anything
  Range ranges[max_block_rows];

  const Range& at_row(int y) const { return ranges[(y - y_begin) / block_height]; }
};

/// A block that is covered in part, as at an outline: what lies behind the covered part and misses
/// the rest is hidden, too.
struct Holes {
  static constexpr int most_rows = std::max(VisibleColumns::block_height, Batch::lanes);

  float least = 0;  // depth of the covered pixels, or less; 0: not known
  // The block's rows that have holes, and the columns of the first and the last hole of each. After
  // them the first row stands again, for vectors to be loaded whole.
  int rows = 0;
  float row[most_rows], first[most_rows], last[most_rows];
};

/// For each block of pixels the least depth in it, or less: what stands there may be out of date,
/// because depth only grows, and is brought up to date where that may help.
class CoarseDepth {
 public:
  /// Nothing is covered: of tile.touched alone.
  void reset(const VisibilityTile& tile);

  /// Whether everything in `pixels` is nearer than `nearest`.
  bool hides(const Rect& pixels, float nearest, const VisibilityTile& tile);

  /// Finds the columns where the triangle, whose box is within `pixels`, may be nearer than what is
  /// there, and takes for granted that it is about to be drawn in them. False if there are none.
  bool visible(const DrawnTriangle& triangle, const Rect& pixels, const VisibilityTile& tile,
               VisibleColumns& columns);

  /// Triangles are about to be drawn here without having been asked for.
  void expect(const Rect& pixels);

 private:
  static constexpr int block_width = 16, block_height = VisibleColumns::block_height;

  /// The blocks that some pixels meet: columns and rows, both ends included.
  struct Blocks {
    int first_column, last_column, first_row, last_row;
  };
  Blocks blocks(const Rect& pixels) const;
  Rect block(int column, int row) const;
  /// True if it may be seen in the block even now that its least depth is known.
  bool refresh(int column, int row, float depth, const VisibilityTile& tile);
  void find_holes(const Rect& pixels, const VisibilityTile& tile, Holes& holes) const;

  Rect rect_{};
  int stride_ = 0;            // blocks in a row, and more: vectors are loaded whole
  std::vector<float> least_;  // depth in each block
  std::vector<int> written_;  // pixels since then, at most
  std::vector<Holes> holes_;
};

}  // namespace scanlit
