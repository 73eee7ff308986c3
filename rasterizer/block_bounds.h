// (6), (7) What one triangle may do in blocks of pixels: how near it is there, and where it is.
#pragma once

#include <algorithm>
#include <cmath>

#include "rasterizer/batch.h"
#include "rasterizer/coarse_depth.h"
#include "rasterizer/scan_conversion.h"

namespace scanlit {

constexpr float infinite = 1e30f;  // beyond every depth, and every edge function

/// The greatest depth that a triangle's fragments have in blocks of pixels. With all depths negated
/// it is the least depth, negated (OccluderDepth::add).
class GreatestDepth {
 public:
  /// In the blocks of `width` x `height` pixels to the right of and below pixel (x, y).
  GreatestDepth(const DrawnTriangle& t, int x, int y, int width, int height) {
    const auto& [a, b, c] = t.vertices;
    nearest_ = std::max(a.depth, std::max(b.depth, c.depth));
    const double abx = b.x - a.x, aby = b.y - a.y, acx = c.x - a.x, acy = c.y - a.y;
    const double to_b = double(b.depth) - a.depth, to_c = double(c.depth) - a.depth;
    const double scale = subpixel / (abx * acy - aby * acx);
    const double per_x = (to_b * acy - to_c * aby) * scale,
                 per_y = (to_c * abx - to_b * acx) * scale;
    // Samples are anywhere in their pixels. Fragments' depths are rounded four times to float
    // (DepthPlane), each time by less than 2^-23 of the greatest. The sums here and in at() are off
    // by less than 2^-22 of the gradient times the tile's side, at most 2^10: by less than one unit
    // of 1/256 pixel, which is added.
    const double corner = a.depth + per_x * (x - a.x / double(subpixel)) +
                          per_y * (y - a.y / double(subpixel)) + std::max(per_x * width, 0.0) +
                          std::max(per_y * height, 0.0) +
                          (std::abs(per_x) + std::abs(per_y)) / subpixel;
    first_ = float(corner);
    per_column_ = float(per_x * width);
    per_row_ = float(per_y * height);
    const float largest =
        std::max(std::abs(a.depth), std::max(std::abs(b.depth), std::abs(c.depth)));
    margin_ = 0x1p-20f * largest;
  }

  /// In `lanes` blocks from column `column` on.
  Batch at(int column, int row) const {
    const Batch corner = Batch(first_ + per_row_ * float(row)) +
                         Batch(per_column_) * Batch::iota(float(column)) + Batch(margin_);
    return min(corner, Batch(nearest_));
  }

 private:
  float first_, per_column_, per_row_, nearest_, margin_;
};

/// Where a triangle may cover something: in float, but never wrong where it does.
class Outline {
 public:
  /// Pixels are counted from pixel (x, y) on.
  Outline(const DrawnTriangle& t, int x, int y) {
    const auto& v = t.vertices;
    const ScreenTriangle triangle = screen_triangle(v[0], v[1], v[2]);
    const double inner = triangle.twice_area < 0 ? -1 : 1;
    for (int i = 0; i < 3; ++i) {
      const ScreenVertex &a = v[i], &b = v[i == 2 ? 0 : i + 1];
      const double per_column = inner * (b.y - a.y), per_row = inner * (a.x - b.x);
      const double first = per_column * (x + (half_pixel - a.x) / double(subpixel)) +
                           per_row * (y + (half_pixel - a.y) / double(subpixel));
      // A tile is at most 2^10 pixels wide and high. Sums are rounded to float less than eight
      // times, each time by less than 2^-24 of the largest.
      const double largest = std::abs(first) + 0x1p10 * (std::abs(per_column) + std::abs(per_row));
      edges_[i] = {float(first + 0x1p-21 * largest), float(per_column), float(per_row)};
    }
    const Rect box = centre_bounds(triangle);
    edges_[above] = {float(y - box.y_begin), 0, 1};
    edges_[below] = {float(box.y_end - 1 - y), 0, -1};
  }

  /// In `lanes` blocks of `width` x `height` pixels from column `column` on: whether it may cover a
  /// sample, which is anywhere in its pixel.
  Batch::Mask meets(int column, int row, int width, int height) const {
    Batch innermost(infinite);
    for (int i = 0; i < above; ++i) {
      const Edge& e = edges_[i];
      const float to_corner = std::max(e.per_column * float(width), 0.0f) +
                              std::max(e.per_row * float(height), 0.0f) -
                              0.5f * (e.per_column + e.per_row);
      const Batch in_row(e.first + e.per_row * float(row * height) + to_corner);
      innermost =
          min(innermost, in_row + Batch(e.per_column * float(width)) * Batch::iota(float(column)));
    }
    return innermost >= Batch(0);
  }

  /// Whether it covers none of the holes' pixel centres in the block at pixel (x, y): in each row
  /// the first and the last lie outside of the same edge.
  bool misses(int x, int y, const Holes& holes) const {
    for (int i = 0; i < holes.rows; i += Batch::lanes) {
      const Batch row = Batch::load(holes.row + i);
      const Batch first = Batch::load(holes.first + i), last = Batch::load(holes.last + i);
      Batch innermost(infinite);
      for (const Edge& e : edges_) {
        const Batch per_column(e.per_column);
        const Batch in_row =
            Batch(e.first + e.per_column * float(x) + e.per_row * float(y)) + row * e.per_row;
        innermost = min(innermost, in_row + max(per_column * first, per_column * last));
        if (none(innermost >= Batch(0))) break;
      }
      if (!none(innermost >= Batch(0))) return false;
    }
    return true;
  }

 private:
  /// An edge function, 256 times twice the area: at the first pixel's centre, and its growth.
  struct Edge {
    float first, per_column, per_row;
  };
  // Beside a tip no edge alone has all of a row outside; but rows above and below the triangle are.
  static constexpr int above = 3, below = 4;
  Edge edges_[5];
};

}  // namespace scanlit
