// What shading leaves out, no picture shows.
#include <gtest/gtest.h>

#include "models/registry.h"
#include "rasterizer/shapes.h"
#include "tests/unit/same_picture.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

/// Three spheres under lights of every kind, some of which reach little of them or nothing.
Scene lit_scene(const std::string& model) {
  Scene scene;
  const auto mesh = std::make_shared<Mesh>(make_shape("sphere:24"));
  const Shading shadings[] = {Shading::phong, Shading::gouraud, Shading::flat};
  for (int i = 0; i < 3; ++i) {
    Object& object = scene.objects.emplace_back();
    object.mesh = mesh;
    object.material.model = models::make(model).model;
    object.shading = shadings[i];
    object.world_from_object[3] = {1.5f * float(i - 1), 0, 0, 1};
  }
  scene.lights = {{.direction = {1, 1, -0.5}},
                  {.colour = {1, 0.5, 0.2}, .direction = {-1, 0.2, -1}},
                  {.intensity = 0},
                  {.kind = LightKind::point, .position = {0, 2, 1}, .constant = 0, .quadratic = 1},
                  {.kind = LightKind::point, .position = {-1.5, 0, 0}, .linear = 1},
                  {.kind = LightKind::spot, .direction = {0, 0, -1}, .position = {1.5, 0.4, 4}}};
  return scene;
}

Camera camera_of(bool viewer_at_infinity) {
  Camera camera{.eye = {0, 0, 6}};
  camera.viewer_at_infinity = viewer_at_infinity;
  return camera;
}

void expect_same_pictures(const Scene& scene, const Camera& camera, bool Skips::*skip) {
  RenderSettings settings;
  const Picture with = picture_of(scene, camera, 160, 90, settings);
  settings.skips.*skip = false;
  const Picture without = picture_of(scene, camera, 160, 90, settings);
  ASSERT_GT(with.stats.covered_pixels, 1000);
  EXPECT_EQ(planes_that_differ(with.framebuffer, without.framebuffer), "");
  EXPECT_EQ(with.stats.evaluations, without.stats.evaluations);
}

TEST(SkippedLighting, LeavesThePictureTheSameToTheBit) {
  // A formula, one in the shading frame, and a model that is lit by the default loop.
  for (const char* model : {"blinn-phong", "ward", "sum:(lambert),(cook-torrance)"})
    for (const bool viewer_at_infinity : {false, true})
      for (bool Skips::*skip :
           {&Skips::dark_lights, &Skips::far_directions, &Skips::unused_attributes}) {
        SCOPED_TRACE(model);
        expect_same_pictures(lit_scene(model), camera_of(viewer_at_infinity), skip);
      }
}

TEST(SkippedLighting, LeavesAnAmbientSceneTheSameToTheBit) {
  for (const bool viewer_at_infinity : {false, true})
    for (const int lights : {0, 1}) {
      Scene scene = lit_scene("blinn-phong");
      scene.lights.assign(std::size_t(lights), {.intensity = 0});
      expect_same_pictures(scene, camera_of(viewer_at_infinity), &Skips::unused_attributes);
    }
}

TEST(SkippedLighting, LeavesFlatFacesTheSameToTheBit) {
  // Where all three normals of a triangle are the same, nobody asks where in it a fragment lies.
  for (const bool viewer_at_infinity : {false, true}) {
    Scene scene = lit_scene("blinn-phong");
    scene.lights.resize(2);  // far ones
    const auto add = [&](const char* shape, Shading shading, const glm::mat3& turned, float x) {
      Object& object = scene.objects.emplace_back(scene.objects[0]);
      object.mesh = std::make_shared<Mesh>(make_shape(shape));
      object.shading = shading;
      object.sides = Sides::both;
      object.world_from_object = glm::mat4(turned);
      object.world_from_object[3] = {x, 1.4f, 0, 1};
    };
    const glm::mat3 tilted(0.6f, 0, 0.8f, 0.64f, 0.6f, -0.48f, -0.48f, 0.8f, 0.36f);
    add("cube", Shading::phong, 0.5f * tilted, -1.5f);
    add("plane", Shading::phong, -0.5f * tilted, 0);  // mirrored, from behind
    add("cube", Shading::gouraud, 0.5f * tilted, 1.5f);
    const auto draw = [&](bool skip) {
      RenderSettings settings;
      settings.skips.unused_attributes = skip;
      Framebuffer colours(160, 90);
      render(scene, camera_of(viewer_at_infinity), settings, colours);
      return colours;
    };
    EXPECT_EQ(planes_that_differ(draw(true), draw(false)), "");
  }
}

TEST(SkippedLighting, IsCounted) {
  Scene scene = lit_scene("blinn-phong");
  scene.objects.resize(1);
  // From behind the sphere: every point that is seen is dark. From the viewer's side: none.
  for (const double side : {-1.0, 1.0}) {
    scene.lights = {{.direction = {0, 0, side}}};
    scene.objects[0].world_from_object[3] = {0, 0, 0, 1};
    Camera camera = camera_of(false);
    camera.projection = Projection::orthographic;
    camera.far = 10;
    camera.height = 1;  // the middle of the sphere alone
    const Picture picture = picture_of(scene, camera, 64, 64);
    EXPECT_EQ(picture.stats.evaluations, 64 * 64);
    EXPECT_EQ(picture.stats.evaluations_skipped, side < 0 ? 64 * 64 : 0);
  }
}

}  // namespace
}  // namespace scanlit
