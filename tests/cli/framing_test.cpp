// The automatic camera: everything is in the picture, and it could not be larger.
#include "lessons/studio/framing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <memory>

#include "lessons/studio/description.h"
#include "rasterizer/shapes.h"

namespace scanlit::studio {
namespace {

Scene scene_of(const char* shape, const glm::vec3& place) {
  Scene scene;
  Object object;
  object.mesh = std::make_shared<const Mesh>(make_shape(shape));
  object.world_from_object[3] = glm::vec4(place, 1);
  scene.objects.push_back(object);
  return scene;
}

/// The corners of the box that all positions take up after division by w.
struct Box {
  glm::dvec3 low{1e9}, high{-1e9};
};

Box seen(const Scene& scene, const Camera& camera, double aspect) {
  const glm::dmat4 clip_from_object =
      clip_from_world(camera, aspect) * glm::dmat4(scene.objects[0].world_from_object);
  Box box;
  for (const glm::vec3& position : scene.objects[0].mesh->positions) {
    const glm::dvec4 clip = clip_from_object * glm::dvec4(position, 1);
    box.low = glm::min(box.low, glm::dvec3(clip) / clip.w);
    box.high = glm::max(box.high, glm::dvec3(clip) / clip.w);
  }
  return box;
}

class Fitted : public testing::TestWithParam<Projection> {};

TEST_P(Fitted, IsTightAndCentredFromEverywhere) {
  const double edge = 1 / 1.12;  // of the picture, less the margin
  for (const glm::dvec3 direction :
       {glm::dvec3(1, 1, 1), glm::dvec3(0, 0, 1), glm::dvec3(-5, 2, 1)})
    for (const double aspect : {0.3, 1.0, 4.0})
      for (const char* shape : {"teapot:3", "plane", "trefoil:4"}) {
        const Scene scene = scene_of(shape, {100, -7, 3});
        Camera camera;
        camera.projection = GetParam();
        camera.eye = direction;
        camera.fov_deg = 20;  // no part of the scene comes too near
        camera = fitted(camera, scene, aspect);
        EXPECT_LT(glm::distance(glm::normalize(direction), towards_viewer(camera)), 1e-9);

        const Box box = seen(scene, camera, aspect);
        const double widest = std::max(box.high.x, box.high.y);
        EXPECT_NEAR(widest, edge, 1e-3) << shape << " at aspect " << aspect;
        EXPECT_NEAR(-std::min(box.low.x, box.low.y), widest, 1e-3) << shape;
        EXPECT_GT(box.low.z, 0) << "behind the far plane";
        EXPECT_LT(box.high.z, 1) << "before the near plane";
      }
}

INSTANTIATE_TEST_SUITE_P(, Fitted,
                         testing::Values(Projection::perspective, Projection::orthographic));

TEST_P(Fitted, FillsThePictureWithScenesOfAnySize) {
  for (const float size : {1e-8f, 1e8f}) {
    Scene scene = scene_of("trefoil:4", {0, 0, 0});
    scene.objects[0].world_from_object = glm::mat4(size);
    scene.objects[0].world_from_object[3] = {0, 0, 0, 1};
    Camera camera;
    camera.projection = GetParam();
    camera.fov_deg = 20;
    const Box box = seen(scene, fitted(camera, scene, 1), 1);
    EXPECT_NEAR(std::max(box.high.x, box.high.y), 1 / 1.12, 1e-3) << size;
  }
}

TEST(FittedCamera, APointAndNothingAtAllStillGiveACamera) {
  Scene scene = scene_of("plane", {0, 0, 0});
  scene.objects[0].world_from_object = glm::mat4(0);
  scene.objects[0].world_from_object[3] = {5, 5, 5, 1};
  EXPECT_NO_THROW(validate(fitted(Camera{}, scene, 1.5)));
  EXPECT_NO_THROW(validate(fitted(Camera{}, Scene{}, 1.5)));
}

TEST(AutomaticCamera, LooksFromTheSameSideFarFromTheOrigin) {
  Scene scene = scene_of("cube", {0, 0, 0});
  const glm::dvec3 near_by = towards_viewer(make_camera(View(), scene, 1));
  scene.objects[0].world_from_object = glm::mat4(1e16f);
  scene.objects[0].world_from_object[3] = {3e16f, -5e16f, 0, 1};
  EXPECT_LT(glm::distance(towards_viewer(make_camera(View(), scene, 1)), near_by), 1e-6);
}

}  // namespace
}  // namespace scanlit::studio
