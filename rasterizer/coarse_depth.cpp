#include "rasterizer/coarse_depth.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "rasterizer/batch.h"

namespace scanlit {

namespace {

constexpr float infinite = 1e30f;  // beyond every depth

/// The greatest depth that a triangle's fragments have in blocks of pixels.
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
    // Samples are anywhere in their pixels. Fragments' depths are rounded three times to float
    // (DepthPlane), each time by less than 2^-23 of the greatest. The sums here and in at() are off
    // by less than 2^-22 of the gradient times the tile's side, at most 2^12: by less than one unit
    // of 1/256 pixel, which is added.
    const double corner = a.depth + per_x * (x - a.x / double(subpixel)) +
                          per_y * (y - a.y / double(subpixel)) + std::max(per_x * width, 0.0) +
                          std::max(per_y * height, 0.0) +
                          (std::abs(per_x) + std::abs(per_y)) / subpixel;
    first_ = float(corner);
    per_column_ = float(per_x * width);
    per_row_ = float(per_y * height);
    margin_ = 0x1p-20f * nearest_;
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

/// Whether a triangle covers none of some pixel centres: tried with one edge after the other, all
/// of them lying outside of it. Not exact, but never true where one is covered.
class Outline {
 public:
  explicit Outline(const DrawnTriangle& t) {
    const auto& v = t.vertices;
    const bool flip = screen_triangle(v[0], v[1], v[2]).twice_area < 0;
    for (int i = 0; i < 3; ++i) {
      const ScreenVertex &a = v[i], &b = v[i == 2 ? 0 : i + 1];
      Edge& e = edges_[i];
      e.per_column = double(flip ? a.y - b.y : b.y - a.y);
      e.per_row = double(flip ? b.x - a.x : a.x - b.x);
      e.at_origin =
          -e.per_column * (a.x - half_pixel) / subpixel - e.per_row * (a.y - half_pixel) / subpixel;
      // Within a block of 16 x 8 float is off by less than 2^-18 of the slopes.
      e.at_origin += 0x1p-16 * (std::abs(e.per_column) + std::abs(e.per_row));
    }
  }

  /// Pixels (x + column[i], y + row[i]).
  template <int count>
  bool misses(int x, int y, const float (&column)[count], const float (&row)[count]) const {
    for (const Edge& edge : edges_) {
      const Batch start(float(edge.at_origin + edge.per_column * x + edge.per_row * y));
      const Batch dx(float(edge.per_column)), dy(float(edge.per_row));
      Batch innermost(-infinite);
      for (int i = 0; i < count; i += Batch::lanes)
        innermost =
            max(innermost, start + dx * Batch::load(column + i) + dy * Batch::load(row + i));
      if (none(innermost >= Batch(0))) return true;
    }
    return false;
  }

 private:
  struct Edge {
    double at_origin, per_column, per_row;  // 256 times twice the area, at pixel centres
  };
  Edge edges_[3];
};

}  // namespace

float least_depth(const Rect& pixels, const VisibilityTile& tile) {
  Batch least(infinite);
  for (int x = pixels.x_begin; x < pixels.x_end; x += Batch::lanes) {
    Batch in_columns(infinite);
    for (int sample = 0; sample < tile.samples; ++sample) {
      const float* depth = &tile.depth[tile.row(sample, pixels.y_begin)] + (x - tile.rect.x_begin);
      for (int y = pixels.y_begin; y < pixels.y_end; ++y, depth += tile.stride)
        in_columns = min(in_columns, Batch::load(depth));
    }
    const auto in_block = Batch::iota(float(x)) < Batch(float(pixels.x_end));
    least = min(least, select(in_block, in_columns, infinite));
  }
  return hn::GetLane(hn::MinOfLanes(Batch::tag, least.raw));
}

void CoarseDepth::reset(const VisibilityTile& tile) {
  rect_ = tile.touched;
  const int columns = (rect_.x_end - rect_.x_begin + block_width - 1) / block_width;
  const int rows = (rect_.y_end - rect_.y_begin + block_height - 1) / block_height;
  stride_ = columns + Batch::lanes;
  least_.assign(std::size_t(stride_ * rows), 0.0f);
  holes_.resize(least_.size());
  for (Holes& holes : holes_) holes.least = 0;
  written_.assign(std::size_t(stride_ * rows), 0);
}

CoarseDepth::Blocks CoarseDepth::blocks(const Rect& pixels) const {
  return {.first_column = (pixels.x_begin - rect_.x_begin) / block_width,
          .last_column = (pixels.x_end - 1 - rect_.x_begin) / block_width,
          .first_row = (pixels.y_begin - rect_.y_begin) / block_height,
          .last_row = (pixels.y_end - 1 - rect_.y_begin) / block_height};
}

Rect CoarseDepth::block(int column, int row) const {
  const int x = rect_.x_begin + column * block_width, y = rect_.y_begin + row * block_height;
  return {x, y, std::min(x + block_width, rect_.x_end), std::min(y + block_height, rect_.y_end)};
}

bool CoarseDepth::refresh(int column, int row, float depth, const VisibilityTile& tile) {
  const auto i = std::size_t(row * stride_ + column);
  // Before it is written that often there may be holes in it, or what was there stands.
  if (written_[i] < block_width * block_height) return true;
  least_[i] = least_depth(block(column, row), tile);
  written_[i] = 0;
  if (least_[i] <= 0 && tile.samples == 1) {
    find_holes(block(column, row), tile, holes_[i]);
    written_[i] = -2 * block_width * block_height;  // they may be there for long
  }
  return depth >= least_[i];
}

void CoarseDepth::find_holes(const Rect& pixels, const VisibilityTile& tile, Holes& holes) const {
  int count = 0;
  const auto add = [&](int x, int y) {
    holes.column[count] = float(x);
    holes.row[count++] = float(y - pixels.y_begin);
  };
  Batch least(infinite);
  for (int y = pixels.y_begin; y < pixels.y_end; ++y) {
    const float* row = &tile.depth[tile.row(0, y)] + (pixels.x_begin - tile.rect.x_begin);
    unsigned empty = 0;
    for (int x = 0; x < pixels.x_end - pixels.x_begin; x += Batch::lanes) {
      const Batch depth = Batch::load(row + x);
      const auto in_block = Batch::iota(float(x)) < Batch(float(pixels.x_end - pixels.x_begin));
      least = min(least, select(in_block & (depth > Batch(0)), depth, infinite));
      empty |= bits_of(in_block & (depth <= Batch(0))) << x;
    }
    if (empty != 0) add(std::countr_zero(empty), y), add(std::bit_width(empty) - 1, y);
  }
  holes.least = hn::GetLane(hn::MinOfLanes(Batch::tag, least.raw));
  for (int i = count; i < 2 * block_height; ++i)
    holes.column[i] = holes.column[0], holes.row[i] = holes.row[0];
}

bool CoarseDepth::hides(const Rect& pixels, float nearest, const VisibilityTile& tile) {
  const auto [first_column, last_column, first_row, last_row] = blocks(pixels);
  for (int row = first_row; row <= last_row; ++row)
    for (int column = first_column; column <= last_column; ++column)
      if (nearest >= least_[std::size_t(row * stride_ + column)] &&
          refresh(column, row, nearest, tile))
        return false;
  return true;
}

void CoarseDepth::expect(const Rect& pixels) {
  const auto [first_column, last_column, first_row, last_row] = blocks(pixels);
  for (int row = first_row; row <= last_row; ++row)
    for (int column = first_column; column <= last_column; ++column)
      written_[std::size_t(row * stride_ + column)] +=
          int(area(intersection(block(column, row), pixels)));
}

bool CoarseDepth::visible(const DrawnTriangle& triangle, const Rect& pixels,
                          const VisibilityTile& tile, VisibleColumns& columns) {
  const auto [first_column, last_column, first_row, last_row] = blocks(pixels);
  std::optional<Outline> outline;  // rarely asked for
  const GreatestDepth greatest(triangle, rect_.x_begin, rect_.y_begin, block_width, block_height);
  bool any = false;
  columns.y_begin = rect_.y_begin;
  for (int row = first_row; row <= last_row; ++row) {
    int begin = last_column + 1, end = first_column;
    for (int column = first_column; column <= last_column; column += Batch::lanes) {
      const Batch depth = greatest.at(column, row);
      const Batch least = Batch::load(&least_[std::size_t(row * stride_ + column)]);
      unsigned seen = bits_of(depth >= least);
      if (last_column - column + 1 < Batch::lanes) seen &= (1u << (last_column - column + 1)) - 1;
      if (seen == 0) continue;
      float depths[max_lanes];
      depth.store(depths);
      for (; seen != 0; seen &= seen - 1) {
        const int lane = std::countr_zero(seen), at = column + lane;
        if (!refresh(at, row, depths[lane], tile)) continue;
        const Holes& holes = holes_[std::size_t(row * stride_ + at)];
        const Rect here = block(at, row);
        if (depths[lane] < holes.least && !outline) outline.emplace(triangle);
        if (depths[lane] < holes.least &&
            outline->misses(here.x_begin, here.y_begin, holes.column, holes.row))
          continue;
        begin = std::min(begin, at), end = at + 1;
      }
    }
    for (int column = begin; column < end; ++column)
      written_[std::size_t(row * stride_ + column)] +=
          int(area(intersection(block(column, row), pixels)));
    if (begin < end) {
      const Rect seen = block(begin, row);
      if (!any) columns.first_row = seen.y_begin;
      columns.end_row = seen.y_end;
      any = true;
    }
    columns.ranges[row] = {rect_.x_begin + begin * block_width, rect_.x_begin + end * block_width};
  }
  return any;
}

}  // namespace scanlit
