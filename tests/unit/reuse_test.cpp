// A frame that takes over what stands from the last one is the same to the bit as one drawn anew.
#include "rasterizer/reuse.h"

#include <glm/gtc/matrix_transform.hpp>

#include "models/blinn_phong.h"
#include "rasterizer/shapes.h"
#include "tests/unit/same_picture.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

constexpr int width = 150, height = 120;  // several tiles, none of them whole

Scene three_objects() {
  Scene scene;
  const Shading shadings[] = {Shading::phong, Shading::gouraud, Shading::flat};
  for (int i = 0; i < 3; ++i) {
    Object object = object_of(std::make_shared<Mesh>(make_shape(i == 1 ? "torus:24" : "sphere:20")),
                              models::BlinnPhong<>(), shadings[i]);
    object.world_from_object = glm::translate(glm::mat4(1), {i - 1.0f, 0.2f * float(i), -float(i)});
    scene.objects.push_back(object);
  }
  scene.lights = {{.direction = {1, 1, 1}},
                  {.kind = LightKind::point, .intensity = 3, .position = {0, 2, 3}}};
  return scene;
}

/// A sequence of frames by one Renderer, each compared with a frame of its own.
struct Sequence {
  Scene scene = three_objects();
  Camera camera{.eye = {0, 0, 5}};
  RenderSettings settings{.reuse = true};
  Planes planes{.depth = true, .normal = true, .ids = true, .parts = true};
  Renderer renderer;
  Framebuffer picture{width, height, planes};

  FrameStats next(const char* what) {
    const FrameStats stats = renderer.render(scene, camera, settings, picture);
    Framebuffer anew(width, height, planes);
    RenderSettings without = settings;
    without.reuse = false;
    render(scene, camera, without, anew);
    EXPECT_EQ(planes_that_differ(picture, anew), "") << what;
    return stats;
  }
};

class Reuse : public testing::TestWithParam<int> {
 protected:
  Sequence sequence;
  void SetUp() override { sequence.settings.samples = GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(Samples, Reuse, testing::Values(1, 4));

TEST_P(Reuse, WhateverChangesFromFrameToFrameThePictureIsTheSame) {
  Sequence& s = sequence;
  s.next("first");
  s.scene.lights[0].direction = {-1, 0.5, 1};
  s.next("light turned");
  s.scene.lights[1].intensity = 1;
  s.next("light dimmed");
  s.scene.lights.pop_back();
  s.next("light gone");
  s.scene.ambient = Rgb<double>(0.2);
  s.next("ambient");
  s.scene.background = {0.1, 0.2, 0.3};
  s.next("background");
  s.scene.objects[0].world_from_object = glm::translate(glm::mat4(1), {0.3f, 0, 1});
  s.next("object moved before the others");
  s.scene.objects[0].world_from_object = glm::translate(glm::mat4(1), {40, 0, 1});
  s.next("object out of the view");
  s.scene.objects[0].world_from_object = glm::translate(glm::mat4(1), {-1, 0.5f, -3});
  s.next("and back");
  s.scene.objects[1].material.ka = Rgb<double>(0.5);
  s.next("material");
  s.scene.objects[1].shading = Shading::phong;
  s.next("shading");
  s.scene.objects[2].mesh = std::make_shared<Mesh>(make_shape("cube"));
  s.next("mesh");
  s.scene.objects.erase(s.scene.objects.begin());
  s.next("object gone");
  s.camera.eye = {1, 0, 4};
  s.next("camera");
  s.camera.near = 3.5;
  s.next("cut by the near plane");
  s.scene.lights[0].colour = {1, 0, 0};
  s.scene.objects[0].world_from_object = glm::translate(glm::mat4(1), {0, 0.5f, 0.5f});
  s.next("light and object, cut");
}

TEST_P(Reuse, ASceneThatStandsStill) {
  Sequence& s = sequence;
  const FrameStats first = s.next("first");
  EXPECT_EQ(first.tiles_kept, 0);
  const FrameStats still = s.next("nothing changed");
  EXPECT_GT(still.tiles_kept, 0);
  EXPECT_EQ(still.triangles, 0);
  EXPECT_EQ(still.fragments, 0);
  s.scene.lights[0].intensity = 2;
  const FrameStats lit = s.next("light");
  EXPECT_EQ(lit.tiles_kept, 0);
  EXPECT_EQ(lit.triangles, 0);
  EXPECT_EQ(lit.fragments, first.fragments);
}

TEST_P(Reuse, AnotherFramebufferIsDrawnWhole) {
  Sequence& s = sequence;
  s.next("first");
  s.picture = Framebuffer(width, height, s.planes);
  s.next("another of the same kind");
  // At the same addresses, as memory that was freed is handed out again.
  s.picture = {};
  s.picture = Framebuffer(width, height, s.planes);
  s.next("another in its place");
  Scene other = s.scene;
  other.objects.pop_back();
  render(other, s.camera, {}, s.picture);
  s.next("drawn over by another renderer");
  s.planes = {.format = ColourFormat::srgb_8bit};
  s.picture = Framebuffer(width, height, s.planes);
  s.next("another format");
  s.next("nothing changed");
}

TEST(Reuse, AfterAFrameThatFailedNothingStands) {
  Sequence s;
  s.next("first");
  s.scene.lights[0].intensity = -1;
  EXPECT_ANY_THROW(s.renderer.render(s.scene, s.camera, s.settings, s.picture));
  s.scene.lights[0].intensity = 2;
  s.next("mended");
}

}  // namespace
}  // namespace scanlit
