// (9) Normals that have no direction, or lose it on the way.
#include <algorithm>
#include <cmath>

#include "models/blinn_phong.h"
#include "tests/stress/grid_mesh.h"
#include "tests/unit/test_scene.h"

namespace scanlit::stress {
namespace {

constexpr int size = 24;

/// A square that fills the picture of a camera at distance 3.
std::shared_ptr<Mesh> square(const std::vector<glm::vec3>& normals) {
  auto mesh = mesh_of({{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}}, {0, 1, 2, 0, 2, 3});
  mesh->normals = normals;
  return mesh;
}

Object shiny(std::shared_ptr<const Mesh> mesh, Shading shading) {
  Object object = test::object_of(std::move(mesh), models::BlinnPhong<>(), shading);
  object.material.ka = Rgb<double>(0.1);
  return object;
}

/// Every colour is finite, and every normal of what was drawn of unit length. Returns how many.
std::int64_t expect_sound(const test::Picture& picture) {
  const Framebuffer& f = picture.framebuffer;
  std::int64_t drawn = 0;
  for (std::size_t i = 0; i < f.pixel_count(); ++i) {
    for (std::size_t c = 0; c < 4; ++c) EXPECT_TRUE(std::isfinite(f.colour[4 * i + c]));
    if (f.object_id[i] == no_id) continue;
    const float* n = &f.normal[3 * i];
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-5);
    ++drawn;
  }
  return drawn;
}

Camera camera_at(double distance) {
  Camera camera;
  camera.eye = {0, 0, distance};
  camera.near = distance * 1e-3;
  return camera;
}

Scene lit(Object object) {
  Scene scene = test::scene_of({std::move(object)});
  scene.lights[0].direction = {0.3, 0.2, 1};
  scene.lights[0].intensity = 2;
  return scene;
}

TEST(Normals, OpposingAndVanishing) {
  Property property{"normals that cancel give finite colours and unit normals",
                    "four corners with normals that are opposite, nearly opposite (by 1e-8 to 1), "
                    "zero, as small as 1e-45 or any",
                    "pixels with a fault", 2000};
  while (property.next()) {
    const glm::dvec3 n = random_direction(property);
    std::vector<glm::vec3> normals;
    for (int i = 0; i < 4; ++i) {
      const glm::dvec3 near = n + property.decades(-8, 0) * random_direction(property);
      switch (property.whole(0, 4)) {
        case 0: normals.emplace_back(n); break;
        case 1: normals.emplace_back(-n); break;
        case 2: normals.emplace_back(-glm::normalize(near)); break;
        case 3: normals.emplace_back(0); break;
        default: normals.emplace_back(n * property.decades(-45, 0));
      }
    }
    const Shading shading = property.any_of(Shading::flat, Shading::gouraud, Shading::phong);
    const test::Picture picture =
        test::picture_of(lit(shiny(square(normals), shading)), camera_at(3), size, size);
    property.checked(expect_sound(picture));
    property.measure(testing::Test::HasFailure(), "");
  }
}

TEST(Normals, FollowTheirTransform) {
  Property property{"a transformed surface's normals are those of its transformed tangent plane",
                    "linear maps with axes scaled by 1e-6 to 1e6, sheared, turned and mirrored",
                    "rad between the two (allowed: 1e-6)", 3000};
  while (property.next()) {
    glm::dmat3 m(random_direction(property), random_direction(property),
                 random_direction(property));
    // Columns that are nearly in one plane leave a normal few digits.
    if (std::abs(glm::determinant(m)) < 0.05) continue;
    for (int i = 0; i < 3; ++i) m[i] *= property.decades(-6, 6);
    // Of the float matrix that is drawn.
    const glm::dmat3 used{glm::mat3(m)};
    const glm::dvec3 normal = random_direction(property);
    // The object is shrunk to the picture by a triangle that covers it, wherever it is tilted to.
    const glm::dmat3 inverse = glm::inverse(used);
    const std::vector<glm::dvec3> wanted = {{-9, -9, 0}, {9, -9, 0}, {0, 18, 0}};
    std::vector<glm::vec3> positions;
    for (const auto& p : wanted) positions.emplace_back(inverse * p);
    Object object =
        shiny(mesh_of(positions, {0, 1, 2}), property.coin() ? Shading::phong : Shading::gouraud);
    std::const_pointer_cast<Mesh>(object.mesh)->normals.assign(3, glm::vec3(normal));
    object.world_from_object = glm::mat4(glm::mat3(used));
    const test::Picture picture = test::picture_of(lit(object), camera_at(3), size, size);
    const std::size_t middle = std::size_t(size * size + size) / 2;
    if (picture.framebuffer.object_id[middle] == no_id) continue;
    // inverse transpose * normal, and back faces turned.
    glm::dvec3 expected = glm::normalize(glm::transpose(inverse) * glm::dvec3(glm::vec3(normal)));
    const float* n = &picture.framebuffer.normal[3 * middle];
    const glm::dvec3 actual(n[0], n[1], n[2]);
    if (glm::determinant(used) < 0) expected = -expected;
    const double angle = std::min(glm::length(actual - expected), glm::length(actual + expected));
    property.measure(angle, "determinant ", glm::determinant(used));
    EXPECT_LE(property.worst(), 1e-6);
  }
}

TEST(Normals, SingularTransforms) {
  Property property{
      "a transform that flattens, squeezes or annihilates gives finite colours and "
      "unit normals",
      "one to three axes scaled by 0 or by 1e-44 to 1e30, shears, mirrors", "pixels with a fault",
      3000};
  while (property.next()) {
    glm::mat4 m(1);
    for (int i = 0; i < 3; ++i) {
      const double scale = property.any_of(0.0, 0.0, 1.0, -1.0, property.decades(-44, 30));
      const glm::dvec3 axis =
          property.coin() ? random_direction(property) : glm::dvec3(i == 0, i == 1, i == 2);
      m[i] = glm::vec4(glm::vec3(axis * scale), 0);
    }
    const Grid grid(4, 4, true, property);
    std::vector<glm::vec3> positions;
    for (const auto& p : torus_positions(4, 4, 0.4, 0.1, property)) positions.emplace_back(p);
    auto mesh = mesh_of(positions, grid.indices);
    for (auto& n : mesh->normals) n = random_direction(property);
    Object object = shiny(mesh, property.any_of(Shading::flat, Shading::gouraud, Shading::phong));
    object.world_from_object = m;
    const test::Picture picture =
        test::picture_of(lit(object), camera_at(property.decades(-2, 2)), size, size);
    property.checked(expect_sound(picture));
    property.measure(testing::Test::HasFailure(), "");
  }
}

}  // namespace
}  // namespace scanlit::stress
