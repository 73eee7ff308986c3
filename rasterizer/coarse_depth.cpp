#include "rasterizer/coarse_depth.h"

#include <algorithm>

#include "rasterizer/batch.h"

namespace scanlit {

void CoarseDepth::reset(const VisibilityTile& tile) {
  rect_ = tile.touched;
  columns_ = (rect_.x_end - rect_.x_begin + block_width - 1) / block_width;
  const int rows = (rect_.y_end - rect_.y_begin + block_height - 1) / block_height;
  full_ = block_width * block_height;
  blocks_.assign(std::size_t(columns_) * std::size_t(rows), {});
}

template <class Use>
bool CoarseDepth::all_blocks(const Rect& pixels, const Use& use) {
  const int first_row = (pixels.y_begin - rect_.y_begin) / block_height;
  const int last_row = (pixels.y_end - 1 - rect_.y_begin) / block_height;
  const int first_column = (pixels.x_begin - rect_.x_begin) / block_width;
  const int last_column = (pixels.x_end - 1 - rect_.x_begin) / block_width;
  for (int row = first_row; row <= last_row; ++row)
    for (int column = first_column; column <= last_column; ++column)
      if (!use(blocks_[std::size_t(row) * std::size_t(columns_) + std::size_t(column)], row,
               column))
        return false;
  return true;
}

bool CoarseDepth::hides(const Rect& pixels, float nearest, const VisibilityTile& tile) {
  return all_blocks(pixels, [&](Block& block, int row, int column) {
    if (nearest < block.least) return true;
    if (block.pixels_written < full_) return false;
    const int x = rect_.x_begin + column * block_width, y = rect_.y_begin + row * block_height;
    block.least = least_depth(
        {x, y, std::min(x + block_width, rect_.x_end), std::min(y + block_height, rect_.y_end)},
        tile);
    block.pixels_written = 0;
    return nearest < block.least;
  });
}

void CoarseDepth::wrote(const Rect& pixels) {
  all_blocks(pixels, [&](Block& block, int row, int column) {
    const int x = rect_.x_begin + column * block_width, y = rect_.y_begin + row * block_height;
    const int width = std::min(pixels.x_end, x + block_width) - std::max(pixels.x_begin, x);
    const int height = std::min(pixels.y_end, y + block_height) - std::max(pixels.y_begin, y);
    block.pixels_written += width * height;
    return true;
  });
}

float CoarseDepth::least_depth(const Rect& pixels, const VisibilityTile& tile) {
  Batch least(1e30f);
  const Batch columns(float(pixels.x_end - pixels.x_begin));
  for (int sample = 0; sample < tile.samples; ++sample)
    for (int y = pixels.y_begin; y < pixels.y_end; ++y) {
      const float* row =
          &tile.depth[tile.row(sample, y) + std::size_t(pixels.x_begin - tile.rect.x_begin)];
      for (int i = 0; i < block_width; i += Batch::lanes) {
        const Batch depth = select(Batch::iota(float(i)) < columns, Batch::load(row + i), 1e30f);
        least = min(least, depth);
      }
    }
  return hn::GetLane(hn::MinOfLanes(Batch::tag, least.raw));
}

}  // namespace scanlit
