// The comparison with a ray tracer: what counts as another surface, and where coverage may differ.
#include <gtest/gtest.h>

#include "tests/bench/bench_scenes.h"
#include "tests/bench/visibility_difference.h"

namespace scanlit::bench {
namespace {

constexpr int side = 8;

std::size_t at(int x, int y) { return std::size_t(y * side + x); }

float depth_at(double distance) {  // as clip_from_world() maps it
  return float(near_distance * (far_distance - distance) /
               (distance * (far_distance - near_distance)));
}

/// Pixels [2, 6) x [2, 6) see triangle 5 of object 0 at distance 3, in both.
struct Square {
  Framebuffer picture{side, side, {.depth = true, .ids = true}};
  Hits hits{side, side};

  Square() {
    for (int y = 2; y < 6; ++y)
      for (int x = 2; x < 6; ++x) {
        hits.object[at(x, y)] = picture.object_id[at(x, y)] = 0;
        hits.triangle[at(x, y)] = picture.triangle_id[at(x, y)] = 5;
        hits.distance[at(x, y)] = 3;
        picture.depth[at(x, y)] = depth_at(3);
      }
  }
};

TEST(BenchVisibility, TheSameIsTheSame) {
  const Square square;
  const VisibilityDifference difference = compare(square.picture, square.hits);
  EXPECT_EQ(difference.both, 16);
  EXPECT_EQ(difference.another_triangle, 0);
  EXPECT_EQ(difference.coverage_differs, 0);
  EXPECT_LT(difference.max_distance, 1e-6);
  const Rect rect = covered_rect(square.picture);
  EXPECT_EQ(rect.x_begin, 2);
  EXPECT_EQ(rect.y_begin, 2);
  EXPECT_EQ(rect.x_end, 6);
  EXPECT_EQ(rect.y_end, 6);
}

TEST(BenchVisibility, AnotherTriangleMayBeTheSameSurface) {
  Square square;
  square.hits.triangle[at(3, 3)] = 6;
  square.hits.distance[at(3, 3)] = 3.001f;
  square.hits.triangle[at(4, 3)] = 6;
  square.hits.distance[at(4, 3)] = 3.01f;
  const VisibilityDifference difference = compare(square.picture, square.hits);
  EXPECT_EQ(difference.another_triangle, 2);
  EXPECT_EQ(difference.another_surface, 1);
  EXPECT_NEAR(difference.max_distance, .01 / 3, 1e-4);
}

TEST(BenchVisibility, CoverageDiffersAtTheSilhouetteOrInside) {
  Square square;
  square.hits.object[at(2, 3)] = no_id;  // a border pixel missing
  square.hits.object[at(6, 3)] = 0;      // one too many, beside the border
  square.hits.object[at(4, 4)] = no_id;  // a hole
  square.hits.object[at(0, 0)] = 0;      // far outside
  const VisibilityDifference difference = compare(square.picture, square.hits);
  EXPECT_EQ(difference.both, 14);
  EXPECT_EQ(difference.coverage_differs, 4);
  EXPECT_EQ(difference.coverage_differs_inside, 2);
}

}  // namespace
}  // namespace scanlit::bench
