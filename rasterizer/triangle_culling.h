// (6) Assembly, of a whole cluster at once: which of its triangles are worth scan-converting.
#pragma once

#include <algorithm>
#include <span>

#include "rasterizer/scan_conversion.h"

namespace scanlit {

/// Why a triangle, or a piece of one, is or is not drawn: the first reason that holds, in the order
/// no area, back-facing, between the sample positions, outside of the picture. A cut triangle
/// counts as the largest of its pieces'.
enum class Fate : std::uint8_t { outside, no_pixel, back_facing, drawn };

/// The pixels whose sample positions a triangle's box can hold; may be empty, may leave the
/// picture.
inline Rect pixel_bounds(const ScreenTriangle& t, int samples) {
  if (samples == 1) return centre_bounds(t);
  // More samples than one lie anywhere in their pixel.
  const auto& [a, b, c] = t.vertices;
  const int x_min = std::min(a.x, std::min(b.x, c.x)), x_max = std::max(a.x, std::max(b.x, c.x));
  const int y_min = std::min(a.y, std::min(b.y, c.y)), y_max = std::max(a.y, std::max(b.y, c.y));
  return {x_min >> 8, y_min >> 8, (x_max >> 8) + 1, (y_max >> 8) + 1};
}

inline Rect picture_rect(const Viewport& viewport) {
  return {0, 0, viewport.width, viewport.height};
}

/// One triangle, by exact arithmetic of any size.
Fate cull(const ScreenTriangle& triangle, const Draw& draw, const Viewport& viewport, int samples);

/// The triangles of a cluster, by their numbers in it.
struct CulledCluster {
  static constexpr int capacity = Cluster::max_triangles;
  static constexpr int padded = capacity + int(max_lanes);
  using Numbers = std::int32_t[padded];

  Numbers drawn;  // these are drawn
  int drawn_count = 0;
  Numbers from_behind;                     // of each of them: not 0 where it faces away
  Numbers x_begin, y_begin, x_end, y_end;  // and the pixels of the picture that it may touch
  std::uint8_t large[capacity];  // these want cull(): their coordinates' products leave 32 bits
  int large_count = 0;
  int outside = 0, no_pixel = 0, back_facing = 0;
  Rect box;             // of those that are drawn: all that they may touch
  std::int32_t pixels;  // in their boxes, summed

  Rect box_of(std::int32_t i) const { return {x_begin[i], y_begin[i], x_end[i], y_end[i]}; }
};

/// The drawn triangles of a cluster, tile by tile.
class TilesOfTriangles {
 public:
  TilesOfTriangles(const CulledCluster& culled, const TileGrid& grid);

  static constexpr int several = -1;
  /// Those that lie in this tile, or in `several`, as places in CulledCluster::drawn;
  /// they stand until the next are asked for.
  std::span<const std::int32_t> in(int tile);

 private:
  int count_;
  CulledCluster::Numbers tile_, found_;
};

/// All triangles of a cluster none of whose vertices is outside of anything: whole vectors of them,
/// in 32-bit integers, with the verdicts of cull(). Where one sample a pixel is taken, a triangle
/// whose box holds a single pixel is also tested for covering it.
void cull_cluster(const Draw& draw, const Cluster& cluster, const ClusterVertices& vertices,
                  const Viewport& viewport, int samples, CulledCluster& result);

}  // namespace scanlit
