// (9) The surface that shading sees: normals under transforms, on both sides, of no length; and
// that the parts of a colour add up to it. In all three shadings.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "models/blinn_phong.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

constexpr int size = 16;

class Surface : public testing::TestWithParam<Shading> {
 protected:
  /// A square of two triangles in the plane z = slope x, counter-clockwise seen from +z, its
  /// normals to that side; under `world_from_object`, seen from +z or, turned round, from -z.
  Object square(const glm::mat4& world_from_object, float slope = 0, Sides sides = Sides::both) {
    const float z = 3 * slope;
    auto mesh = triangle_soup({{-3, -3, -z}, {3, -3, z}, {3, 3, z}, {-3, 3, -z}});
    mesh->indices = {0, 1, 2, 0, 2, 3};
    mesh->normals.assign(4, glm::normalize(glm::vec3(-slope, 0, 1)));
    Object object = object_of(mesh, CosineOnly(), GetParam());
    object.world_from_object = world_from_object;
    object.sides = sides;
    return object;
  }

  Picture draw(const Object& object, const glm::dvec3& light = {0, 0, 1}) {
    Scene scene = scene_of({object});
    scene.lights[0].direction = light;
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.eye = {0, 0, 50};
    camera.near = 1, camera.far = 100;
    return picture_of(scene, camera, size, size);
  }

  static glm::vec3 normal_in_the_middle(const Picture& picture) {
    const float* n = &picture.framebuffer.normal[3 * picture.index(size / 2, size / 2)];
    return {n[0], n[1], n[2]};
  }
  static float in_the_middle(const Picture& picture) {
    return picture.colour(size / 2, size / 2)[0];
  }
};
INSTANTIATE_TEST_SUITE_P(Shadings, Surface,
                         testing::Values(Shading::flat, Shading::gouraud, Shading::phong));

void expect_vector(const glm::vec3& actual, const glm::vec3& expected) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], 1e-6) << "component " << c;
}

const glm::mat4 identity(1);

TEST_P(Surface, FrontFacesAreLitByTheirNormal) {
  const glm::dvec3 light(0.6, 0, 0.8);
  const Picture picture = draw(square(identity), light);
  EXPECT_NEAR(in_the_middle(picture), 0.8, 1e-6);
  expect_vector(normal_in_the_middle(picture), {0, 0, 1});
  EXPECT_EQ(in_the_middle(draw(square(identity), {0, 0.6, -0.8})), 0.0f);
}

TEST_P(Surface, BackFacesAreFlippedToTheViewer) {
  const glm::mat4 turned = glm::rotate(identity, 3.14159265f, glm::vec3(0, 1, 0));
  const Picture picture = draw(square(turned), {0.6, 0, 0.8});
  EXPECT_NEAR(in_the_middle(picture), 0.8, 1e-6);
  expect_vector(normal_in_the_middle(picture), {0, 0, 1});
}

TEST_P(Surface, BackFacesAreDroppedWhereOnlyFrontsAreDrawn) {
  const glm::mat4 turned = glm::rotate(identity, 3.14159265f, glm::vec3(0, 1, 0));
  const Picture picture = draw(square(turned, 0, Sides::front));
  EXPECT_EQ(picture.stats.covered_pixels, 0);
  EXPECT_EQ(picture.stats.back_facing, 2);
  EXPECT_EQ(picture.stats.evaluations, 0);
  EXPECT_EQ(draw(square(identity, 0, Sides::front)).stats.covered_pixels, size * size);
}

TEST_P(Surface, AutomaticSidesFollowWhetherTheMeshIsClosed) {
  const glm::mat4 turned = glm::rotate(identity, 3.14159265f, glm::vec3(0, 1, 0));
  Object object = square(turned, 0, Sides::automatic);
  EXPECT_EQ(draw(object).stats.covered_pixels, size * size);
  auto closed = std::make_shared<Mesh>(*object.mesh);
  closed->closed = true;
  object.mesh = closed;
  EXPECT_EQ(draw(object).stats.covered_pixels, 0);
}

TEST_P(Surface, MirroringKeepsFrontsInFront) {
  for (const glm::vec3& scale : {glm::vec3(-1, 1, 1), glm::vec3(1, -2, 1), glm::vec3(-1, -1, 1)}) {
    const Picture picture = draw(square(glm::scale(identity, scale), 0.75f, Sides::front));
    EXPECT_EQ(picture.stats.covered_pixels, size * size);
    // The plane z = 3/4 x, mirrored in x, is z = -3/4 x.
    expect_vector(normal_in_the_middle(picture), {scale.x < 0 ? 0.6f : -0.6f, 0, 0.8f});
    EXPECT_NEAR(in_the_middle(picture), 0.8, 1e-6);
  }
  // Mirrored in depth the square shows its back.
  const glm::mat4 in_depth = glm::scale(identity, glm::vec3(1, 1, -1));
  EXPECT_EQ(draw(square(in_depth, 0.75f, Sides::front)).stats.back_facing, 2);
  expect_vector(normal_in_the_middle(draw(square(in_depth, 0.75f))), {0.6f, 0, 0.8f});
}

TEST_P(Surface, NormalsStayPerpendicularUnderUnevenScale) {
  // z = 3/4 x, stretched twice in x and by three halves in z: z = 9/16 x.
  const glm::mat4 stretched = glm::scale(identity, glm::vec3(2, 1, 1.5f));
  const glm::vec3 expected = glm::normalize(glm::vec3(-9.0f / 16, 0, 1));
  const Picture picture = draw(square(stretched, 0.75f));
  expect_vector(normal_in_the_middle(picture), expected);
  EXPECT_NEAR(in_the_middle(picture), expected.z, 1e-6);
}

TEST_P(Surface, ScalesFromTinyToHugeLeaveNormalsUnit) {
  for (const float scale : {1e-3f, 1e-18f, 1e3f, 1e18f}) {
    // The mesh is as much smaller as the transform is larger.
    Object object = square(glm::scale(identity, glm::vec3(scale)), 0.75f);
    auto mesh = std::make_shared<Mesh>(*object.mesh);
    for (glm::vec3& p : mesh->positions) p /= scale;
    object.mesh = mesh;
    const Picture picture = draw(object);
    EXPECT_EQ(picture.stats.covered_pixels, size * size) << scale;
    expect_vector(normal_in_the_middle(picture), {-0.6f, 0, 0.8f});
    EXPECT_NEAR(in_the_middle(picture), 0.8, 1e-6) << scale;
  }
}

TEST_P(Surface, NormalsOfNoLengthFaceTheViewer) {
  Object object = square(identity);
  auto mesh = std::make_shared<Mesh>(*object.mesh);
  mesh->normals.assign(4, glm::vec3(0));
  object.mesh = mesh;
  EXPECT_NEAR(in_the_middle(draw(object, {0.6, 0, 0.8})), 0.8, 1e-6);
  // Neither have opposite ones a direction half-way.
  mesh = std::make_shared<Mesh>(*mesh);
  mesh->normals = {{0, 0, 1}, {0, 1, 0}, {0, 0, -1}, {0, -1, 0}};
  object.mesh = mesh;
  for (const float v : draw(object).framebuffer.colour) EXPECT_TRUE(std::isfinite(v));
}

TEST_P(Surface, FlattenedObjectsGiveNoNan) {
  for (const glm::vec3& scale : {glm::vec3(1, 1, 0), glm::vec3(1, 0, 0), glm::vec3(0)}) {
    const Picture picture = draw(square(glm::scale(identity, scale), 0.75f));
    for (const float v : picture.framebuffer.colour) EXPECT_TRUE(std::isfinite(v));
    for (const float v : picture.framebuffer.normal) EXPECT_TRUE(std::isfinite(v));
  }
}

TEST_P(Surface, PartsAddUpToTheColour) {
  Object object = square(identity, 0.5f);
  object.material.model =
      std::make_shared<FormulaModel<models::BlinnPhong<>>>(models::BlinnPhong<>());
  object.material.ka = {0.1, 0.2, 0.3};
  for (const ColourForm form : {ColourForm::tinted, ColourForm::plastic})
    for (const bool clamped : {false, true}) {
      object.material.form = form;
      object.material.object_colour = {0.9, 0.5, 0.1};
      Scene scene = scene_of({object});
      scene.ambient = Rgb<double>(0.7);
      scene.lights[0].direction = {-0.3, 0.2, 1};
      scene.lights[0].intensity = 1.7;
      RenderSettings settings = with_samples(4);
      settings.clamp_vertex_colours = clamped;
      const Picture picture = picture_of(scene, Camera(), size, size, settings);
      const Framebuffer& f = picture.framebuffer;
      float largest = 0;
      for (std::size_t i = 0; i < f.pixel_count(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
          const float sum = f.ambient[3 * i + c] + f.diffuse[3 * i + c] + f.glossy[3 * i + c];
          EXPECT_NEAR(f.colour[4 * i + c], sum, 1e-5);
          largest = std::max(largest, f.colour[4 * i + c]);
        }
      EXPECT_GT(largest, 0.3f);
      EXPECT_TRUE(!clamped || GetParam() != Shading::gouraud || largest <= 1 + 1e-6f) << largest;
    }
}

// ------------------------------------------------------------------------------- Phong alone

/// Reflects N.V, where it is lit.
struct CosineToViewer {
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    return {.diffuse = Rgb<T>(c.n_v), .glossy = {}};
  }
};

TEST(PhongNormals, AreInterpolatedAndThenNormalised) {
  auto mesh = triangle_soup({{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}});
  mesh->indices = {0, 1, 2, 0, 2, 3};
  const glm::vec3 left(-0.8f, 0, 0.6f), right(0.8f, 0, 0.6f);
  mesh->normals = {left, right, right, left};
  const Picture picture = picture_of(scene_of({object_of(mesh, CosineOnly())}), Camera(), 64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const float* n = &picture.framebuffer.normal[3 * picture.index(x, y)];
      EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-6);
      // The default camera sees x = +-4 tan(22.5 degrees) at z = 0.
      const double t = (2 * (x + 0.5) / 64 - 1) * std::tan(3.14159265358979 / 8);
      const glm::dvec3 expected = glm::normalize(glm::dvec3(0.8 * t, 0, 0.6));
      EXPECT_NEAR(n[0], expected.x, 1e-3);
      EXPECT_NEAR(picture.colour(x, y)[0], n[2], 1e-6);
    }
}

TEST(PhongNormals, AreFlippedWhereTheTriangleIsSeenFromBehind) {
  auto mesh = triangle_soup({{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}});
  mesh->indices = {0, 1, 2, 0, 2, 3};
  const glm::vec3 left(-0.8f, 0, 0.6f), right(0.8f, 0, 0.6f);
  mesh->normals = {left, right, right, left};
  Object object = object_of(mesh, CosineOnly());
  object.world_from_object = glm::rotate(identity, 3.14159265f, glm::vec3(0, 1, 0));
  const Picture picture = picture_of(scene_of({object}), Camera(), 64, 64);
  for (const int x : {8, 31, 50}) {
    const float* n = &picture.framebuffer.normal[3 * picture.index(x, 20)];
    const double t = (2 * (x + 0.5) / 64 - 1) * std::tan(3.14159265358979 / 8);
    const glm::dvec3 expected = glm::normalize(glm::dvec3(-0.8 * t, 0, 0.6));
    EXPECT_NEAR(n[0], expected.x, 1e-3);
    EXPECT_NEAR(n[2], expected.z, 1e-3);
  }
}

TEST(PhongNormals, TiltedAwayFromTheViewerCountAsJustVisible) {
  auto mesh = triangle_soup({{-4, -4, 0}, {4, -4, 0}, {0, 8, 0}});
  mesh->normals.assign(3, glm::normalize(glm::vec3(1, 0, -0.2f)));
  Scene scene = scene_of({object_of(mesh, CosineToViewer())});
  scene.lights[0].direction = {1, 0, 0};
  Camera camera;
  camera.viewer_at_infinity = true;
  const Picture picture = picture_of(scene, camera, 8, 8);
  for (std::size_t i = 0; i < picture.framebuffer.pixel_count(); ++i)
    EXPECT_EQ(picture.framebuffer.colour[4 * i], float(min_n_v));
}

struct SeesFrame {
  template <class T>
  Reflection<T> operator()(const Cosines<T>&, const ShadingFrame<T>& f) const {
    const T half(0.5);  // so that what is seen is not negative
    return {.diffuse = {half + half * f.v.x, half + half * f.v.y, half + half * f.v.z},
            .glossy = {}};
  }
};

TEST_P(Surface, AFlattenedObjectStillHasTangents) {
  // Along each axis in turn: the one that the tangents turn around, and the one that replaces it.
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 scale(1);
    scale[axis] = 0;
    Object object = square(glm::scale(identity, scale), 0.5f);
    object.material.model = std::make_shared<FormulaModel<SeesFrame>>(SeesFrame{});
    const Picture picture = draw(object, {0.3, 0.2, 1});
    for (const float channel : picture.framebuffer.colour) ASSERT_TRUE(std::isfinite(channel));
  }
}

}  // namespace
}  // namespace scanlit
