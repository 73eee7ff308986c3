// (7) Scan conversion covers exactly what exact arithmetic says: random triangles against
// evaluation in 128 bits, and meshes against what every mesh of their kind must give.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <random>

#include "rasterizer/scan_conversion.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

/// Every sample of every pixel in `rect`, for each number of samples.
void require_exact(const ScreenTriangle& triangle, const Rect& rect) {
  for (const int samples : {1, 4, 8, 16}) {
    const VisibilityTile tile = scan({triangle}, rect, samples);
    const auto offsets = sample_offsets(samples);
    for (int s = 0; s < samples; ++s)
      for (int y = rect.y_begin; y < rect.y_end; ++y)
        for (int x = rect.x_begin; x < rect.x_end; ++x) {
          const auto [dx, dy] = offsets[std::size_t(s)];
          const bool expected = exactly_covers(triangle, x * subpixel + half_pixel + dx,
                                               y * subpixel + half_pixel + dy);
          if ((seen(tile, x, y, s) == 0) != expected)
            RC_FAIL("pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") sample " +
                    std::to_string(s) + " of " + std::to_string(samples));
        }
  }
}

void tell(const ScreenTriangle& t) {
  for (const ScreenVertex& v : t.vertices) RC_LOG() << v.x << ' ' << v.y << '\n';
}

/// Vertices often lie on quarter pixels, so that edges meet sample positions.
ScreenVertex random_vertex(int low, int high) {
  const int step = *rc::gen::element(1, 1, 16, 64, 128);
  const auto draw = [&] {
    return *rc::gen::resize(100, rc::gen::inRange(low * subpixel, high * subpixel + 1)) / step *
           step;
  };
  const int x = draw();
  return {x, draw(), 0.5f, 1};
}

TEST(Coverage, SmallTrianglesEqualExactEvaluation) {
  EXPECT_TRUE(holds(3000, [] {
    // Up to 16 pixels across goes one way in the scan converter; 24 the other.
    const int extent = *rc::gen::element(1, 2, 6, 15, 16, 17, 24);
    const int x = *rc::gen::inRange(-4, 12), y = *rc::gen::inRange(-4, 12);
    ScreenVertex v[3];
    for (ScreenVertex& vertex : v) {
      vertex = random_vertex(0, extent);
      vertex.x += x * subpixel, vertex.y += y * subpixel;
    }
    const ScreenTriangle triangle = screen_triangle(v[0], v[1], v[2]);
    tell(triangle);
    require_exact(triangle, {0, 0, 24, 20});
  }));
}

/// An edge through the neighbourhood of `around`, both ends as far away as the guard band allows.
std::pair<ScreenVertex, ScreenVertex> far_edge(const ScreenVertex& around,
                                               std::mt19937_64& random) {
  const auto within = [&](double v) {
    return std::int32_t(std::clamp(v, -double((1 << 24) - 129), double((1 << 24) - 129)));
  };
  std::uniform_real_distribution<double> angle(0, 6.3), reach(1, 24);
  const double a = angle(random), x = std::cos(a), y = std::sin(a);
  const double forth = std::exp2(reach(random)), back = std::exp2(reach(random));
  return {{within(around.x + forth * x), within(around.y + forth * y), 0.5f, 1},
          {within(around.x - back * x), within(around.y - back * y), 0.5f, 1}};
}

TEST(Coverage, TrianglesAtTheGuardBandEqualExactEvaluation) {
  EXPECT_TRUE(holds(2000, [] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    const int x = *rc::gen::element(0, 100, 16384 - 24), y = *rc::gen::element(0, 77, 16384 - 16);
    std::uniform_int_distribution<int> near(0, 16 * subpixel);
    const ScreenVertex around{x * subpixel + near(random), y * subpixel + near(random), 0.5f, 1};
    const auto [a, b] = far_edge(around, random);
    const auto [c, unused] = far_edge(around, random);
    const ScreenTriangle triangle = screen_triangle(a, b, c);
    tell(triangle);
    require_exact(triangle, {x, y, x + 24, y + 16});
  }));
}

TEST(Coverage, EdgesThatMissACentreByTheLeastPossible) {
  // In row y an edge from (ax, ay) that runs `run` to the right on `height` down crosses at
  // N / (256 height) pixels right of column 0's centre. Sought are edges where N is a multiple of
  // the denominator, or one off: a walker that drops a remainder is wrong there and hardly
  // elsewhere.
  std::mt19937_64 random(5);
  std::uniform_int_distribution<int> start(0, 4 * subpixel), heights(258, 700), runs(-6000, 6000);
  int found[3] = {};
  for (int i = 0; i < 2000000; ++i) {
    const int ax = start(random) + 24 * subpixel, ay = start(random), height = heights(random);
    const int run = runs(random), y = (ay + height - 128 - 1) >> 8;  // the last row
    const std::int64_t denominator = std::int64_t(256) * height;
    const std::int64_t numerator =
        std::int64_t(ax - half_pixel) * height + std::int64_t(y * subpixel + half_pixel - ay) * run;
    const std::int64_t off = (numerator + 1 + 100 * denominator) % denominator;
    if (off > 2) continue;
    ++found[off];
    for (const int side : {-30, 80}) {
      const ScreenVertex a{ax, ay, 0.5f, 1}, b{ax + run, ay + height, 0.5f, 1};
      const ScreenVertex c{side * subpixel, ay + height / 2, 0.5f, 1};
      const ScreenTriangle triangle = screen_triangle(a, b, c);
      EXPECT_TRUE(holds(1, [&] { tell(triangle), require_exact(triangle, {0, 0, 56, 8}); }));
    }
  }
  for (const int count : found) EXPECT_GT(count, 3);
}

TEST(Coverage, CornersOfTheGuardBand) {
  const int limit = (1 << 24) - 129;  // sample offsets move a vertex by up to 128
  const ScreenVertex corners[4] = {
      {-limit, -limit, 0, 1}, {limit, -limit, 0, 1}, {limit, limit, 0, 1}, {-limit, limit, 0, 1}};
  for (int skipped = 0; skipped < 4; ++skipped) {
    ScreenVertex v[3];
    for (int i = 0, j = 0; i < 4; ++i)
      if (i != skipped) v[j++] = corners[i];
    for (ScreenVertex& vertex : v) vertex.depth = 0.5f;
    for (const int at : {0, 8192, 16384 - 16})
      EXPECT_TRUE(holds(1, [&] {
        require_exact(screen_triangle(v[0], v[1], v[2]), {at, at, at + 16, at + 16});
      }));
  }
}

// ------------------------------------------------------------------------------ many triangles

/// How often each pixel is covered, a back face counting -1 if `sign_of_facing`.
std::vector<int> coverage_sum(const std::vector<ScreenTriangle>& triangles, int width, int height,
                              bool sign_of_facing) {
  std::vector<int> sum(std::size_t(width * height));
  for (const ScreenTriangle& t : triangles)
    for_each_span(t, 0, height, [&](int y, int begin, int end) {
      for (int x = std::max(begin, 0); x < std::min(end, width); ++x)
        sum[std::size_t(y * width + x)] += sign_of_facing && t.twice_area < 0 ? -1 : 1;
    });
  return sum;
}

TEST(Coverage, JitteredGridCoversEveryPixelOnceWhereNoTriangleFlips) {
  EXPECT_TRUE(holds(200, [] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    const int cells = *rc::gen::inRange(1, 24), picture = 64;
    const double low = 3.5, cell = 50.0 / cells;
    std::uniform_real_distribution<double> jitter(-0.24 * cell, 0.24 * cell);
    std::vector<ScreenVertex> grid;
    for (int j = 0; j <= cells; ++j)
      for (int i = 0; i <= cells; ++i) {
        const bool border = i == 0 || j == 0 || i == cells || j == cells;
        const double dx = border ? 0 : jitter(random), dy = border ? 0 : jitter(random);
        grid.push_back(at_pixel(low + i * cell + dx, low + j * cell + dy));
      }
    std::vector<ScreenTriangle> triangles;
    for (int j = 0; j < cells; ++j)
      for (int i = 0; i < cells; ++i) {
        const auto at = [&](int di, int dj) {
          return grid[std::size_t((j + dj) * (cells + 1) + i + di)];
        };
        triangles.push_back(screen_triangle(at(0, 0), at(0, 1), at(1, 0)));
        triangles.push_back(screen_triangle(at(1, 1), at(1, 0), at(0, 1)));
      }
    for (const auto& t : triangles) RC_ASSERT(exact_sign(t) == exact_sign(triangles[0]));

    const std::vector<int> sum = coverage_sum(triangles, picture, picture, false);
    const ScreenVertex first = grid.front(), last = grid.back();
    for (int y = 0; y < picture; ++y)
      for (int x = 0; x < picture; ++x) {
        const int px = x * subpixel + half_pixel, py = y * subpixel + half_pixel;
        const bool inside = px >= first.x && px < last.x && py >= first.y && py < last.y;
        RC_ASSERT(sum[std::size_t(y * picture + x)] == int(inside));
      }
  }));
}

/// A sphere of longitude and latitude, its poles single vertices; a cube where both are small.
std::pair<std::vector<glm::dvec3>, std::vector<std::uint32_t>> closed_shape(std::uint32_t around,
                                                                            std::uint32_t rings) {
  std::vector<glm::dvec3> positions = {{0, 0, 1}};
  const double pi = 3.14159265358979;
  for (std::uint32_t r = 1; r <= rings; ++r)
    for (std::uint32_t i = 0; i < around; ++i) {
      const double latitude = pi * r / (rings + 1), longitude = 2 * pi * i / around;
      positions.emplace_back(std::sin(latitude) * std::cos(longitude),
                             std::sin(latitude) * std::sin(longitude), std::cos(latitude));
    }
  positions.emplace_back(0, 0, -1);
  const std::uint32_t south = std::uint32_t(positions.size()) - 1;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t next = (i + 1) % around, last = 1 + (rings - 1) * around;
    indices.insert(indices.end(), {0, 1 + i, 1 + next, south, last + next, last + i});
    for (std::uint32_t r = 0; r + 1 < rings; ++r) {
      const std::uint32_t a = 1 + r * around, b = a + around;
      indices.insert(indices.end(), {a + i, b + i, b + next, a + i, b + next, a + next});
    }
  }
  return {positions, indices};
}

TEST(Coverage, FrontMinusBackOfAClosedMeshIsZeroEverywhere) {
  EXPECT_TRUE(holds(300, [] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    std::normal_distribution<double> normal;
    const auto [positions, indices] =
        closed_shape(*rc::gen::inRange(3u, 40u), *rc::gen::inRange(1u, 20u));
    // Scales from a thousandth, where whole meshes snap to a point, to well beyond the picture.
    const double scale = std::pow(10.0, std::uniform_real_distribution<double>(-3, 3)(random));
    const glm::dvec3 x = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    const glm::dvec3 y =
        glm::normalize(glm::cross(x, glm::dvec3(normal(random), normal(random), normal(random))));
    const glm::dmat3 rotation(x, y, glm::cross(x, y));
    Camera camera = pixel_camera(64, 64);
    camera.height = 100;
    camera.eye.z = 1e4, camera.far = 2e4;
    Draw draw{};
    draw.clip_from_object = glm::mat4(clip_from_world(camera, 1));
    const Viewport viewport{64, 64};

    std::vector<ScreenTriangle> triangles;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      ScreenVertex v[3];
      for (std::size_t k = 0; k < 3; ++k)
        v[k] = project(transform(draw, glm::vec3(rotation * positions[indices[i + k]] * scale +
                                                 glm::dvec3(32.3, -32.1, 0))),
                       viewport);
      triangles.push_back(screen_triangle(v[0], v[1], v[2]));
    }
    for (const int sum : coverage_sum(triangles, 64, 64, true)) RC_ASSERT(sum == 0);
  }));
}

}  // namespace
}  // namespace scanlit
