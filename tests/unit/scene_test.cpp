// Scenes: bounding spheres, and what is refused, naming the object or light and the field.
#include "rasterizer/scene.h"

#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "rasterizer/error.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Scene sound_scene() {
  Scene scene = scene_of({object_of(triangle_soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}))});
  scene.objects.push_back(scene.objects[0]);
  scene.objects[1].name = "lid";
  for (const LightKind kind : {LightKind::point, LightKind::spot})
    scene.lights.emplace_back().kind = kind;
  return scene;
}

void expect_refused(const std::function<void(Scene&)>& spoil, const std::string& where,
                    const std::string& field) {
  Scene scene = sound_scene();
  spoil(scene);
  std::string message = "accepted";
  try {
    validate(scene);
  } catch (const Error& error) {
    message = error.what();
  }
  EXPECT_EQ(message.find(where), 0u) << message << ", expected: " << where;
  EXPECT_NE(message.find(field), std::string::npos) << message << ", expected: " << field;
  EXPECT_EQ(message.find('\n'), std::string::npos);
  // Rendering refuses it too, before it draws.
  Framebuffer framebuffer(2, 2);
  EXPECT_THROW(render(scene, Camera(), {}, framebuffer), Error);
}

TEST(Scene, SoundOnesAreAccepted) {
  EXPECT_NO_THROW(validate(Scene()));
  EXPECT_NO_THROW(validate(sound_scene()));
}

TEST(Scene, ObjectsWithoutMeshOrModelAreRefused) {
  expect_refused([](Scene& s) { s.objects[0].mesh = nullptr; }, "object 0", "mesh");
  expect_refused([](Scene& s) { s.objects[1].material.model = nullptr; }, "object 'lid'", "model");
}

TEST(Scene, ColoursOutOfRangeAreRefused) {
  for (const double bad : {nan, infinity, -0.1, 1e13}) {
    expect_refused([&](Scene& s) { s.objects[1].material.ka.g = bad; }, "object 'lid'", "ka");
    expect_refused([&](Scene& s) { s.objects[0].material.object_colour.b = bad; }, "object 0",
                   "object colour");
    expect_refused([&](Scene& s) { s.lights[1].colour.r = bad; }, "light 1", "colour");
    expect_refused([&](Scene& s) { s.lights[0].intensity = bad; }, "light 0", "intensity");
    expect_refused([&](Scene& s) { s.ambient.r = bad; }, "scene", "ambient");
    expect_refused([&](Scene& s) { s.background.b = bad; }, "scene", "background");
  }
}

TEST(Scene, TransformsThatAreNotFiniteAndAffineAreRefused) {
  for (const double bad : {nan, infinity})
    expect_refused([&](Scene& s) { s.objects[1].world_from_object[2][1] = float(bad); },
                   "object 'lid'", "finite");
  expect_refused([](Scene& s) { s.objects[0].world_from_object[1][3] = 0.5f; }, "object 0",
                 "affine");
  expect_refused([](Scene& s) { s.objects[0].world_from_object[3][3] = 2; }, "object 0", "affine");
}

TEST(Scene, LightsOutOfRangeAreRefused) {
  for (const double bad : {nan, infinity}) {
    expect_refused([&](Scene& s) { s.lights[0].direction.x = bad; }, "light 0", "direction");
    expect_refused([&](Scene& s) { s.lights[1].position.y = bad; }, "light 1", "position");
  }
  expect_refused([](Scene& s) { s.lights[1].position.x = 1e39; }, "light 1", "position");
  expect_refused([](Scene& s) { s.lights[0].direction = {0, 0, 0}; }, "light 0", "direction");
  expect_refused([](Scene& s) { s.lights[2].direction = {0, 0, 0}; }, "light 2", "direction");
  for (const double bad : {nan, infinity, -1.0}) {
    expect_refused([&](Scene& s) { s.lights[1].constant = bad; }, "light 1", "fall-off");
    expect_refused([&](Scene& s) { s.lights[1].linear = bad; }, "light 1", "fall-off");
    expect_refused([&](Scene& s) { s.lights[1].quadratic = bad; }, "light 1", "fall-off");
  }
  expect_refused([](Scene& s) { s.lights[1].constant = 0; }, "light 1", "fall-off");
  const auto angles = [](double inner, double outer) {
    return [=](Scene& s) { s.lights[2].inner_deg = inner, s.lights[2].outer_deg = outer; };
  };
  for (const auto& [inner, outer] :
       {std::pair(-1.0, 30.0), {30.0, 30.0}, {40.0, 30.0}, {10.0, 91.0}, {nan, 30.0}, {10.0, nan}})
    expect_refused(angles(inner, outer), "light 2", "spot angles");
}

TEST(Scene, DirectionsOfAnyLengthLightTheSame) {
  for (const double length : {1e-150, 1e-20, 1.0, 1e150}) {
    Scene scene =
        scene_of({object_of(triangle_soup({{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}), CosineOnly())});
    scene.lights[0].direction = glm::dvec3(0.6, 0, 0.8) * length;
    const Picture picture = picture_of(scene, Camera(), 4, 4);
    EXPECT_NEAR(picture.colour(1, 1)[0], 0.8, 1e-6) << length;
  }
  // Where the square of the length leaves double's range there is nothing to normalise by.
  for (const double length : {1e-300, 1e200})
    expect_refused([&](Scene& s) { s.lights[0].direction *= length; }, "light 0", "direction");
}

TEST(Scene, BoundingSphereHoldsEveryObject) {
  Scene scene = sound_scene();
  scene.objects[1].world_from_object =
      glm::scale(glm::translate(glm::mat4(1), glm::vec3(10, 0, 0)), glm::vec3(2));
  const Sphere sphere = bounding_sphere(scene);
  for (const glm::dvec3& p :
       {glm::dvec3(0, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(12, 0, 0), glm::dvec3(10, 2, 0)})
    EXPECT_LE(glm::distance(p, sphere.centre), sphere.radius * (1 + 1e-6));
  EXPECT_LT(sphere.radius, 6.2);
  EXPECT_EQ(bounding_sphere(Scene()).radius, 0);
}

}  // namespace
}  // namespace scanlit
