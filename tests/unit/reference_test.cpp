// The reference renderer, by hand.
#include "rasterizer/reference/reference.h"

#include <glm/gtc/matrix_transform.hpp>

#include "models/registry.h"
#include "rasterizer/reference/surface_light.h"
#include "tests/unit/test_scene.h"

namespace scanlit::test {
namespace {

// Corners (0,0), (4,0), (0,4) on the screen of 4 x 4 pixels; the hypotenuse passes through the
// centres with x + y = 3, which lie on a lower right edge and belong to nobody.
TEST(Reference, SeesATriangleByHand) {
  const Scene scene = scene_of(
      {object_of(triangle_soup(on_screen({{0, 0, .5f}, {0, 4, .5f}, {4, 0, .5f}})), ShowPoint{})});
  const ExactPicture picture = render_reference(scene, pixel_camera(4, 4), 4, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      const std::size_t i = std::size_t(4 * y + x);
      const bool covered = x + y < 3;
      EXPECT_EQ(picture.triangle[i], covered ? 0u : no_id) << x << ' ' << y;
      EXPECT_EQ(picture.distance[i], covered ? 1.5 : 0);
      if (!covered) continue;
      // The object position in the pixel's centre, as a colour.
      EXPECT_NEAR(picture.colour[i].r, x + 0.5, 1e-14);
      EXPECT_NEAR(picture.colour[i].g, -(y + 0.5), 1e-14);
    }
}

// Two triangles of a square, both cut through by the same diagonal of pixel centres.
TEST(Reference, SharedEdgesBelongToOneTriangle) {
  const Scene scene = scene_of({object_of(triangle_soup(
      on_screen({{0, 0, .5f}, {0, 4, .5f}, {4, 0, .5f}, {4, 0, .5f}, {0, 4, .5f}, {4, 4, .5f}})))});
  const ExactPicture picture = render_reference(scene, pixel_camera(4, 4), 4, 4);
  for (int i = 0; i < 16; ++i)
    EXPECT_EQ(picture.triangle[std::size_t(i)], i % 4 + i / 4 < 3 ? 0u : 1u);
}

TEST(Reference, InterpolatesInPerspective) {
  // A floor from (-1,-1,-1) to the horizon: at the screen's row y the ray meets it at
  // z = -1 / tan, whatever the triangles.
  const Scene scene =
      scene_of({object_of(triangle_soup({{-9, -1, 1}, {9, -1, 1}, {0, -1, -50}}), ShowPoint{})});
  const int size = 32;
  const ExactPicture picture = render_reference(scene, eye_at_origin(), size, size);
  int seen = 0;
  for (int y = size / 2 + 2; y < size; ++y) {
    const std::size_t i = std::size_t(y * size + size / 2);
    if (picture.object[i] == no_id) continue;
    const double z = -1 / (2 * (y + 0.5) / size - 1);
    EXPECT_NEAR(picture.colour[i].b, z, 0.02 * z * z / size);  // snapped to 1/256 pixel
    EXPECT_NEAR(picture.distance[i], -z, 0.02 * z * z / size);
    ++seen;
  }
  EXPECT_GT(seen, 10);
}

TEST(Reference, NearestStaysAndOfEqualOnesTheFirst) {
  const auto triangle = [](float z) {
    return std::vector<glm::vec3>{{0, 0, z}, {0, -4, z}, {4, 0, z}};
  };
  const auto with = [&](float z) { return object_of(triangle_soup(triangle(z))); };
  const Scene scene = scene_of({with(0.25f), with(0.5f), with(0.5f), with(0)});
  const ExactPicture picture = render_reference(scene, pixel_camera(4, 4), 4, 4);
  EXPECT_EQ(picture.object[0], 1u);
}

/// One light on a point of a surface z = 0 that reflects N.L, seen from above.
double lit(const Light& light, const glm::dvec3& at) {
  Scene scene =
      scene_of({object_of(triangle_soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), CosineOnly{})});
  scene.lights = {light};
  return radiance_in_double(scene, Camera{}, scene.objects[0],
                            {.position = at, .normal = {0, 0, 2}})
      .r;
}

TEST(SurfaceLight, LightsByHand) {
  Light far;
  far.intensity = 2, far.direction = {0, 3, 4};
  EXPECT_DOUBLE_EQ(lit(far, {0, 0, 0}), 2 * 0.8);
  Light point;
  point.kind = LightKind::point, point.position = {3, 0, 4};
  point.constant = 1, point.linear = 0.2, point.quadratic = 0.04;
  EXPECT_DOUBLE_EQ(lit(point, {0, 0, 0}), 0.8 / (1 + 1 + 1));
  Light spot;
  spot.kind = LightKind::spot, spot.position = {0, 0, 1}, spot.direction = {0, 0, -1};
  spot.inner_deg = 30, spot.outer_deg = 60;
  EXPECT_DOUBLE_EQ(lit(spot, {0, 0, 0}), 1);
  EXPECT_EQ(lit(spot, {2, 0, 0}), 0);
  // At 45 degrees, between the cosines of 30 and 60.
  const double c = std::sqrt(0.5), t = (c - 0.5) / (std::sqrt(0.75) - 0.5);
  EXPECT_NEAR(lit(spot, {1, 0, 0}), c * t * t * (3 - 2 * t), 1e-15);
  EXPECT_EQ(lit({.direction = {0, 0, -1}}, {0, 0, 0}), 0);
}

TEST(SurfaceLight, AmbientAndColourForms) {
  Scene scene = scene_of({object_of(triangle_soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}))});
  Material& material = scene.objects[0].material;
  material.model = models::make("blinn-phong:kd=.5,ks=.25,n=20").model;
  material.ka = Rgb<double>(0.1), material.ambient_share = 0.2;
  scene.ambient = {0.3, 0.6, 0.9};
  scene.lights[0].colour = {1, 0.5, 0.25};  // along the normal, as the viewer
  const auto radiance = [&] {
    return radiance_in_double(scene, {.viewer_at_infinity = true}, scene.objects[0],
                              {.position = {0, 0, 0}, .normal = {0, 0, 1}});
  };
  const Rgb<double> tinted = radiance();
  EXPECT_NEAR(tinted.g, (0.1 + 0.5 * 0.2) * 0.6 + (0.5 + 0.25) * 0.5, 1e-15);
  material.form = ColourForm::plastic, material.object_colour = {0.9, 0.8, 0.7};
  EXPECT_NEAR(radiance().g, (0.1 + 0.5 * 0.2) * 0.8 * 0.6 + 0.5 * 0.8 + 0.25 * 0.5, 1e-15);
}

// A normal is carried by the inverse transpose, and a mirrored one still points outwards.
TEST(SurfaceLight, NormalsOfStretchedAndMirroredObjects) {
  Object object;
  object.world_from_object = glm::scale(glm::mat4(1), {-2, 1, 4});
  const glm::dvec3 n = world_normal(object, {.position = {}, .normal = {1, 1, 1}}, {});
  EXPECT_NEAR(glm::length(n - glm::normalize(glm::dvec3(-0.5, 1, 0.25))), 0, 1e-15);
}

}  // namespace
}  // namespace scanlit::test
