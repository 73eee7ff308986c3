#include "rasterizer/coarse_depth.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "rasterizer/block_bounds.h"

namespace scanlit {

namespace {

/// The least depth of any sample of `pixels`, which are not empty and within tile.touched.
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

}  // namespace

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
  holes.rows = 0;
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
    if (empty == 0) continue;
    holes.row[holes.rows] = float(y - pixels.y_begin);
    holes.first[holes.rows] = float(std::countr_zero(empty));
    holes.last[holes.rows++] = float(std::bit_width(empty) - 1);
  }
  holes.least = hn::GetLane(hn::MinOfLanes(Batch::tag, least.raw));
  for (int i = holes.rows; i < Holes::most_rows; ++i)
    holes.row[i] = holes.row[0], holes.first[i] = holes.first[0], holes.last[i] = holes.last[0];
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
      if (!outline) outline.emplace(triangle, rect_.x_begin, rect_.y_begin);
      seen &= bits_of(outline->meets(column, row, block_width, block_height));
      float depths[max_lanes];
      depth.store(depths);
      for (; seen != 0; seen &= seen - 1) {
        const int lane = std::countr_zero(seen), at = column + lane;
        if (!refresh(at, row, depths[lane], tile)) continue;
        const Holes& holes = holes_[std::size_t(row * stride_ + at)];
        if (depths[lane] < holes.least &&
            outline->misses(at * block_width, row * block_height, holes))
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
