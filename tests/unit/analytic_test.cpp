// The true surfaces behind the meshes.
#include "rasterizer/reference/analytic.h"

#include <glm/gtc/matrix_transform.hpp>

#include "models/registry.h"
#include "rasterizer/error.h"
#include "rasterizer/reference/picture_error.h"
#include "rasterizer/shapes.h"
#include "tests/unit/test_scene.h"

namespace scanlit::test {
namespace {

/// Rays from outside through the vertices of a mesh meet the surface there, with its normal. On the
/// teapot, not all: at some, one part passes closely by another.
void expect_vertices_on_surface(const char* shape, double least_share) {
  const Mesh mesh = make_shape(shape);
  const auto surface = analytic_surface(shape);
  ASSERT_TRUE(surface);
  int met = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    const glm::dvec3 p(mesh.positions[i]), n(mesh.normals[i]);
    const glm::dvec3 off(0.03, -0.02, 0.01);  // the guess is not the answer
    const auto point = surface->meet({p + 2.0 * n + off, -n - off / 2.0}, 1.999);
    if (!point) continue;
    met += glm::distance(point->position, p) < 1e-6 && glm::dot(point->normal, n) > 1 - 1e-5;
  }
  EXPECT_GE(met, least_share * double(mesh.positions.size() / 3)) << shape;
}

TEST(AnalyticSurface, HoldsTheVerticesOfItsMesh) {
  expect_vertices_on_surface("sphere:12", 1);
  expect_vertices_on_surface("torus:12", 1);
  expect_vertices_on_surface("teapot:5", 0.9);
}

TEST(AnalyticSurface, RaysThatPassByMeetNothing) {
  for (const char* shape : {"sphere", "torus", "teapot"})
    EXPECT_FALSE(analytic_surface(shape)->meet({{3, 0, 3}, {0, 0, -1}}, 3)) << shape;
  EXPECT_FALSE(analytic_surface("cube:3"));
  EXPECT_THROW(
      render_analytic(scene_of({object_of(triangle_soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}))}),
                      Camera{}, 8, 8),
      Error);
}

/// Largest error against the true surface, away from silhouettes, in linear radiance.
double error_of(const std::string& shape, int n, Shading shading) {
  const auto scene_with = [&](int tessellation) {
    Object object =
        object_of(std::make_shared<Mesh>(make_shape(shape + ":" + std::to_string(tessellation))));
    object.material.model = models::make("blinn-phong:kd=.6,ks=.4,n=10").model;
    object.world_from_object = glm::rotate(glm::mat4(1), 0.5f, {1, 0.3f, 0});
    object.sides = Sides::automatic;
    object.shading = shading;
    Scene scene = scene_of({object});
    scene.lights[0].direction = {-1, 1, 2};
    return scene;
  };
  const Camera camera{.eye = {0, 0.4, 4}, .fov_deg = 32};
  const ExactPicture truth = render_analytic(scene_with(48), camera, 96, 72);
  const ExactPicture mesh = render_reference(scene_with(n), camera, 96, 72);
  const PictureError error = compare(truth, mesh, Encoding::srgb, silhouettes(truth, mesh, camera));
  EXPECT_GT(error.interior.pixels, 700) << shape;
  return error.interior.rms_linear;
}

// Twice as fine, flat shading is half as wrong, Gouraud and Phong a quarter.
TEST(RenderAnalytic, MeshesConvergeToIt) {
  for (const char* shape : {"sphere", "torus", "teapot"}) {
    const int coarse = std::string(shape) == "teapot" ? 8 : 14;
    const auto gain = [&](Shading shading) {
      return error_of(shape, coarse, shading) / error_of(shape, 2 * coarse, shading);
    };
    EXPECT_NEAR(gain(Shading::flat), 2, 0.5) << shape;
    EXPECT_NEAR(gain(Shading::gouraud), 4, 1.2) << shape;
    EXPECT_NEAR(gain(Shading::phong), 4, 1.2) << shape;
    EXPECT_LT(error_of(shape, coarse, Shading::phong), error_of(shape, coarse, Shading::gouraud));
  }
}

}  // namespace
}  // namespace scanlit::test
