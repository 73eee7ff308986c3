// TilesOfTriangles: each drawn triangle is in the one tile that holds all its pixels, or in
// several.
#include "rasterizer/triangle_culling.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

namespace scanlit {
namespace {

TEST(TilesOfTriangles, HoldEachTriangleOnce) {
  const Viewport viewport{2500, 300};
  const TileGrid grid = make_tile_grid(viewport, 1);
  ASSERT_GT(grid.columns, 1);
  ASSERT_GT(grid.rows, 1);
  std::mt19937 random(7);
  const auto integer = [&](int low, int high) {
    return std::uniform_int_distribution(low, high)(random);
  };
  const auto culled = std::make_unique<CulledCluster>();
  for (const int count : {1, 15, 16, 100, CulledCluster::capacity}) {
    culled->drawn_count = count;
    for (int i = 0; i < count; ++i) {
      // Half of them begin or end where a tile does.
      const bool at_border = integer(0, 1) != 0;
      const int x = at_border ? 1024 - integer(0, 8) : integer(0, viewport.width - 8);
      const int y = at_border ? 64 * integer(1, 4) - integer(0, 8) : integer(0, 290);
      culled->x_begin[i] = x, culled->x_end[i] = x + integer(1, 8);
      culled->y_begin[i] = y, culled->y_end[i] = y + integer(1, 8);
    }
    TilesOfTriangles tiles(*culled, grid);
    int found = 0;
    for (int tile = 0; tile < grid.count(); ++tile)
      for (const std::int32_t i : tiles.in(tile)) {
        const Rect box = culled->box_of(i);
        EXPECT_EQ(intersection(box, grid.tile(tile)), box);
        ++found;
      }
    for (const std::int32_t i : tiles.in(TilesOfTriangles::several)) {
      const Rect box = culled->box_of(i);
      for (int tile = 0; tile < grid.count(); ++tile)
        EXPECT_NE(intersection(box, grid.tile(tile)), box);
      ++found;
    }
    EXPECT_EQ(found, count);
  }
}

}  // namespace
}  // namespace scanlit
