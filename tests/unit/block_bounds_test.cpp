// Outline leaves out no block of pixels and no hole that its triangle covers.
#include "rasterizer/block_bounds.h"

#include <gtest/gtest.h>

#include <random>

namespace scanlit {
namespace {

constexpr int block_width = 16, block_height = 16, columns = 8, rows = 2;
constexpr int x_begin = 500, y_begin = 300;  // of the blocks' first pixel

struct Covered {
  bool pixel[rows * block_height][columns * block_width] = {};

  /// With every pixel's sample `offset` from its centre.
  Covered(DrawnTriangle t, SampleOffset offset) {
    for (ScreenVertex& v : t.vertices) v.x -= offset.x, v.y -= offset.y;
    const auto& [a, b, c] = t.vertices;
    const int x_end = x_begin + columns * block_width, y_end = y_begin + rows * block_height;
    for_each_span(screen_triangle(a, b, c), y_begin, y_end, [&](int y, int begin, int end) {
      for (int x = std::max(begin, x_begin); x < std::min(end, x_end); ++x)
        pixel[y - y_begin][x - x_begin] = true;
    });
  }
  bool any(int x, int y, int width, int height) const {
    for (int row = y; row < y + height; ++row)
      if (std::any_of(pixel[row] + x, pixel[row] + x + width, [](bool p) { return p; }))
        return true;
    return false;
  }
};

class OutlineOfTriangles : public testing::TestWithParam<int> {
 protected:
  std::mt19937 random{5};

  int integer(int least, int most) { return std::uniform_int_distribution(least, most)(random); }
  /// Corners up to GetParam() pixels away.
  DrawnTriangle triangle() {
    const int reach = GetParam() * subpixel;
    DrawnTriangle t{};
    for (ScreenVertex& v : t.vertices) {
      v.x = x_begin * subpixel + integer(-reach, reach);
      v.y = y_begin * subpixel + integer(-reach, reach);
    }
    return t;
  }
};

/// Columns first to last of some rows.
void add_row(Holes& holes, int row, int first, int last) {
  const int begin = holes.rows++;
  const int end = begin == 0 ? Holes::most_rows : holes.rows;
  std::fill(holes.row + begin, holes.row + end, float(row));
  std::fill(holes.first + begin, holes.first + end, float(first));
  std::fill(holes.last + begin, holes.last + end, float(last));
}

TEST_P(OutlineOfTriangles, MeetsEveryBlockWithASampleInIt) {
  int met = 0, left_out = 0;
  for (int i = 0; i < 2000; ++i) {
    const DrawnTriangle t = triangle();
    const Outline outline(t, x_begin, y_begin);
    const Covered covered(t, {integer(-128, 127), integer(-128, 127)});
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const int lane = column % Batch::lanes;
        const unsigned meets =
            bits_of(outline.meets(column - lane, row, block_width, block_height));
        const bool may = meets >> lane & 1;
        (may ? met : left_out)++;
        ASSERT_TRUE(may || !covered.any(column * block_width, row * block_height, block_width,
                                        block_height))
            << "triangle " << i << ", block " << column << ", " << row;
      }
    }
  }
  EXPECT_GT(met, 1000);
  EXPECT_GT(left_out, 1000);
}

TEST_P(OutlineOfTriangles, MissesNoHoleThatItCovers) {
  int missed = 0, could_be = 0;
  for (int i = 0; i < 4000; ++i) {
    const DrawnTriangle t = triangle();
    const Covered covered(t, {0, 0});
    const int x = block_width * integer(0, columns - 1), y = block_height * integer(0, rows - 1);
    Holes holes;
    bool hit = false;
    for (int row = integer(0, 3); row < block_height; ++row) {
      const int first = integer(0, block_width - 1), last = integer(first, block_width - 1);
      add_row(holes, row, first, last);
      hit |= covered.any(x + first, y + row, last - first + 1, 1);
    }
    const bool misses = Outline(t, x_begin, y_begin).misses(x, y, holes);
    ASSERT_FALSE(misses && hit) << "triangle " << i;
    missed += misses, could_be += !hit;
  }
  EXPECT_GT(missed, 0.95 * could_be);
}

/// One that is a pixel's centre, which an edge goes through.
TEST_P(OutlineOfTriangles, MissesNoHoleOnItsEdge) {
  int covered_ones = 0;
  for (int i = 0; i < 4000; ++i) {
    DrawnTriangle t = triangle();
    auto& [a, b, c] = t.vertices;
    const int x = integer(0, 100), y = integer(0, rows * block_height - 1);
    b.x = 2 * ((x_begin + x) * subpixel + half_pixel) - a.x;
    b.y = 2 * ((y_begin + y) * subpixel + half_pixel) - a.y;
    Holes holes;
    add_row(holes, y % block_height, x % block_width, x % block_width);
    const bool is_covered = Covered(t, {0, 0}).pixel[y][x];
    covered_ones += is_covered;
    const bool misses =
        Outline(t, x_begin, y_begin).misses(x - x % block_width, y - y % block_height, holes);
    ASSERT_FALSE(misses && is_covered) << "triangle " << i;
  }
  EXPECT_GT(covered_ones, 1000);
}

/// Below its tip, holes on both sides of the prolonged edges.
TEST(Outline, MissesHolesBelowItsTip) {
  DrawnTriangle t{};
  const double corners[3][2] = {{33, -57}, {12.5, 3.6}, {20, -4.3}};
  for (int i = 0; i < 3; ++i)
    t.vertices[i].x = int(subpixel * (x_begin + corners[i][0])),
    t.vertices[i].y = int(subpixel * (y_begin + corners[i][1]));
  Holes holes;
  for (int row = 4; row < block_height; ++row) add_row(holes, row, 0, 11);
  EXPECT_TRUE(Outline(t, x_begin, y_begin).misses(0, 0, holes));
  add_row(holes, 1, 0, 13);
  EXPECT_FALSE(Outline(t, x_begin, y_begin).misses(0, 0, holes));
}

INSTANTIATE_TEST_SUITE_P(Reach, OutlineOfTriangles, testing::Values(40, 400, 1 << 15));

}  // namespace
}  // namespace scanlit
