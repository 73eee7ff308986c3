// (2) Camera: the conventions of pipeline.h, framing, and what is refused.
#include "rasterizer/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <random>
#include <string>

#include "rasterizer/error.h"

namespace scanlit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// x, y and depth after division by w; w in .w.
glm::dvec4 projected(const Camera& camera, const glm::dvec3& world, double aspect = 1) {
  const glm::dvec4 clip = clip_from_world(camera, aspect) * glm::dvec4(world, 1);
  return {glm::dvec3(clip) / clip.w, clip.w};
}

void expect_vector(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance = 1e-12) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance) << "component " << c;
}

TEST(Camera, LooksAlongItsMinusZWithXRightAndYUp) {
  Camera camera;
  camera.eye = {0, 0, 5};
  camera.fov_deg = 90;
  camera.near = 1;
  // At distance 5 half the picture's height is 5.
  expect_vector(projected(camera, {0, 0, 0}), {0, 0, 0.2});
  expect_vector(projected(camera, {5, 0, 0}), {1, 0, 0.2});
  expect_vector(projected(camera, {0, 5, 0}), {0, 1, 0.2});
  expect_vector(projected(camera, {5, 0, 0}, 2), {0.5, 0, 0.2});
  EXPECT_LT(projected(camera, {0, 0, 6}).w, 0);
}

TEST(Camera, LooksFromAnywhereWithAnyUp) {
  Camera camera;
  camera.eye = {3, 4, 5};
  camera.target = {3, 4, 2};
  camera.up = {-7, 0, 2};  // neither unit nor perpendicular: up is -x
  camera.fov_deg = 90;
  expect_vector(projected(camera, {2, 4, 4}), {0, 1, 0.01});
  expect_vector(projected(camera, {3, 5, 4}), {1, 0, 0.01});
}

TEST(Camera, DepthIsOneAtNearAndZeroAtFar) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Camera camera;
    camera.eye = {0, 0, 0}, camera.target = {0, 0, -1};
    camera.projection = projection;
    camera.near = 0.5, camera.far = 20;
    EXPECT_NEAR(projected(camera, {0, 0, -0.5}).z, 1, 1e-12);
    EXPECT_NEAR(projected(camera, {0, 0, -20}).z, 0, 1e-12);
    EXPECT_GT(projected(camera, {0, 0, -2}).z, projected(camera, {0, 0, -3}).z);
  }
  Camera camera;
  camera.eye = {0, 0, 0}, camera.target = {0, 0, -1};
  camera.near = 0.5;
  EXPECT_NEAR(projected(camera, {0, 0, -0.5}).z, 1, 1e-12);
  EXPECT_NEAR(projected(camera, {0, 0, -1e9}).z, 5e-10, 1e-20);
}

TEST(Camera, OrthographicHasItsHeightAndParallelLines) {
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.height = 4;
  camera.near = 1, camera.far = 11;
  for (const double z : {0.0, -5.0}) {
    const glm::dvec4 p = projected(camera, {1, 2, z}, 2);
    EXPECT_NEAR(p.x, 0.25, 1e-12);
    EXPECT_NEAR(p.y, 1, 1e-12);
    EXPECT_EQ(p.w, 1);
  }
}

TEST(Camera, ViewerAtInfinityIsInTheDirectionOfTheEye) {
  Camera camera;
  camera.eye = {3, 0, 4};
  expect_vector(towards_viewer(camera), {0.6, 0, 0.8});
}

TEST(Camera, FramingHoldsTheSphereAndWastesLittle) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    Camera camera;
    camera.eye = {normal(random), normal(random), normal(random)};
    camera.projection = i % 2 ? Projection::orthographic : Projection::perspective;
    camera.fov_deg = 5 + i % 120;
    const double aspect = std::exp(normal(random));
    const Sphere sphere{{normal(random) * 9, normal(random), normal(random)},
                        std::exp(3 * normal(random))};
    const Camera view = framed(camera, sphere, aspect);
    ASSERT_NO_THROW(validate(view));
    expect_vector(towards_viewer(view), towards_viewer(camera), 1e-9);

    double widest = 0;
    for (int k = 0; k < 2000; ++k) {
      const glm::dvec3 direction(normal(random), normal(random), normal(random));
      const glm::dvec3 on_sphere = sphere.centre + sphere.radius * glm::normalize(direction);
      const glm::dvec4 p = projected(view, on_sphere, aspect);
      ASSERT_GT(p.w, 0);
      ASSERT_TRUE(p.z > 0 && p.z < 1) << p.z;
      widest = std::max({widest, std::abs(p.x), std::abs(p.y)});
    }
    EXPECT_LT(widest, 1);
    EXPECT_GT(widest, 0.8);  // 1 / 1.05, less what 2000 points miss of the silhouette
  }
}

TEST(Camera, FramingAPointStillGivesACamera) {
  EXPECT_NO_THROW(validate(framed(Camera(), {{1, 2, 3}, 0}, 1.5)));
}

// --------------------------------------------------------------------------------------- refusals

std::string refusal(const std::function<void(Camera&)>& spoil) {
  Camera camera;
  spoil(camera);
  try {
    validate(camera);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

void expect_refused(const std::function<void(Camera&)>& spoil, const std::string& field) {
  const std::string message = refusal(spoil);
  EXPECT_NE(message.find(field), std::string::npos) << message << ", expected: " << field;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(Camera, TheDefaultIsAccepted) {
  EXPECT_EQ(refusal([](Camera&) {}), "accepted");
}

TEST(Camera, PositionsThatAreNotFiniteAreRefused) {
  for (const double bad : {nan, infinity, -infinity}) {
    expect_refused([&](Camera& c) { c.eye.x = bad; }, "eye");
    expect_refused([&](Camera& c) { c.target.y = bad; }, "target");
    expect_refused([&](Camera& c) { c.up.z = bad; }, "up");
  }
}

TEST(Camera, DirectionsThatAreNoneAreRefused) {
  expect_refused([](Camera& c) { c.eye = c.target; }, "eye and target");
  expect_refused([](Camera& c) { c.up = {0, 0, 0}; }, "up");
  expect_refused([](Camera& c) { c.up = {0, 0, 1}; }, "up");
  expect_refused([](Camera& c) { c.up = {0, 0, -3}; }, "up");
}

TEST(Camera, NumbersOutOfRangeAreRefused) {
  for (const double bad : {nan, infinity, -1.0, 0.0, 180.0, 360.0})
    expect_refused([&](Camera& c) { c.fov_deg = bad; }, "field of view");
  for (const double bad : {nan, infinity, -1.0, 0.0})
    expect_refused([&](Camera& c) { c.near = bad; }, "near");
  for (const double bad : {nan, -infinity, 0.0, 0.01, 0.005})
    expect_refused([&](Camera& c) { c.far = bad; }, "far");
  const auto orthographic = [](Camera& c) {
    c.projection = Projection::orthographic;
    c.far = 10;
  };
  EXPECT_EQ(refusal(orthographic), "accepted");
  for (const double bad : {nan, infinity, -1.0, 0.0})
    expect_refused([&](Camera& c) { orthographic(c), c.height = bad; }, "height");
  expect_refused([&](Camera& c) { orthographic(c), c.far = infinity; }, "far");
}

TEST(Camera, WhatFloatCannotHoldIsRefused) {
  // Each is a finite double, and none of its pictures would show anything.
  expect_refused([](Camera& c) { c.fov_deg = 1e-40; }, "field of view");
  expect_refused([](Camera& c) { c.eye = {1e39, 0, 0}; }, "eye");
  expect_refused([](Camera& c) { c.target = {1e39, 0, 0}; }, "target");
  expect_refused([](Camera& c) { c.near = 1e39; }, "near");
  expect_refused(
      [](Camera& c) {
        c.projection = Projection::orthographic;
        c.far = 10, c.height = 1e-40;
      },
      "height");
}

}  // namespace
}  // namespace scanlit
