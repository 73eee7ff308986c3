#include "rasterizer/occluder_depth.h"

#include <algorithm>

#include "rasterizer/block_bounds.h"
#include "rasterizer/row_spans.h"

namespace scanlit {

namespace {

constexpr int width = OccluderBlock::width, height = OccluderBlock::height;

/// What a triangle covers of some rows of pixels: [begin, end) of each; begin > end where it is
/// nothing.
struct CoveredRows {
  static constexpr int count = std::max(height, Batch::lanes);
  int begin[count], end[count];

  /// From row y on; of `part` alone.
  CoveredRows(const RowSpans& spans, int y, const Rect& part) {
    RowSpans::Rows found;
    for (int i = 0; i < count; ++i) {
      const int lane = i % Batch::lanes;
      if (lane == 0) found = spans.from(y + i);
      begin[i] = std::max(found.begin[lane], part.x_begin);
      end[i] = std::min(found.end[lane], part.x_end);
      const bool inside = y + i >= part.y_begin && y + i < part.y_end;
      if (!inside || begin[i] >= end[i]) begin[i] = part.x_end, end[i] = part.x_begin;
    }
  }
};

/// Of those, the ones of a row of blocks.
class BlockRow {
 public:
  BlockRow(const CoveredRows& rows, int first)
      : begin_(rows.begin + first),
        end_(rows.end + first),
        whole_begin_(*std::max_element(begin_, begin_ + height)),
        whole_end_(*std::min_element(end_, end_ + height)) {}

  /// Outside of which nothing is covered.
  int begin() const { return *std::min_element(begin_, begin_ + height); }
  int end() const { return *std::max_element(end_, end_ + height); }

  void cover(int x, float depth, OccluderBlock& block) const {
    if (whole_begin_ <= x && x + width <= whole_end_)
      block.cover_all(depth);
    else
      block.cover(pixels(x), depth);
  }

 private:
  OccluderBlock::Pixels pixels(int x) const {
    const auto left_of = [&](int column) { return (1u << std::clamp(column - x, 0, width)) - 1; };
    OccluderBlock::Pixels all;
    for (int i = 0; i < height; ++i)
      all[std::size_t(i)] = std::uint16_t(left_of(end_[i]) & ~left_of(begin_[i]));
    return all;
  }

  const int *begin_, *end_;
  int whole_begin_, whole_end_;
};

}  // namespace

void OccluderBlock::cover(const Pixels& pixels, float depth) {
  if (depth <= least_) return;
  // What was begun much farther away would make this one as deep: it is given up.
  if (depth - begun_ > begun_ - least_) {
    begun_ = depth, begun_pixels_ = pixels;
  } else {
    begun_ = std::min(begun_, depth);
    for (std::size_t i = 0; i < height; ++i) begun_pixels_[i] |= pixels[i];
  }
  if (std::ranges::all_of(begun_pixels_, [](std::uint16_t row) { return row == 0xffff; }))
    least_ = begun_, begun_pixels_ = {};
}

void OccluderDepth::reset(const Rect& tile, int samples) {
  tile_ = tile;
  columns_ = (tile.x_end - tile.x_begin + width - 1) / width;
  const int rows = (tile.y_end - tile.y_begin + height - 1) / height;
  samples_.resize(std::size_t(samples));
  for (auto& blocks : samples_) blocks.assign(std::size_t(columns_ * rows), {});
}

void OccluderDepth::add(const DrawnTriangle& drawn) {
  // The least depth is the greatest one of a triangle whose depths are the opposite.
  DrawnTriangle opposite = drawn;
  for (ScreenVertex& vertex : opposite.vertices) vertex.depth = -vertex.depth;
  const GreatestDepth greatest(opposite, tile_.x_begin, tile_.y_begin, width, height);
  const auto& v = drawn.vertices;
  const ScreenTriangle triangle = screen_triangle(v[0], v[1], v[2]);
  const auto offsets = sample_offsets(int(samples_.size()));
  for (std::size_t sample = 0; sample < samples_.size(); ++sample)
    add(moved(triangle, offsets[sample]), greatest, samples_[sample]);
}

void OccluderDepth::add(const ScreenTriangle& triangle, const GreatestDepth& opposite,
                        std::vector<OccluderBlock>& blocks) const {
  const DepthPlane plane(triangle);
  const RowSpans spans(triangle, plane);
  const Rect part = intersection(tile_, centre_bounds(triangle));
  if (part.empty()) return;
  const auto row_of = [&](int y) { return (y - tile_.y_begin) / height; };
  const auto column_of = [&](int x) { return (x - tile_.x_begin) / width; };
  for (int y = tile_.y_begin + row_of(part.y_begin) * height; y < part.y_end;
       y += CoveredRows::count) {
    const CoveredRows rows(spans, y, part);
    for (int first = 0; first < CoveredRows::count; first += height) {
      const BlockRow covered(rows, first);
      if (covered.begin() >= covered.end()) continue;
      const int row = row_of(y + first), end_column = column_of(covered.end() + width - 1);
      for (int column = column_of(covered.begin()); column < end_column; column += Batch::lanes) {
        float depth[Batch::lanes];
        (-opposite.at(column, row)).store(depth);
        for (int i = 0; i < std::min(Batch::lanes, end_column - column); ++i)
          covered.cover(tile_.x_begin + (column + i) * width, depth[i],
                        blocks[std::size_t(row * columns_ + column + i)]);
      }
    }
  }
}

}  // namespace scanlit
