// (7) Depth: the plane of the snapped triangle, to float's precision; larger is nearer; of equal
// depths the first drawn stays.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "rasterizer/scan_conversion.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

/// The depth of a triangle's plane at a point in 1/256 pixel; exact but for the last roundings.
double plane_depth(const ScreenTriangle& t, Exact px, Exact py) {
  const auto& v = t.vertices;
  const Exact weights[3] = {exact_edge(v[1], v[2], px, py), exact_edge(v[2], v[0], px, py),
                            exact_edge(v[0], v[1], px, py)};
  const Exact area = weights[0] + weights[1] + weights[2];
  long double sum = 0;
  for (int i = 0; i < 3; ++i) sum += static_cast<long double>(weights[i]) * v[i].depth;
  return double(sum / static_cast<long double>(area));
}

float largest_depth(const ScreenTriangle& t) {
  return std::max({t.vertices[0].depth, t.vertices[1].depth, t.vertices[2].depth});
}
float smallest_depth(const ScreenTriangle& t) {
  return std::min({t.vertices[0].depth, t.vertices[1].depth, t.vertices[2].depth});
}

TEST(Depth, IsThePlaneOfTheSnappedTriangle) {
  EXPECT_TRUE(holds(3000, [] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    // Small boxes, spans, and triangles that reach to the guard band.
    const int reach = *rc::gen::element(4, 15, 64, 1000, 40000);
    std::uniform_int_distribution<int> position(-reach * subpixel, reach * subpixel);
    std::uniform_real_distribution<float> exponent(-20, 0);
    ScreenVertex v[3];
    for (ScreenVertex& vertex : v)
      vertex = {position(random) + 8 * subpixel, position(random) + 8 * subpixel,
                std::exp2(exponent(random)), 1};
    const ScreenTriangle t = screen_triangle(v[0], v[1], v[2]);
    for (const ScreenVertex& vertex : v)
      RC_LOG() << vertex.x << ' ' << vertex.y << ' ' << vertex.depth << '\n';

    for (const int samples : {1, 16}) {
      const Rect rect{0, 0, 32, 16};
      const VisibilityTile tile = scan({t}, rect, samples);
      for (int s = 0; s < samples; ++s)
        for (int y = 0; y < rect.y_end; ++y)
          for (int x = 0; x < rect.x_end; ++x) {
            if (seen(tile, x, y, s) < 0) continue;
            const SampleOffset offset = sample_offsets(samples)[std::size_t(s)];
            const double expected = plane_depth(t, x * subpixel + half_pixel + offset.x,
                                                y * subpixel + half_pixel + offset.y);
            const float depth = depth_of(tile, x, y, s);
            // Four roundings to float (the row's first pixel, the step, product, sum), half a unit
            // in the last place of the largest depth each.
            RC_ASSERT(std::abs(depth - expected) <= 4 * 6e-8 * largest_depth(t));
            RC_ASSERT(depth >= smallest_depth(t) && depth <= largest_depth(t));
          }
    }
  }));
}

TEST(Depth, DoesNotDependOnWhereTilesEnd) {
  EXPECT_TRUE(holds(500, [] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    const int reach = *rc::gen::element(6, 15, 40, 3000);
    std::uniform_int_distribution<int> position(-reach * subpixel, reach * subpixel);
    std::uniform_real_distribution<float> depth(0, 1);
    std::vector<ScreenTriangle> triangles;
    for (int i = 0; i < 3; ++i) {
      ScreenVertex v[3];
      for (ScreenVertex& vertex : v)
        vertex = {position(random) + 20 * subpixel, position(random) + 20 * subpixel, depth(random),
                  1};
      triangles.push_back(screen_triangle(v[0], v[1], v[2]));
    }
    const VisibilityTile whole = scan(triangles, {0, 0, 48, 40});
    const int cut_x = std::uniform_int_distribution<int>(1, 47)(random);
    const int cut_y = std::uniform_int_distribution<int>(1, 39)(random);
    for (const Rect& r : {Rect{0, 0, cut_x, cut_y}, Rect{cut_x, 0, 48, cut_y},
                          Rect{0, cut_y, cut_x, 40}, Rect{cut_x, cut_y, 48, 40}}) {
      const VisibilityTile part = scan(triangles, r);
      for (int y = r.y_begin; y < r.y_end; ++y)
        for (int x = r.x_begin; x < r.x_end; ++x) {
          RC_ASSERT(seen(part, x, y) == seen(whole, x, y));
          RC_ASSERT(depth_of(part, x, y) == depth_of(whole, x, y));
        }
    }
  }));
}

TEST(Depth, LargerIsNearerWhateverTheOrder) {
  const auto at_depth = [](float depth) {
    return screen_triangle(at_pixel(0, 0, depth), at_pixel(0, 60, depth), at_pixel(60, 0, depth));
  };
  EXPECT_EQ(seen(scan({at_depth(0.25f), at_depth(0.75f)}, {0, 0, 32, 16}), 5, 5), 1);
  EXPECT_EQ(seen(scan({at_depth(0.75f), at_depth(0.25f)}, {0, 0, 32, 16}), 5, 5), 0);
}

TEST(Depth, OfEqualDepthsTheFirstDrawnStays) {
  for (const float extent : {7.0f, 60.0f}) {
    const auto corners = on_screen({{0, 0, 0.5f}, {0, extent, 0.5f}, {extent, 0, 0.5f}});
    std::vector<glm::vec3> twice = corners;
    twice.insert(twice.end(), corners.begin(), corners.end());
    const Scene scene =
        scene_of({object_of(triangle_soup(twice)), object_of(triangle_soup(corners))});
    for (const int samples : {1, 4, 8, 16}) {
      const Picture picture =
          picture_of(scene, pixel_camera(64, 64), 64, 64, with_samples(samples));
      for (std::size_t i = 0; i < picture.framebuffer.pixel_count(); ++i) {
        if (picture.framebuffer.object_id[i] == no_id) continue;
        EXPECT_EQ(picture.framebuffer.object_id[i], 0u);
        EXPECT_EQ(picture.framebuffer.triangle_id[i], 0u);
      }
      EXPECT_EQ(picture.triangle(1, 1), 0u);
    }
  }
}

/// Squares that face a perspective camera at `distances`, each covering the whole picture, drawn in
/// the order given. Returns the index of the one that is seen.
std::uint32_t nearest_of(const std::vector<double>& distances, double near, float& depth) {
  std::vector<glm::vec3> corners;
  for (const double d : distances) {
    const float r = float(4 * d), z = float(-d);
    for (const auto& [x, y] : {std::pair(-r, -r), {r, -r}, {r, r}, {-r, -r}, {r, r}, {-r, r}})
      corners.emplace_back(x, y, z);
  }
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.target = {0, 0, -1};
  camera.near = near;
  const Picture picture = picture_of(scene_of({object_of(triangle_soup(corners))}), camera, 4, 4);
  depth = picture.framebuffer.depth[5];
  return picture.framebuffer.triangle_id[5] / 2;
}

TEST(Depth, FarDistancesKeepTheirOrder) {
  // From a metre to a thousand kilometres, a thousandth of a per cent apart: 168 float steps.
  for (double d = 1; d <= 1e6; d *= 3.7) {
    float depth = 0;
    EXPECT_EQ(nearest_of({d * 1.00001, d}, 0.01, depth), 1u) << d;
    EXPECT_NEAR(depth, 0.01 / d, 3e-7 * 0.01 / d);
    EXPECT_EQ(nearest_of({d, d * 1.00001}, 0.01, depth), 0u) << d;
  }
}

TEST(Depth, OneAtTheNearPlane) {
  float depth = 0;
  EXPECT_EQ(nearest_of({1}, 1, depth), 0u);
  EXPECT_EQ(depth, 1.0f);
}

TEST(Depth, PlaneHoldsZeroWhereNothingIsCovered) {
  const Picture picture = picture_of(scene_of({}), Camera(), 3, 2);
  for (const float depth : picture.framebuffer.depth) EXPECT_EQ(depth, 0.0f);
  EXPECT_EQ(picture.stats.covered_pixels, 0);
}

TEST(Depth, OrthographicIsLinearInDistance) {
  const auto corners = on_screen({{0, 0, 0.25f}, {0, 64, 0.25f}, {64, 0, 0.75f}});
  const Picture picture =
      picture_of(scene_of({object_of(triangle_soup(corners))}), pixel_camera(32, 32), 32, 32);
  for (int x = 0; x < 32; ++x)
    EXPECT_NEAR(picture.framebuffer.depth[picture.index(x, 3)], 0.25 + 0.5 * (x + 0.5) / 64, 1e-7);
}

}  // namespace
}  // namespace scanlit
