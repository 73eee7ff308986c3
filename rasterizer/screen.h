// (5), (6) The screen: its units, its size, and the tiles it is cut into.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace scanlit {

constexpr int subpixel = 256;             // units of a screen position in a pixel
constexpr int half_pixel = subpixel / 2;  // a pixel's centre, in the pixel

/// The picture's size, and its guard band: triangles are cut at the picture's sides only where they
/// reach 2^14 to 2^15 pixels beyond its centre. A picture is at most 2^14 pixels wide, so on the
/// screen |x| <= 2^15 + 2^13 < 2^16 pixels = 2^24 units of 1/256. Differences of two positions are
/// then below 2^25, an edge function (a difference of two products of differences) is below 2^51,
/// and the numerator of an edge's crossing (EdgeWalker) below 2^52: 64-bit integers cannot
/// overflow, and a double holds every edge function exactly.
struct Viewport {
  int width = 0, height = 0;

  /// In clip space: |x| <= guard_x w. A power of two, so that the product is exact and outcodes (in
  /// float) and clip (in double) agree on which side a vertex is: where they did not, of two
  /// neighbours the one that another vertex sent to clip would move a shared vertex.
  float guard_x() const { return float(std::bit_floor(65536u / unsigned(width))); }
  float guard_y() const { return float(std::bit_floor(65536u / unsigned(height))); }
};

/// Pixels [x_begin, x_end) x [y_begin, y_end).
struct Rect {
  int x_begin, y_begin, x_end, y_end;

  bool empty() const { return x_begin >= x_end || y_begin >= y_end; }
  friend bool operator==(const Rect&, const Rect&) = default;
};

inline Rect intersection(const Rect& a, const Rect& b) {
  return {std::max(a.x_begin, b.x_begin), std::max(a.y_begin, b.y_begin),
          std::min(a.x_end, b.x_end), std::min(a.y_end, b.y_end)};
}
inline Rect united(const Rect& a, const Rect& b) {
  return {std::min(a.x_begin, b.x_begin), std::min(a.y_begin, b.y_begin),
          std::max(a.x_end, b.x_end), std::max(a.y_end, b.y_end)};
}
/// Of a rectangle that is not empty, in pixels.
inline std::int64_t area(const Rect& r) {
  return std::int64_t(r.x_end - r.x_begin) * (r.y_end - r.y_begin);
}

/// The picture cut into tiles, as large as stay in a core's cache. Sides are powers of two, so that
/// finding a pixel's tile needs no division.
struct TileGrid {
  int width_shift, height_shift, columns, rows;
  Viewport viewport;

  int count() const { return columns * rows; }
  int column(int x) const { return x >> width_shift; }
  int row(int y) const { return y >> height_shift; }
  Rect tile(int column, int row) const {
    const int x = column << width_shift, y = row << height_shift;
    return {x, y, std::min(x + (1 << width_shift), viewport.width),
            std::min(y + (1 << height_shift), viewport.height)};
  }
  Rect tile(int index) const { return tile(index % columns, index / columns); }
};
constexpr int max_tile_height = 64;
TileGrid make_tile_grid(const Viewport& viewport, int samples);

}  // namespace scanlit
