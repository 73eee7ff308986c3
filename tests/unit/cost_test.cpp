// The plane that says what each pixel cost.
#include <gtest/gtest.h>

#include <numeric>

#include "models/registry.h"
#include "rasterizer/shapes.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

struct Costs {
  Framebuffer framebuffer;
  FrameStats stats;

  float tests(int x, int y) const { return of(x, y)[0]; }
  float evaluations(int x, int y) const { return of(x, y)[1]; }
  double all_tests() const { return sum(0); }
  double all_evaluations() const { return sum(1); }

 private:
  const float* of(int x, int y) const {
    return &framebuffer.cost[2 * std::size_t(y * framebuffer.width + x)];
  }
  double sum(std::size_t channel) const {
    double total = 0;
    for (std::size_t i = channel; i < framebuffer.cost.size(); i += 2) total += framebuffer.cost[i];
    return total;
  }
};

Costs costs_of(const Scene& scene, const Camera& camera, int width, int height,
               const RenderSettings& settings = {}) {
  Costs costs{Framebuffer(width, height, {.cost = true}), {}};
  costs.stats = render(scene, camera, settings, costs.framebuffer);
  return costs;
}

RenderSettings without(bool Skips::*skip) {
  RenderSettings settings;
  settings.skips.*skip = false;
  return settings;
}

/// A rectangle on the screen of pixel_camera, at a depth.
void add_rectangle(std::vector<glm::vec3>& corners, float x0, float y0, float x1, float y1,
                   float z) {
  const glm::vec3 a{x0, y0, z}, b{x0, y1, z}, c{x1, y1, z}, d{x1, y0, z};
  for (const glm::vec3& corner : on_screen({a, b, c, a, c, d})) corners.push_back(corner);
}

/// 32 rectangles of 48 x 48 pixels behind one another, in a picture of 64 x 64.
Scene layers(bool nearest_first) {
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 32; ++i)
    add_rectangle(corners, 8, 8, 56, 56, float(nearest_first ? 32 - i : i + 1) / 64);
  return scene_of({object_of(triangle_soup(corners))});
}

/// Spheres shaded in the three ways under lights from several sides.
Scene lit_spheres(const std::string& model) {
  Scene scene;
  const auto mesh = std::make_shared<Mesh>(make_shape("sphere:24"));
  for (int i = 0; i < 2; ++i) {
    Object& object = scene.objects.emplace_back();
    object.mesh = mesh;
    object.material.model = models::make(model).model;
    object.world_from_object[3] = {0.5f * float(i), 0, -0.5f * float(i), 1};
  }
  scene.lights = {{.direction = {1, 1, -0.5}},
                  {.direction = {-1, 0.2, -1}},
                  {.intensity = 0},
                  {.kind = LightKind::point, .position = {0, 2, 1}, .constant = 0, .quadratic = 1}};
  return scene;
}

TEST(Cost, IsNotCountedUnlessAskedFor) {
  Framebuffer framebuffer(64, 64);
  render(layers(true), pixel_camera(64, 64), {}, framebuffer);
  EXPECT_TRUE(framebuffer.cost.empty());
  EXPECT_EQ(costs_of(layers(true), pixel_camera(64, 64), 64, 64).framebuffer.colour,
            framebuffer.colour);
}

TEST(Cost, CountsADepthTestForEachFragmentAtEachSample) {
  std::vector<glm::vec3> corners;
  add_rectangle(corners, 8, 8, 40, 40, 0.25f);
  add_rectangle(corners, 24, 24, 56, 56, 0.5f);
  add_rectangle(corners, 1, 1, 5, 5, 0.5f);  // small enough for scan conversion by edge functions
  const Scene scene = scene_of({object_of(triangle_soup(corners))});
  for (const int samples : {1, 4, 16}) {
    const Costs costs = costs_of(scene, pixel_camera(64, 64), 64, 64, with_samples(samples));
    EXPECT_EQ(costs.tests(0, 0), 0);
    EXPECT_EQ(costs.tests(3, 2), samples);
    EXPECT_EQ(costs.tests(10, 20), samples);
    EXPECT_EQ(costs.tests(30, 30), 2 * samples);
    EXPECT_EQ(costs.tests(50, 50), samples);
    EXPECT_EQ(costs.all_tests(), samples * (2.0 * 32 * 32 + 16));
  }
}

TEST(Cost, CountsTheTestsOfSlopedEdgesAtTheSamplesTheyCover) {
  // A large triangle and a small one, nothing behind them: what is covered is what is tested.
  for (const float size : {50.0f, 7.0f}) {
    const auto corners = on_screen({{3, 4, 0.5f}, {3.3f, 4 + size, 0.5f}, {3 + size, 7.7f, 0.5f}});
    const Scene scene = scene_of({object_of(triangle_soup(corners))});
    for (const int samples : {4, 16}) {
      const Costs costs = costs_of(scene, pixel_camera(64, 64), 64, 64, with_samples(samples));
      for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
          const float alpha = costs.framebuffer.colour[4 * std::size_t(y * 64 + x) + 3];
          ASSERT_EQ(costs.tests(x, y), alpha * float(samples)) << x << ", " << y;
        }
    }
  }
}

TEST(Cost, ShowsWhatTheCoarseDepthSaves) {
  const Costs with = costs_of(layers(true), pixel_camera(64, 64), 64, 64);
  const Costs all =
      costs_of(layers(true), pixel_camera(64, 64), 64, 64, without(&Skips::hidden_triangles));
  for (int y = 8; y < 56; ++y)
    for (int x = 8; x < 56; ++x) ASSERT_EQ(all.tests(x, y), 32);
  EXPECT_LT(with.all_tests(), all.all_tests() / 8);
  EXPECT_GE(with.all_tests(), 48 * 48);
  EXPECT_EQ(with.framebuffer.colour, all.framebuffer.colour);
}

TEST(Cost, CountsTheEvaluationsThatTheStatsCount) {
  // A formula, and a model that is lit by the default loop.
  for (const char* model : {"blinn-phong", "sum:(lambert),(cook-torrance)"})
    for (const bool skip : {true, false})
      for (const int samples : {1, 4}) {
        RenderSettings settings = with_samples(samples);
        settings.skips.dark_lights = skip;
        const Costs costs = costs_of(lit_spheres(model), {.eye = {0, 0, 6}}, 96, 64, settings);
        EXPECT_GT(costs.all_evaluations(), 0);
        EXPECT_EQ(costs.all_evaluations(),
                  double(costs.stats.evaluations - costs.stats.evaluations_skipped));
        if (skip) continue;
        EXPECT_EQ(costs.all_evaluations(), 4.0 * double(costs.stats.fragments));
      }
}

TEST(Cost, OfHiddenFragmentsIsCountedWhereTheyAreShaded) {
  RenderSettings settings = without(&Skips::hidden_fragments);
  settings.skips.hidden_triangles = false;
  const Costs costs = costs_of(layers(false), pixel_camera(64, 64), 64, 64, settings);
  EXPECT_EQ(costs.evaluations(30, 30), 32 + 1);  // each once, then what stays
  EXPECT_EQ(costs.all_evaluations(), double(costs.stats.evaluations));
}

TEST(Cost, OfGouraudShadingIsNotThePixels) {
  Scene scene = lit_spheres("blinn-phong");
  for (Object& object : scene.objects) object.shading = Shading::gouraud;
  EXPECT_EQ(costs_of(scene, {.eye = {0, 0, 6}}, 96, 64).all_evaluations(), 0);
}

TEST(Cost, DoesNotDependOnThreads) {
  RenderSettings settings = with_samples(4);
  settings.threads = 1;
  const Scene scene = lit_spheres("blinn-phong");
  const Costs one = costs_of(scene, {.eye = {0, 0, 6}}, 200, 150, settings);
  settings.threads = 4;
  EXPECT_EQ(one.framebuffer.cost,
            costs_of(scene, {.eye = {0, 0, 6}}, 200, 150, settings).framebuffer.cost);
}

}  // namespace
}  // namespace scanlit
