// Tolerances at the limits of what is bounded: rows of a whole tile, triangles that are too small,
// directions of which nothing is known.
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "models/registry.h"
#include "tests/unit/same_picture.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

Framebuffer drawn(const Scene& scene, const Camera& camera, const Framebuffer& like, int threads,
                  double tolerance, FrameStats& stats) {
  Framebuffer picture(like.width, like.height, like.planes());
  stats = render(scene, camera, {.threads = threads, .tolerance = tolerance}, picture);
  return picture;
}

void add_corner(Mesh& mesh, const glm::vec3& position, const glm::vec3& normal) {
  mesh.indices.push_back(std::uint32_t(mesh.positions.size()));
  mesh.positions.push_back(position);
  mesh.normals.push_back(glm::normalize(normal));
}

/// Parallel, so that V is the same everywhere; what is `height` high fills the picture.
Camera parallel_camera(const glm::dvec3& eye, const glm::dvec3& target, double height) {
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.eye = eye;
  camera.target = target;
  camera.height = height;
  camera.far = 100;
  camera.viewer_at_infinity = true;
  return camera;
}

Object seen_from_both_sides(std::shared_ptr<const Mesh> mesh, const char* model) {
  Object object;
  object.mesh = std::move(mesh);
  object.material.model = models::make(model).model;
  object.material.ka = Rgb<double>(0);
  object.sides = Sides::both;
  return object;
}

// A row as long as a tile is wide, shaded at every second pixel and the last, is one fragment more
// than a span holds.
TEST(ToleranceLimits, ARowThatGoesThroughAWholeTile) {
  const float half = 8, bend = .5;
  const auto mesh = std::make_shared<Mesh>();
  for (const glm::vec3& p : {glm::vec3{-3 * half, -.3, 0}, {3 * half, -.3, 0}, {0, 3, 0}})
    add_corner(*mesh, p, {bend * p.x / half, 0, 1});
  // Beside it one whose runs are too short for strides.
  for (const glm::vec3& p : {glm::vec3{0, -.9, 0}, {.06, -.9, 0}, {.03, -.35, 0}})
    add_corner(*mesh, p, {bend * p.x / half, 0, 1});
  Scene scene;
  scene.objects = {seen_from_both_sides(mesh, "blinn-phong:kd=0,ks=1,n=300")};
  for (int i = 0; i < 24; ++i) {
    const double angle = 2 * std::atan(bend * (-1.05 + 2.1 * (i + .5) / 24));
    scene.lights.push_back({.intensity = .5, .direction = {std::sin(angle), 0, std::cos(angle)}});
  }
  const Camera camera = parallel_camera({0, 0, 5}, {0, 0, 0}, 2);
  FrameStats stats;
  std::int64_t least = 0;
  for (double tolerance = .3; tolerance < 3; tolerance *= 1.08) {
    drawn(scene, camera, {1024, 128, {.format = ColourFormat::linear_8bit}}, 1, tolerance, stats);
    least = stats.evaluations;
  }
  EXPECT_LT(least, 24 * stats.covered_pixels * 2 / 3);
}

// Those below 40 pixels are bounded only as neighbours of larger ones: whether they are, and when,
// may not show.
TEST(ToleranceLimits, SmallTrianglesDoNotDependOnThreads) {
  const int width = 1280, height = 768;
  std::mt19937 random(1);
  const auto any = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  const auto mesh = std::make_shared<Mesh>();
  for (int i = 0; i < 4000; ++i) {
    const glm::vec3 at(any(0, width), any(0, height), any(-1, 1));
    const float right = any(20, 60), up = any(20, 40);
    const glm::vec3 large[] = {at, at + glm::vec3(right, 0, 0), at + glm::vec3(0, up, 0)};
    const glm::vec3 small[] = {at, at + glm::vec3(28, 0, 0), at + glm::vec3(14, 2.6, 0)};
    for (const glm::vec3& p : i % 4 ? large : small)
      add_corner(*mesh, p, {.3f * std::sin(p.x / 40), .3f * std::cos(p.y / 50), 1});
  }
  Scene scene;
  scene.objects = {seen_from_both_sides(mesh, "blinn-phong:kd=.6,ks=.3,n=20")};
  scene.lights = {{.direction = {.3, .4, 1}}};
  const glm::dvec3 middle(width / 2, height / 2, 0);
  const Camera camera = parallel_camera(middle + glm::dvec3(0, 0, 10), middle, height);
  FrameStats of_one, of_many;
  const Framebuffer one = drawn(scene, camera, {width, height}, 1, 1, of_one);
  EXPECT_LT(of_one.evaluations, of_one.fragments);
  for (int i = 0; i < 6; ++i) {
    const Framebuffer many = drawn(scene, camera, {width, height}, 2 + i % 3, 1, of_many);
    EXPECT_EQ(planes_that_differ(one, many), "");
    EXPECT_EQ(of_one.evaluations, of_many.evaluations);
  }
}

// A lamp near one of a triangle's corners, whose direction over the triangle is known to no better
// than the arc sine of .9 or so: almost everywhere it is behind the surface, but not at that
// corner.
TEST(ToleranceLimits, ALampOfWhichNoDirectionIsKnown) {
  const double pixels = 4500, degrees = std::numbers::pi / 180;
  for (const double sine : {.92, .94, .95, .96})
    for (double behind = 152; behind < 162; behind += .5) {
      const double a = std::asin(sine), turned = behind * degrees;
      const glm::dvec3 near = -std::cos(a) * glm::dvec3(std::sin(a), 0, std::cos(a));
      const glm::dvec3 rest = (glm::dvec3(0, 0, -4) - near) / 3.0;
      const glm::dvec3 corners[] = {near, rest + glm::dvec3(0, .7, 0),
                                    rest - glm::dvec3(0, .35, 0)};
      const auto mesh = std::make_shared<Mesh>();
      for (const glm::dvec3& corner : corners)
        add_corner(*mesh, corner, {std::sin(turned), 0, std::cos(turned)});
      Scene scene;
      scene.objects = {seen_from_both_sides(mesh, "lambert:kd=1")};
      scene.lights = {{.kind = LightKind::point, .intensity = 2, .constant = 0, .quadratic = 1}};

      const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
      const glm::dvec3 across = glm::cross(corners[1] - near, corners[2] - near);
      const glm::dvec3 up = glm::normalize(glm::cross(across, near - middle));
      Camera camera = parallel_camera(middle + 10.0 * glm::normalize(across), middle,
                                      400 / std::sqrt(2 * pixels / glm::length(across)));
      camera.up = up;
      FrameStats stats;
      const Framebuffer like(400, 400, {.format = ColourFormat::linear_8bit});
      const Framebuffer exact = drawn(scene, camera, like, 1, 0, stats),
                        near_enough = drawn(scene, camera, like, 1, 1, stats);
      int worst = 0;
      for (std::size_t i = 0; i < exact.rgba8.size(); ++i)
        worst = std::max(worst, std::abs(exact.rgba8[i] - near_enough.rgba8[i]));
      EXPECT_LE(worst, 1) << sine << ' ' << behind;
    }
}

}  // namespace
}  // namespace scanlit
