// (7) Many tiny triangles at once cover what they cover one by one, at the same depths.
#include "rasterizer/tiny_triangles.h"

#include <algorithm>
#include <bit>
#include <random>

#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

const Rect rect{30, 17, 70, 50};  // a tile that is not the picture's first

/// Of any orientation, in and around the tile: slivers, and corners on pixel centres, at equal
/// depths too, and boxes too large to be tiny.
std::vector<DrawnTriangle> random_triangles(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto integer = [&](int low, int high) {
    return std::uniform_int_distribution(low, high)(random);
  };
  std::vector<DrawnTriangle> triangles;
  for (int i = 0; i < 400; ++i) {
    const int size = integer(0, 1) ? integer(64, 600) : integer(600, 3000);
    const int grid = integer(0, 1) ? 1 : half_pixel;
    const int x = integer(25, 72) * subpixel, y = integer(12, 52) * subpixel;
    DrawnTriangle t{};
    t.triangle = std::uint32_t(integer(0, 1000));
    const float depth = float(integer(0, 3)) / 4, slope = integer(0, 1) ? 0.0f : 1e-3f;
    for (ScreenVertex& v : t.vertices)
      v = {x + integer(-size, size) / grid * grid, y + integer(-size, size) / grid * grid,
           depth + slope * float(integer(0, 99)), 1};
    const auto& v = t.vertices;
    if (screen_triangle(v[0], v[1], v[2]).twice_area != 0) triangles.push_back(t);
  }
  return triangles;
}

VisibilityTile empty_tile(const std::vector<DrawnTriangle>& triangles, int samples) {
  VisibilityTile tile;
  tile.reset(rect, rect, samples);
  for (const DrawnTriangle& t : triangles) tile.triangles.push_back(&t);
  return tile;
}

TEST(TinyTriangles, CoverWhatTheyCoverOneByOne) {
  int tiny = 0, not_tiny = 0;
  for (std::uint64_t seed = 0; seed < 25; ++seed)
    for (const int samples : {1, 4, 8, 16}) {
      const std::vector<DrawnTriangle> triangles = random_triangles(seed);
      VisibilityTile expected = empty_tile(triangles, samples), tile = expected;
      for (TriangleId id = 0; id < triangles.size(); ++id) scan_convert(id, expected, nullptr);
      for (std::size_t first = 0; first < triangles.size();) {
        // Not always as many as fit.
        const std::size_t count =
            std::min(1 + (first + seed) % tiny_at_once, triangles.size() - first);
        const unsigned others =
            scan_convert_tiny({&triangles[first], count}, TriangleId(first), tile);
        for (unsigned bits = others; bits != 0; bits &= bits - 1)
          scan_convert(TriangleId(first) + TriangleId(std::countr_zero(bits)), tile, nullptr);
        not_tiny += std::popcount(others);
        tiny += int(count) - std::popcount(others);
        first += count;
      }
      for (int s = 0; s < samples; ++s)
        for (int y = rect.y_begin; y < rect.y_end; ++y)
          for (int x = rect.x_begin; x < rect.x_end; ++x) {
            const int there = seen(tile, x, y, s), wanted = seen(expected, x, y, s);
            ASSERT_EQ(depth_of(tile, x, y, s), depth_of(expected, x, y, s)) << x << ' ' << y;
            // Which of two that are the same one is seen is not said.
            if (there == wanted) continue;
            ASSERT_TRUE(there >= 0 && wanted >= 0) << x << ' ' << y;
            ASSERT_EQ(triangles[std::size_t(there)].triangle,
                      triangles[std::size_t(wanted)].triangle);
          }
    }
  EXPECT_GT(tiny, 10000);
  EXPECT_GT(not_tiny, 10000);
}

TEST(TinyTriangles, OfOneDepthTheFirstIsSeen) {
  const ScreenVertex a = at_pixel(40, 20), b = at_pixel(44, 20), c = at_pixel(40, 24);
  std::vector<DrawnTriangle> same;
  for (const unsigned number : {7u, 3u, 5u, 3u, 9u})
    same.push_back({{a, c, b}, 0, number, 0, DrawnTriangle::not_cut});
  VisibilityTile tile = empty_tile(same, 1);
  EXPECT_EQ(scan_convert_tiny({same.data(), std::min(same.size(), tiny_at_once)}, 0, tile), 0u);
  EXPECT_EQ(seen(tile, 41, 21), 1);
}

}  // namespace
}  // namespace scanlit
