#include "rasterizer/screen.h"

namespace scanlit {

TileGrid make_tile_grid(const Viewport& viewport, int samples) {
  // Depth and id of a tile's samples, 8 bytes each, should fill about half of a 1 MiB second-level
  // cache. Of such tiles the widest are measured to be fastest up to 1024 pixels.
  const auto shift_of = [](int size) { return int(std::bit_width(unsigned(size))) - 1; };
  const int budget = shift_of(64 * 1024 / samples), min_height = 4,
            max_height = shift_of(max_tile_height), max_width = 10;
  TileGrid grid{
      .width_shift = std::min({shift_of(2 * viewport.width - 1), budget - min_height, max_width}),
      .height_shift = 0,
      .columns = 0,
      .rows = 0,
      .viewport = viewport};
  grid.height_shift = std::clamp(budget - grid.width_shift, min_height, max_height);
  grid.columns = grid.column(viewport.width - 1) + 1;
  grid.rows = grid.row(viewport.height - 1) + 1;
  return grid;
}

}  // namespace scanlit
