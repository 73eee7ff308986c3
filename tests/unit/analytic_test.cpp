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

/// What meshes of a shape make of its surface.
class Tessellations {
 public:
  explicit Tessellations(std::string shape)
      : shape_(std::move(shape)),
        truth_(render_analytic(scene(48, Shading::phong), camera, w, h)) {}

  /// Root mean square of linear radiance, away from silhouettes.
  double error(int n, Shading shading) const {
    const ExactPicture mesh = render_reference(scene(n, shading), camera, w, h);
    const auto edges = silhouettes(truth_, mesh, camera);
    const PictureError error = compare(truth_, mesh, Encoding::srgb, edges);
    EXPECT_GT(error.interior.pixels, 700) << shape_;
    return error.interior.rms_linear;
  }

 private:
  static constexpr int w = 96, h = 72;
  static inline const Camera camera{.eye = {0, 0.4, 4}, .fov_deg = 32};

  Scene scene(int n, Shading shading) const {
    Object object;
    object.mesh = std::make_shared<Mesh>(make_shape(shape_ + ":" + std::to_string(n)));
    object.material.model = models::make("blinn-phong:kd=.6,ks=.4,n=10").model;
    object.world_from_object = glm::rotate(glm::mat4(1), 0.5f, {1, 0.3f, 0});
    object.shading = shading;
    Scene result = scene_of({object});
    result.lights[0].direction = {-1, 1, 2};
    return result;
  }

  std::string shape_;
  ExactPicture truth_;
};

// Twice as fine, flat shading is half as wrong, Gouraud and Phong a quarter.
TEST(RenderAnalytic, MeshesConvergeToIt) {
  for (const char* shape : {"sphere", "torus", "teapot"}) {
    const int n = std::string(shape) == "teapot" ? 8 : 14;
    const Tessellations meshes(shape);
    double coarse[3], fine[3];
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
      coarse[int(shading)] = meshes.error(n, shading);
      fine[int(shading)] = meshes.error(2 * n, shading);
    }
    EXPECT_NEAR(coarse[0] / fine[0], 2, 0.5) << shape;
    EXPECT_NEAR(coarse[1] / fine[1], 4, 1.5) << shape;
    EXPECT_NEAR(coarse[2] / fine[2], 4, 1.5) << shape;
    EXPECT_LT(coarse[2], coarse[1]) << shape;
    EXPECT_LT(coarse[1], coarse[0]) << shape;
  }
}

}  // namespace
}  // namespace scanlit::test
