#include "rasterizer/tile_triangles.h"

#include <algorithm>

#include "rasterizer/triangle_culling.h"

namespace scanlit {

void TileTriangles::gather(const Frame& frame, int tile, VisibilityTile& visibility) {
  const Skips& skips = frame.settings.skips;
  const Rect rect = frame.grid.tile(tile);
  const int samples = frame.settings.samples;
  Rect touched{rect.x_end, rect.y_end, rect.x_begin, rect.y_begin};
  std::int64_t pixels = 0;
  entries_.clear();
  for (const Chunk& chunk : frame.chunks) {
    const int i = tile - chunk.first_tile;
    if (i < 0 || i >= int(chunk.bins.size())) continue;
    const Bin& bin = chunk.bins[std::size_t(i)];
    if (bin.begin == bin.end) continue;
    touched = united(touched, bin.touched);
    pixels += bin.pixels;
    for (std::uint32_t k = bin.begin; k < bin.end; ++k) {
      const DrawnTriangle& triangle = chunk.triangles[chunk.entries[k].triangle];
      const auto& v = triangle.vertices;
      if (!skips.unseen_triangles && cull(screen_triangle(v[0], v[1], v[2]), *chunk.draw,
                                          frame.viewport, samples) != Fate::drawn)
        continue;
      entries_.push_back({&triangle, chunk.entries[k].nearest});
    }
  }
  if (entries_.empty()) touched = {rect.x_begin, rect.y_begin, rect.x_begin, rect.y_begin};
  if (!skips.empty_pixels) touched = rect;
  visibility.reset(rect, touched, samples);

  // Where the boxes cover each pixel about twice, neighbours' boxes overlap and little is hidden.
  deep_ = skips.hidden_triangles && pixels > 4 * area(touched);
  if (deep_) {
    coarse_.reset(visibility);
    sort_nearest_first();
  }
  visibility.triangles.resize(entries_.size());
  for (std::size_t i = 0; i < entries_.size(); ++i) visibility.triangles[i] = entries_[i].triangle;
}

/// A counting sort by depth in steps: nearly sorted is good enough, and takes two passes.
void TileTriangles::sort_nearest_first() {
  constexpr int steps = 1024;
  const auto [low, high] = std::ranges::minmax_element(entries_, {}, &Entry::nearest);
  const float nearest = high->nearest;
  const float scale = float(steps - 1) / std::max(nearest - low->nearest, 1e-30f);
  const auto step = [&](const Entry& e) { return std::size_t((nearest - e.nearest) * scale); };
  position_.assign(steps + 1, 0);
  for (const Entry& e : entries_) ++position_[step(e) + 1];
  for (std::size_t i = 1; i <= steps; ++i) position_[i] += position_[i - 1];
  sorted_.resize(entries_.size());
  for (const Entry& e : entries_) sorted_[position_[step(e)]++] = e;
  entries_.swap(sorted_);
}

bool TileTriangles::visible(const DrawnTriangle& triangle, const VisibilityTile& visibility,
                            VisibleColumns& columns) {
  const auto& v = triangle.vertices;
  const Rect pixels = intersection(
      pixel_bounds(screen_triangle(v[0], v[1], v[2]), visibility.samples), visibility.touched);
  return !pixels.empty() && coarse_.visible(triangle, pixels, visibility, columns);
}

}  // namespace scanlit
