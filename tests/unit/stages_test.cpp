// The seam of stages.h: with nothing in the table a staged frame is the engine's, and what is put
// there is asked.
#include "rasterizer/stages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>

#include "models/registry.h"
#include "rasterizer/error.h"
#include "rasterizer/shapes.h"

namespace scanlit {
namespace {

constexpr int width = 150, height = 100;
constexpr Planes planes{.depth = true, .normal = true, .ids = true, .parts = true};

/// A teapot, a mirrored torus through it, and a cube, all seen from both sides.
Scene mixed_scene() {
  Scene scene;
  const auto add = [&](const char* shape, const glm::mat4& place, Shading shading) {
    Object& object = scene.objects.emplace_back();
    object.mesh = std::make_shared<const Mesh>(make_shape(shape));
    object.world_from_object = place;
    object.material.model = models::make("blinn-phong:kd=.6/.4/.2,n=20").model;
    object.shading = shading;
    object.sides = Sides::both;
  };
  const glm::mat4 one(1);
  add("teapot:6", one, Shading::phong);
  add("torus:24", glm::scale(one, {-1.5f, 1, 1}), Shading::gouraud);
  add("cube", glm::rotate(glm::translate(one, {1, 0, -2}), 0.7f, {1, 2, 3}), Shading::flat);
  scene.lights.emplace_back().direction = {1, 2, 3};
  scene.lights.emplace_back().kind = LightKind::point;
  scene.lights.back().position = {0, 3, 2};
  scene.background = {0.1, 0.2, 0.3};
  return scene;
}

Camera near_camera() {
  Camera camera;
  camera.eye = {0.9, 1.2, 1.6};
  camera.target = {0.9, 0, 0};  // the left side of the picture, too, cuts through it
  camera.near = 1.5;            // cuts through the teapot
  return camera;
}

struct Drawn {
  Framebuffer framebuffer{width, height, planes};
  FrameStats stats;
};

Drawn draw(const StageFunctions* stages) {
  Drawn drawn;
  RenderSettings settings;
  settings.stages = stages;
  drawn.stats = render(mixed_scene(), near_camera(), settings, drawn.framebuffer);
  return drawn;
}

double greatest_difference(const std::vector<float>& a, const std::vector<float>& b) {
  EXPECT_EQ(a.size(), b.size());
  double greatest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    greatest = std::max(greatest, std::abs(double(a[i]) - double(b[i])));
  return greatest;
}

TEST(Stages, AnEmptyTableDrawsTheEnginesFrame) {
  const StageFunctions engine_own;
  const Drawn own = draw(nullptr), staged = draw(&engine_own);
  EXPECT_EQ(staged.framebuffer.depth, own.framebuffer.depth);
  EXPECT_EQ(staged.framebuffer.object_id, own.framebuffer.object_id);
  EXPECT_EQ(staged.framebuffer.triangle_id, own.framebuffer.triangle_id);
  EXPECT_EQ(staged.stats.covered_pixels, own.stats.covered_pixels);
  EXPECT_EQ(staged.stats.triangles, own.stats.triangles);
  EXPECT_GT(own.stats.clipped, 10);  // or the scene tests less than it should
  const double lighting = staged.stats.seconds[std::size_t(Stage::light_vertices)];
  EXPECT_GT(lighting, 0);
  EXPECT_LT(lighting, staged.stats.wall_seconds);
  // Barycentric coordinates are worked out in double here, in float there.
  for (const auto plane : {&Framebuffer::colour, &Framebuffer::normal, &Framebuffer::ambient,
                           &Framebuffer::diffuse, &Framebuffer::glossy})
    EXPECT_LT(greatest_difference(staged.framebuffer.*plane, own.framebuffer.*plane), 1e-4);
}

TEST(Stages, EachIsAsked) {
  StageFunctions stages;
  // Every other row of each triangle's box, all in front of the other, in one colour.
  stages.spans = [](const ScreenTriangle& t, const Rect& picture, const EmitSpan& emit) {
    for (int y = t.vertices[0].y / subpixel & ~1; y < picture.y_end; y += 2) emit(y, -5, 1 << 20);
  };
  stages.depth = [](const ScreenTriangle&, int, int, std::span<float> depth) {
    std::ranges::fill(depth, 0.25f);
  };
  stages.depth_test = [](std::span<const float>, std::span<const float> there,
                         std::span<std::uint8_t> seen) {
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i] = there[i] == 0;
  };
  stages.barycentric = [](const StagedPiece&, int, int, std::span<float> b1, std::span<float> b2) {
    std::ranges::fill(b1, 0.5f), std::ranges::fill(b2, 0.125f);
  };
  stages.shade = [](const StagedPiece&, std::span<const float> b1, std::span<const float> b2,
                    std::span<Rgb<float>> colour) {
    for (std::size_t i = 0; i < colour.size(); ++i) colour[i] = {b1[i], b2[i], 1};
  };
  const Drawn drawn = draw(&stages);
  const float* const covered = &drawn.framebuffer.colour[4 * std::size_t(width * (height - 2))];
  const float* const left_out = covered + 4 * width;
  EXPECT_EQ(std::vector<float>(covered, covered + 4), (std::vector<float>{0.5f, 0.125f, 1, 1}));
  EXPECT_EQ(left_out[3], 0);
  EXPECT_EQ(drawn.framebuffer.depth[std::size_t(width * (height - 2))], 0.25f);

  stages.clip = [](const ClipVertex(&)[3], const Viewport&, std::vector<ClippedTriangle>&) {};
  EXPECT_EQ(draw(&stages).stats.covered_pixels, 0);
}

TEST(Stages, WantOneSampleAndLinearLight) {
  const StageFunctions stages;
  RenderSettings settings;
  settings.stages = &stages;
  Framebuffer codes(8, 8, {.format = ColourFormat::srgb_8bit});
  EXPECT_THROW(render(Scene(), Camera(), settings, codes), Error);
  settings.samples = 4;
  Framebuffer linear(8, 8);
  EXPECT_THROW(render(Scene(), Camera(), settings, linear), Error);
}

}  // namespace
}  // namespace scanlit
