// (3) to (10) Triangles cut by the near plane, the far plane or the guard band, in the picture:
// they cover what rays through the pixels hit, never bring a NaN, and are counted once.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "models/blinn_phong.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

using Real = long double;

/// The ray (x, y, -1) from the eye meets the triangle between near and far.
bool hit(const std::vector<glm::vec3>& p, Real x, Real y, double near, double far) {
  const Real ray[3] = {x, y, -1};
  const auto determinant = [](const auto& a, const auto& b, const auto& c) {
    return a[0] * (Real(b[1]) * c[2] - Real(b[2]) * c[1]) -
           a[1] * (Real(b[0]) * c[2] - Real(b[2]) * c[0]) +
           a[2] * (Real(b[0]) * c[1] - Real(b[1]) * c[0]);
  };
  const Real volume = determinant(p[0], p[1], p[2]);
  if (volume == 0) return false;  // seen edge-on
  const Real b[3] = {determinant(ray, p[1], p[2]) / volume, determinant(p[0], ray, p[2]) / volume,
                     determinant(p[0], p[1], ray) / volume};
  const Real inverse_distance = b[0] + b[1] + b[2];
  return b[0] >= 0 && b[1] >= 0 && b[2] >= 0 && inverse_distance <= 1 / Real(near) &&
         inverse_distance >= 1 / Real(far) && inverse_distance > 0;
}

/// How many of 3 x 3 rays around a pixel's centre hit. Snapping, and float's last place at the far
/// end of the guard band, move an edge by less than 1/64 pixel.
int hits(const std::vector<glm::vec3>& p, int x, int y, int size, double near, double far) {
  int count = 0;
  for (int i = 0; i < 9; ++i) {
    const Real sx = x + 0.5L + (i % 3 - 1) / 64.0L, sy = y + 0.5L + (i / 3 - 1) / 64.0L;
    count += hit(p, sx * 2 / size - 1, 1 - sy * 2 / size, near, far);
  }
  return count;
}

TEST(ClippedPicture, CoversWhatRaysHitAndInterpolatesAcrossPieces) {
  constexpr int size = 24;
  int covered = 0, clipped = 0;
  EXPECT_TRUE(holds(1500, [&] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    std::vector<glm::vec3> p;
    for (int i = 0; i < 3; ++i) p.push_back(delicate_position(random, {size, size}, 0.1f));
    for (const glm::vec3& v : p) RC_LOG() << v.x << ' ' << v.y << ' ' << v.z << '\n';
    const double far = *rc::gen::element(infinity, 4.0);
    Scene scene = scene_of({object_of(triangle_soup(p), ShowPoint())});
    scene.lights.push_back(scene.lights[0]);  // whichever way the normal was flipped
    scene.lights[1].direction = {0, 0, -1};
    const Picture picture = picture_of(scene, eye_at_origin(0.1, far), size, size);
    clipped += int(picture.stats.clipped);
    const float reach = std::max({glm::length(p[0]), glm::length(p[1]), glm::length(p[2])});
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const int nine = hits(p, x, y, size, double(0.1f), far);
        const bool drawn = picture.triangle(x, y) != no_id;
        if (nine == 9) RC_ASSERT(drawn);
        if (nine == 0) RC_ASSERT(!drawn);
        if (nine != 9) continue;
        ++covered;
        // The point that was shaded lies on the pixel's ray, but for what snapping moved.
        const float* point = &picture.framebuffer.diffuse[3 * picture.index(x, y)];
        const double sx = (1 - point[0] / point[2]) * size / 2;
        const double sy = (1 + point[1] / point[2]) * size / 2;
        // A position's float rounding, seen from its distance.
        const double rounding = 1e-6 * double(reach / -point[2]) * size;
        RC_ASSERT(std::abs(sx - x - 0.5) < 1.0 / 32 + rounding);
        RC_ASSERT(std::abs(sy - y - 0.5) < 1.0 / 32 + rounding);
      }
  }));
  EXPECT_GT(covered, 10000);
  EXPECT_GT(clipped, 300);
}

// ------------------------------------------------------------------------------------ never a NaN

void expect_finite(const Framebuffer& framebuffer) {
  for (const auto* plane : {&framebuffer.colour, &framebuffer.depth, &framebuffer.normal,
                            &framebuffer.ambient, &framebuffer.diffuse, &framebuffer.glossy})
    EXPECT_TRUE(std::ranges::all_of(*plane, [](float v) { return std::isfinite(v); }));
}

Object shiny(std::shared_ptr<const Mesh> mesh, Shading shading) {
  Object object = object_of(std::move(mesh), White(), shading);
  object.material.model =
      std::make_shared<FormulaModel<models::BlinnPhong<>>>(models::BlinnPhong<>());
  return object;
}

Scene lit_every_way(std::vector<Object> objects) {
  Scene scene = scene_of(std::move(objects));
  for (const LightKind kind : {LightKind::point, LightKind::spot}) {
    Light& light = scene.lights.emplace_back();
    light.kind = kind;
    light.constant = 0, light.quadratic = 1;
    light.direction = {0, 0, -1};
  }
  return scene;
}

TEST(ClippedPicture, OverflowingTransformsNeverPutNanInThePicture) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<float> exponent(-44, 38), unit(-1, 1);
  for (int i = 0; i < 400; ++i) {
    std::vector<glm::vec3> positions;
    const float size = std::pow(10.0f, exponent(random));
    for (int k = 0; k < 30; ++k)
      positions.push_back(glm::vec3(unit(random), unit(random), unit(random)) * size);
    std::vector<Object> objects;
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
      objects.push_back(shiny(triangle_soup(positions), shading));
      glm::mat4& m = objects.back().world_from_object;
      for (int c = 0; c < 3; ++c) m[c][c] = std::pow(10.0f, exponent(random)) * unit(random);
      // Often so that the object comes out at about the size of the scene.
      if (i % 2) m = glm::scale(glm::mat4(1), glm::vec3(std::clamp(2 / size, 2e-38f, 1e38f)));
      m[3] = {unit(random), unit(random), -3, 1};
    }
    const Scene scene = lit_every_way(objects);
    expect_finite(picture_of(scene, eye_at_origin(), 16, 16, with_samples(4)).framebuffer);
    if (testing::Test::HasFailure()) FAIL() << "case " << i << ", size " << size;
  }
}

TEST(ClippedPicture, PositionsAtTheEndOfFloatGiveNoNan) {
  const float end = std::numeric_limits<float>::max();
  for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
    // Differences of two of them overflow.
    Object object = shiny(triangle_soup({{-end, -end, 0}, {end, -end, 0}, {end, end, 0}}), shading);
    object.world_from_object = glm::scale(glm::mat4(1), glm::vec3(2e-38f));
    object.world_from_object[3][2] = -3;
    const Picture picture = picture_of(lit_every_way({object}), eye_at_origin(), 16, 16);
    EXPECT_GT(picture.stats.covered_pixels, 50);
    expect_finite(picture.framebuffer);
  }
}

TEST(ClippedPicture, VerticesAtTheEyeAndLightsOnTheSurfaceGiveNoNan) {
  for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
    const auto mesh = triangle_soup({{0, 0, 0},
                                     {1, 0, -2},
                                     {0, 1, -2},  // begins at the eye
                                     {-1, -1, 0},
                                     {1, -1, 0},
                                     {0, 1, 0},  // in the eye's plane
                                     {-1, -1, 5},
                                     {1, -1, -5},
                                     {0, 1, -5},  // through it
                                     {0, 0, 0},
                                     {0, 0, 0},
                                     {0, 0, 0}});
    const Scene scene = lit_every_way({shiny(mesh, shading)});
    const Picture picture = picture_of(scene, eye_at_origin(), 32, 32, with_samples(8));
    expect_finite(picture.framebuffer);
    EXPECT_GT(picture.stats.covered_pixels, 100);
    EXPECT_EQ(picture.stats.clipped, 1);
  }
}

TEST(ClippedPicture, BeyondTheRangeOfCoordinatesNothingIsDrawn) {
  for (const float far : {0.9e18f, 1.1e18f, 1e30f}) {
    const auto mesh = triangle_soup({{-1, -1, -2}, {1, -1, -2}, {0, far, -2}});
    const Picture picture = picture_of(scene_of({object_of(mesh)}), eye_at_origin(), 16, 16);
    EXPECT_EQ(picture.stats.outside, far > 1e18f) << far;
    EXPECT_EQ(picture.stats.covered_pixels > 0, far < 1e18f) << far;
  }
}

// ----------------------------------------------------------------------------------------- counts

TEST(ClippedPicture, EveryTriangleIsCountedOnce) {
  EXPECT_TRUE(holds(300, [] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    std::vector<glm::vec3> p;
    for (int i = 0; i < 300; ++i) p.push_back(delicate_position(random, {64, 64}, 0.1f));
    Object object = object_of(triangle_soup(p));
    object.sides = *rc::gen::element(Sides::front, Sides::both);
    const Picture picture = picture_of(scene_of({object}), eye_at_origin(), 64, 64,
                                       with_samples(*rc::gen::element(1, 16)));
    const FrameStats& s = picture.stats;
    RC_ASSERT(s.triangles == 100);
    RC_ASSERT(s.outside + s.back_facing + s.no_pixel + s.drawn == s.triangles);
    RC_ASSERT(s.clipped <= s.drawn);
    RC_ASSERT(object.sides == Sides::front || s.back_facing == 0);
  }));
}

}  // namespace
}  // namespace scanlit
