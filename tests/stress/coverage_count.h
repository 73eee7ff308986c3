// How often a window of pixels is covered, as stage (7) has it, and how often it has to be.
#pragma once

#include <algorithm>
#include <vector>

#include "rasterizer/scan_conversion.h"
#include "rasterizer/tiny_triangles.h"

namespace scanlit::stress {

template <class Use>
void for_each_pixel(const Rect& r, const Use& use) {
  for (int y = r.y_begin; y < r.y_end; ++y)
    for (int x = r.x_begin; x < r.x_end; ++x) use(x, y);
}

/// A window of a picture; how often each of its pixels is covered, back faces counting -1.
class CoverageCount {
 public:
  explicit CoverageCount(const Rect& window)
      : window_(window), sum_(std::size_t(area(window))), touched_(std::size_t(area(window))) {}

  /// As in a tile that is cut to the triangle's box.
  void add(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
    const ScreenTriangle triangle = screen_triangle(a, b, c);
    const Rect box = intersection(centre_bounds(triangle), window_);
    if (triangle.twice_area == 0 || box.empty()) return;
    DrawnTriangle drawn{{a, b, c}, 0, 0, 0, DrawnTriangle::not_cut};
    for (ScreenVertex& v : drawn.vertices) v.depth = 0.5f;
    tile_.reset(box, box, 1);
    tile_.triangles.push_back(&drawn);
    if (scan_convert_tiny({&drawn, 1}, 0, tile_) != 0) scan_convert(0, tile_, nullptr);
    for_each_pixel(box, [&](int x, int y) {
      if (tile_.triangle[tile_.row(0, y) + std::size_t(x - box.x_begin)] == no_triangle) return;
      sum_[index(x, y)] += triangle.twice_area > 0 ? 1 : -1;
      ++touched_[index(x, y)];
    });
  }

  const Rect& window() const { return window_; }
  /// Front faces minus back faces.
  int signed_sum(int x, int y) const { return sum_[index(x, y)]; }
  int faces(int x, int y) const { return touched_[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    return std::size_t(y - window_.y_begin) * std::size_t(window_.x_end - window_.x_begin) +
           std::size_t(x - window_.x_begin);
  }

  Rect window_;
  std::vector<int> sum_, touched_;
  VisibilityTile tile_;
};

/// How often a closed polygon goes around a pixel's centre, counter-clockwise as the viewer sees
/// it: the crossings of a ray to the right. The centre is moved to the right by an infinitely small
/// step, and down by an infinitely smaller one: the top-left rule. In whole numbers.
inline int winding_number(const std::vector<ScreenVertex>& polygon, int column, int row) {
  const std::int64_t x = std::int64_t(column) * subpixel + half_pixel;
  const std::int64_t y = std::int64_t(row) * subpixel + half_pixel;
  int winding = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ScreenVertex &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const bool a_above = a.y <= y, b_above = b.y <= y;
    if (a_above == b_above) continue;
    const std::int64_t side =
        std::int64_t(b.x - a.x) * (y - a.y) - std::int64_t(b.y - a.y) * (x - a.x);
    if (a_above && side > 0) --winding;
    if (b_above && side < 0) ++winding;
  }
  return winding;
}

}  // namespace scanlit::stress
