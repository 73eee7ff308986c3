// Whatever is skipped, the picture is the same to the bit: random scenes with each switch off, and
// with all of them off.
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "models/blinn_phong.h"
#include "models/registry.h"
#include "rasterizer/shapes.h"
#include "tests/unit/same_picture.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

constexpr int width = 130, height = 100;
const Planes planes{.depth = true, .normal = true, .ids = true};

class RandomScene {
 public:
  explicit RandomScene(std::uint64_t seed) : random_(seed) {
    static const char* const shapes[] = {"sphere:6", "sphere:40", "torus:30",
                                         "teapot:3", "cube",      "plane"};
    const int count = integer(1, 12);
    for (int i = 0; i < count; ++i) {
      const auto shading = Shading(integer(0, 2));
      auto mesh = std::make_shared<Mesh>(make_shape(shapes[integer(0, 5)]));
      Object object = object_of(mesh, models::BlinnPhong<>(), shading);
      if (integer(0, 1)) object.material.model = models::make("cook-torrance").model;
      glm::mat4 m = glm::translate(glm::mat4(1), {real(-3, 3), real(-2, 2), real(-6, 2)});
      m = glm::rotate(m, real(0, 6), {real(-1, 1), real(-1, 1), 1.0f});
      // Mirrored, too, and as small as pixels.
      const float size = std::pow(10.0f, real(-2, 0.3f));
      object.world_from_object = glm::scale(m, {size * real(-1, 1), size, size});
      object.sides = Sides(integer(0, 2));
      scene.objects.push_back(object);
    }
    if (integer(0, 2) == 0) scene.objects.push_back(scene.objects[0]);  // at equal depth
    for (int i = integer(0, 4); i > 0; --i)
      scene.lights.push_back({.kind = LightKind(integer(0, 2)),
                              .intensity = real(0, 2),
                              .direction = {real(-1, 1), real(-1, 1), real(-1, 1)},
                              .position = {real(-3, 3), real(-3, 3), real(-3, 3)}});
    camera.eye = {real(-2, 2), real(-2, 2), real(0.5f, 6)};
    camera.projection = integer(0, 3) ? Projection::perspective : Projection::orthographic;
    camera.viewer_at_infinity = integer(0, 2) == 0;
    camera.near = integer(0, 1) ? 0.01 : 1.5;
    camera.far = integer(0, 1) ? 100 : 7;
    settings.samples = integer(0, 2) ? 1 : 4 << integer(0, 2);
    settings.threads = integer(1, 2);
  }

  Framebuffer draw(const Skips& skips) {
    settings.skips = skips;
    Framebuffer picture(width, height, planes);
    stats = render(scene, camera, settings, picture);
    return picture;
  }

  Scene scene;
  Camera camera;
  RenderSettings settings;
  FrameStats stats;

 private:
  int integer(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  float real(float low, float high) { return std::uniform_real_distribution(low, high)(random_); }

  std::mt19937_64 random_;
};

TEST(Skips, LeaveThePictureTheSameToTheBit) {
  std::int64_t hidden = 0, outside = 0, facing_away = 0, dark = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    RandomScene scene(seed);
    const Framebuffer all = scene.draw({});
    hidden += scene.stats.hidden, outside += scene.stats.clusters_outside;
    facing_away += scene.stats.clusters_back_facing, dark += scene.stats.evaluations_skipped;
    Skips none;
    for (const SkipSwitch& skip : skip_switches()) {
      SCOPED_TRACE(skip.name);
      Skips one_off;
      one_off.*skip.member = none.*skip.member = false;
      EXPECT_EQ(planes_that_differ(scene.draw(one_off), all), "");
    }
    EXPECT_EQ(planes_that_differ(scene.draw(none), all), "");
  }
  // The scenes give each of them something to do.
  EXPECT_GT(hidden, 100);
  EXPECT_GT(outside, 100);
  EXPECT_GT(facing_away, 100);
  EXPECT_GT(dark, 10000);
}

/// Layers over layers, one mesh in any order: what the coarse depth is for.
TEST(Skips, HiddenLayersLeaveNoTrace) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<float> real(-1, 1);
  for (const int samples : {1, 4, 8, 16}) {
    std::vector<glm::vec3> positions;
    for (int i = 0; i < 3000; ++i) {
      const glm::vec3 centre(90 * real(random), 70 * real(random), -1.2f - real(random));
      const float size = 40 * std::abs(real(random));
      for (int k = 0; k < 3; ++k)
        positions.push_back(
            centre + glm::vec3(size * real(random), size * real(random), 0.2f * real(random)));
    }
    for (glm::vec3& p : positions) p.x /= 30, p.y /= 30, p.z *= 2;
    Scene scene = scene_of({object_of(triangle_soup(positions), models::BlinnPhong<>())});
    RenderSettings settings{.samples = samples};
    Framebuffer with(width, height, planes), without(width, height, planes);
    const FrameStats stats = render(scene, eye_at_origin(), settings, with);
    settings.skips.hidden_triangles = false;
    render(scene, eye_at_origin(), settings, without);
    EXPECT_EQ(planes_that_differ(with, without), "");
    EXPECT_GT(stats.hidden, 500) << samples;
  }
}

/// A room: walls of two triangles each, with spheres before and behind them, and across their
/// edges.
TEST(Skips, WhatIsBehindWallsLeavesNoTrace) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<float> real(-1, 1);
  const auto sphere = std::make_shared<Mesh>(make_shape("sphere:24"));
  const auto wall = std::make_shared<Mesh>(make_shape("plane"));
  std::int64_t objects_hidden = 0, clusters_hidden = 0;
  for (int round = 0; round < 12; ++round) {
    SCOPED_TRACE(round);
    const auto place = [&](const std::shared_ptr<Mesh>& mesh, float size, float z) {
      Object object = object_of(mesh, models::BlinnPhong<>());
      object.sides = Sides::both;
      const glm::mat4 m = glm::translate(glm::mat4(1), {4 * real(random), 3 * real(random), z});
      object.world_from_object = glm::scale(
          glm::rotate(m, 3 * real(random), {real(random), real(random), 0.1f}), glm::vec3(size));
      return object;
    };
    Scene scene = scene_of({});
    for (int i = 0; i < 3; ++i) scene.objects.push_back(place(wall, 4, -5 + real(random)));
    for (int i = 0; i < 24; ++i)
      scene.objects.push_back(place(sphere, 0.7f + 0.5f * real(random), -6 + 4 * real(random)));
    RenderSettings settings{.samples = round % 3 == 2 ? 4 : 1};
    Framebuffer with(width, height, planes), without(width, height, planes);
    const FrameStats stats = render(scene, eye_at_origin(), settings, with);
    settings.skips.hidden_clusters = false;
    const FrameStats all = render(scene, eye_at_origin(), settings, without);
    EXPECT_EQ(planes_that_differ(with, without), "");
    objects_hidden += stats.objects_hidden, clusters_hidden += stats.clusters_hidden;
    EXPECT_EQ(stats.triangles, all.triangles);
    EXPECT_EQ(stats.triangles,
              stats.outside + stats.behind + stats.back_facing + stats.no_pixel + stats.drawn);
    EXPECT_EQ(all.behind + all.objects_hidden + all.clusters_hidden, 0);
  }
  EXPECT_GT(objects_hidden, 10);
  EXPECT_GT(clusters_hidden, 200);
}

/// Tilted squares, each nearer than the last by a few of float's steps: a bound that is too small
/// by less than that would hide some of the next one.
TEST(Skips, LayersThatNearlyTouchAreAllSeen) {
  const int size = 128;
  for (const int samples : {1, 4, 16})
    for (const double slope : {0.0, 1e-4, 2e-3, -2e-3}) {
      std::vector<glm::vec3> corners;
      for (int layer = 0; layer < 8; ++layer) {
        const double nearer = layer * 4e-7;
        const auto at = [&](double x, double y) {
          return glm::vec3(x, y, 0.4 + nearer + slope * (x - 0.4 * y - 40));
        };
        // In strips, so that blocks are covered by several triangles.
        for (double y = 0; y < size; y += 13)
          for (const glm::vec3& corner : on_screen({at(0, y), at(size, y), at(size, y + 13),
                                                    at(0, y), at(size, y + 13), at(0, y + 13)}))
            corners.push_back(corner);
      }
      const Scene scene = scene_of({object_of(triangle_soup(corners))});
      RenderSettings settings{.samples = samples};
      Framebuffer with(size, size, planes), without(size, size, planes);
      render(scene, pixel_camera(size, size), settings, with);
      settings.skips.hidden_triangles = false;
      render(scene, pixel_camera(size, size), settings, without);
      SCOPED_TRACE(std::to_string(samples) + " samples, slope " + std::to_string(slope));
      EXPECT_EQ(planes_that_differ(with, without), "");
    }
}

/// A square behind another by one of float's steps and less. Its rows of fragments, rounded where
/// they begin, come out as near as the other's, and it is the first of the two that are drawn: so
/// it is seen there, though its plane lies behind, and the bound needs its margin.
TEST(Skips, FragmentsThatRoundingBringsNearerAreSeen) {
  const int size = 128;
  const float d = 0.4f, nearer = std::nextafter(d, 1.0f), farther = std::nextafter(d, 0.0f),
              farthest = std::nextafter(farther, 0.0f);
  const auto square = [](float a, float b, float c, float e) {
    return object_of(triangle_soup(on_screen(
        {{0, 0, a}, {size, 0, b}, {size, size, e}, {0, 0, a}, {size, size, e}, {0, size, c}})));
  };
  // Several layers more, without which there is no coarse depth.
  const Object behind = square(0.1f, 0.1f, 0.1f, 0.1f);
  const Scene scene = scene_of({square(farthest, farther, farther, d), square(nearer, d, nearer, d),
                                behind, behind, behind});
  for (const int samples : {1, 4, 16}) {
    RenderSettings settings{.samples = samples};
    Framebuffer with(size, size, planes), without(size, size, planes);
    render(scene, pixel_camera(size, size), settings, with);
    settings.skips.hidden_triangles = false;
    render(scene, pixel_camera(size, size), settings, without);
    EXPECT_EQ(planes_that_differ(with, without), "");
    EXPECT_EQ(with.object_id[88 + 120 * size], 0u);
  }
}

/// Layers, and through all of them a triangle that begins behind the last and ends before the
/// first.
TEST(Skips, ATriangleThroughAllLayersIsSeenWhereItIsNearest) {
  const int size = 64;
  const auto mesh_of = [](const std::vector<glm::vec3>& corners) {
    return triangle_soup(on_screen(corners));
  };
  std::vector<Object> objects;
  for (int layer = 0; layer < 8; ++layer) {
    const float z = 0.4f + 0.01f * float(layer);
    objects.push_back(object_of(mesh_of({{0, 0, z}, {0, 128, z}, {128, 0, z}})));
  }
  objects.push_back(object_of(mesh_of({{0, 0, 0.1f}, {0, size, 0.1f}, {size, 0, 0.9f}})));
  const Picture picture = picture_of(scene_of(objects), pixel_camera(size, size), size, size);
  EXPECT_GT(picture.stats.hidden, 0);
  EXPECT_EQ(picture.framebuffer.object_id[picture.index(2, 2)], 7u);
  EXPECT_EQ(picture.framebuffer.object_id[picture.index(size - 4, 1)], 8u);
}

}  // namespace
}  // namespace scanlit
