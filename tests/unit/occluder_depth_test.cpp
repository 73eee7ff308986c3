// OccluderDepth holds no block to be nearer than its farthest pixel, and most to be as near.
#include "rasterizer/occluder_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

constexpr int width = OccluderBlock::width, height = OccluderBlock::height;
const Rect tile{256, 64, 256 + 8 * width, 64 + 8 * height};

OccluderDepth depth_of(const std::vector<ScreenTriangle>& triangles, int samples) {
  OccluderDepth occluders;
  occluders.reset(tile, samples);
  for (const ScreenTriangle& t : triangles) {
    DrawnTriangle drawn{};
    std::ranges::copy(t.vertices, drawn.vertices);
    occluders.add(drawn);
  }
  return occluders;
}

float farthest(const VisibilityTile& visibility, int column, int row) {
  float depth = 1;
  for (int sample = 0; sample < visibility.samples; ++sample)
    for (int y = tile.y_begin + row * height; y < tile.y_begin + (row + 1) * height; ++y)
      for (int x = column * width; x < (column + 1) * width; ++x)
        depth = std::min(depth, visibility.depth[visibility.row(sample, y) + std::size_t(x)]);
  return depth;
}

TEST(OccluderDepth, IsThatOfNoPixelOrLess) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> real(0, 1);
  int covered = 0, known = 0;
  for (int round = 0; round < 400; ++round) {
    const int samples = round % 4 == 3 ? 4 : 1;
    std::vector<ScreenTriangle> triangles;
    for (int i = 0; i < 4; ++i) {
      // Tilted: a plane's depths at four corners, and their two triangles.
      const double x = tile.x_begin - 60 + 160 * real(random), y = 20 + 80 * real(random),
                   w = 20 + 200 * real(random), h = 10 + 120 * real(random),
                   skew = 40 * real(random), first = real(random) / 2, right = real(random) / 4,
                   below = real(random) / 4;
      const ScreenVertex a = at_pixel(x, y, float(first)),
                         b = at_pixel(x + w, y + skew, float(first + right)),
                         c = at_pixel(x + w, y + skew + h, float(first + right + below)),
                         d = at_pixel(x, y + h, float(first + below));
      triangles.push_back(screen_triangle(a, b, c)), triangles.push_back(screen_triangle(a, c, d));
    }
    const VisibilityTile visibility = scan(triangles, tile, samples);
    const OccluderDepth occluders = depth_of(triangles, samples);
    for (int row = 0; row < 8; ++row)
      for (int column = 0; column < 8; ++column) {
        const float exact = farthest(visibility, column, row);
        const float least = occluders.least(column, row);
        ASSERT_LE(least, exact) << "round " << round << ", block " << column << ", " << row;
        covered += exact > 0, known += least > 0;
      }
  }
  EXPECT_GT(covered, 5000);
  EXPECT_GT(known, 0.95 * covered);
}

/// The two triangles of a square, whose diagonal goes through blocks that neither covers.
TEST(OccluderDepth, IsKnownAlongASharedEdge) {
  const float x = float(tile.x_begin), y = float(tile.y_begin), side = 8 * height;
  const ScreenVertex a = at_pixel(x, y), b = at_pixel(x + side, y),
                     c = at_pixel(x + side, y + side), d = at_pixel(x, y + side);
  const OccluderDepth occluders = depth_of({screen_triangle(a, b, c), screen_triangle(a, c, d)}, 1);
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column)
      EXPECT_EQ(occluders.least(column, row) > 0.4999f, column < 4) << column << ", " << row;
}

/// What is begun far away does not take along what is nearer.
TEST(OccluderDepth, OfWhatIsMuchNearerCounts) {
  OccluderBlock block;
  OccluderBlock::Pixels some{}, others;
  some[0] = 1;
  others.fill(0xffff), others[0] = 0xfffe;
  block.cover(others, 0.1f);
  block.cover(others, 0.8f);
  block.cover(some, 0.7f);
  EXPECT_EQ(block.least(), 0.7f);
  block.cover_all(0.75f);
  EXPECT_EQ(block.least(), 0.75f);
}

}  // namespace
}  // namespace scanlit
