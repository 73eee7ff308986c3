// (7) Scan conversion, fragment by fragment, for triangles one can follow by hand.
#include <algorithm>
#include <array>

#include "rasterizer/scan_conversion.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

using Pixels = std::vector<std::pair<int, int>>;  // (x, y), in row order
using Corners = std::array<glm::dvec2, 3>;        // on the screen, in pixels

constexpr int size = 8;  // of the hand-written cases' picture

ScreenTriangle triangle_of(const Corners& c) {
  return screen_triangle(at_pixel(c[0].x, c[0].y), at_pixel(c[1].x, c[1].y),
                         at_pixel(c[2].x, c[2].y));
}

Pixels by_spans(const Corners& corners) {
  Pixels pixels;
  for_each_span(triangle_of(corners), 0, size, [&](int y, int begin, int end) {
    for (int x = std::max(begin, 0); x < std::min(end, size); ++x) pixels.push_back({x, y});
  });
  return pixels;
}

Pixels by_scan_conversion(const Corners& corners) {
  const VisibilityTile tile = scan({triangle_of(corners)}, {0, 0, size, size});
  Pixels pixels;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      if (seen(tile, x, y) == 0) pixels.push_back({x, y});
  return pixels;
}

Pixels by_render(const Corners& corners) {
  std::vector<glm::vec3> positions;
  for (const glm::dvec2& corner : corners) positions.emplace_back(corner, 0.5);
  const Scene scene = scene_of({object_of(triangle_soup(on_screen(positions)))});
  const Picture picture = picture_of(scene, pixel_camera(size, size), size, size);
  Pixels pixels;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      if (picture.triangle(x, y) == 0) pixels.push_back({x, y});
  EXPECT_EQ(picture.stats.fragments, std::int64_t(pixels.size()));
  return pixels;
}

/// In each of the six orders of its vertices, three of them facing away, and on every way.
void expect_fragments(Corners corners, const Pixels& expected) {
  std::array<int, 3> order = {0, 1, 2};
  do {
    const Corners c = {corners[std::size_t(order[0])], corners[std::size_t(order[1])],
                       corners[std::size_t(order[2])]};
    SCOPED_TRACE(testing::PrintToString(order));
    EXPECT_EQ(by_spans(c), expected);
    EXPECT_EQ(by_scan_conversion(c), expected);
    EXPECT_EQ(by_render(c), expected);
  } while (std::ranges::next_permutation(order).found);
}

TEST(Coverage, HalvesOfASquareShareTheDiagonalThroughCentres) {
  expect_fragments({{{0, 0}, {4, 0}, {0, 4}}}, {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {0, 2}});
  expect_fragments(
      {{{4, 0}, {4, 4}, {0, 4}}},
      {{3, 0}, {2, 1}, {3, 1}, {1, 2}, {2, 2}, {3, 2}, {0, 3}, {1, 3}, {2, 3}, {3, 3}});
}

TEST(Coverage, VerticesAndEdgesOnCentres) {
  // Left and top edge, with the corner between them, are in; right and bottom ones out.
  expect_fragments({{{1.5, 1.5}, {3.5, 1.5}, {1.5, 3.5}}}, {{1, 1}, {2, 1}, {1, 2}});
  expect_fragments({{{3.5, 1.5}, {3.5, 3.5}, {1.5, 3.5}}}, {{2, 2}});
}

TEST(Coverage, FanAroundACentre) {
  const glm::dvec2 centre(2.5, 2.5), a(0.5, 0.5), b(4.5, 0.5), c(4.5, 4.5), d(0.5, 4.5);
  expect_fragments({a, b, centre}, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 1}, {2, 1}});
  expect_fragments({b, c, centre}, {{3, 1}, {2, 2}, {3, 2}, {3, 3}});
  expect_fragments({c, d, centre}, {{1, 3}, {2, 3}});
  expect_fragments({d, a, centre}, {{0, 1}, {0, 2}, {1, 2}, {0, 3}});
}

TEST(Coverage, SliversAlongADiagonal) {
  const double step = 1.0 / 256;
  // The centres on the diagonal belong to the sliver on its right alone.
  expect_fragments({{{0, 0}, {step, 0}, {8, 8}}},
                   {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 6}, {7, 7}});
  expect_fragments({{{0, 0}, {0, step}, {8, 8}}}, {});
}

TEST(Coverage, SliversAlongRowsAndColumns) {
  const double step = 1.0 / 256;
  expect_fragments({{{0, 2.5}, {8, 2.5}, {0, 2.5 + step}}},
                   {{0, 2}, {1, 2}, {2, 2}, {3, 2}, {4, 2}, {5, 2}, {6, 2}, {7, 2}});
  expect_fragments({{{0, 2.5}, {8, 2.5}, {0, 2.5 - step}}}, {});
  expect_fragments({{{2.5, 0}, {2.5, 4}, {2.5 + step, 0}}}, {{2, 0}, {2, 1}, {2, 2}, {2, 3}});
  expect_fragments({{{2.5, 0}, {2.5, 4}, {2.5 - step, 0}}}, {});
  expect_fragments({{{0, 2.75}, {8, 3}, {8, 3.25}}}, {});  // between two rows of centres
}

TEST(Coverage, TrianglesOfAPixel) {
  expect_fragments({{{2.25, 2.25}, {3, 2.5}, {2.25, 3}}}, {{2, 2}});
  expect_fragments({{{2, 2}, {2.25, 2}, {2, 2.25}}}, {});                // misses the centre
  expect_fragments({{{2.5, 2.5}, {2.75, 2.5}, {2.5, 2.75}}}, {{2, 2}});  // begins on it
  expect_fragments({{{2.5, 2.5}, {2.25, 2.5}, {2.5, 2.25}}}, {});        // ends on it
}

TEST(Coverage, ZeroArea) {
  expect_fragments({{{1, 1}, {4, 4}, {7, 7}}}, {});
  expect_fragments({{{0, 2.5}, {4, 2.5}, {8, 2.5}}}, {});
  expect_fragments({{{2.5, 2.5}, {2.5, 2.5}, {2.5, 2.5}}}, {});
  expect_fragments({{{2.5, 2.5}, {2.5, 2.5}, {6.5, 4.5}}}, {});
}

TEST(Coverage, OffTheScreen) {
  expect_fragments({{{-9, 0}, {-1, 0}, {-1, 8}}}, {});
  expect_fragments({{{9, 0}, {20, 0}, {9, 8}}}, {});
  expect_fragments({{{0, -9}, {8, -9}, {8, -1}}}, {});
  expect_fragments({{{0, 9}, {8, 9}, {8, 20}}}, {});
  expect_fragments({{{-8, 8}, {-8, -8}, {8, -8}}}, {});  // its box meets the picture, it does not
}

TEST(Coverage, PartlyOffTheScreen) {
  expect_fragments({{{-40, -40}, {43, -40}, {-40, 43}}}, {{0, 0}, {1, 0}, {0, 1}});
  expect_fragments({{{40, 40}, {-27, 40}, {40, -27}}},
                   {{7, 5}, {6, 6}, {7, 6}, {5, 7}, {6, 7}, {7, 7}});
}

}  // namespace
}  // namespace scanlit
