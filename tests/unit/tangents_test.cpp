// (9) Tangent fields: each points where it says, on every surface and under every transform, and
// is a unit vector in the surface where it has nowhere to point.
#include "rasterizer/tangents.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/error.h"
#include "tests/unit/tangent_checks.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

const glm::mat4 identity(1);

struct SurfacePointAt {
  glm::vec3 position, normal;  // object and world space
  glm::vec3 mesh_tangent{0};
};

/// The tangents that place_tangents() gives to points of an object.
std::vector<glm::vec3> tangents_of(const std::vector<SurfacePointAt>& points,
                                   const Tangents& tangents, const glm::mat4& world_from_object,
                                   const Mesh& mesh = {}) {
  Object object;
  object.world_from_object = world_from_object;
  object.material.tangents = tangents;
  Draw draw{};
  draw.object = &object;
  draw.mesh = &mesh;
  SurfaceSpan surface;
  surface.size = int(points.size());
  for (int i = 0; i < surface.size; ++i)
    for (int c = 0; c < 3; ++c) {
      const SurfacePointAt& p = points[std::size_t(i)];
      surface.position[c][i] = p.position[c];
      surface.normal[c][i] = p.normal[c];
      surface.tangent[c][i] = p.mesh_tangent[c];
    }
  place_tangents(draw, surface);
  std::vector<glm::vec3> result;
  for (int i = 0; i < surface.size; ++i)
    result.emplace_back(surface.tangent[0][i], surface.tangent[1][i], surface.tangent[2][i]);
  return result;
}

glm::vec3 tangent_of(const glm::vec3& position, const glm::vec3& normal, const Tangents& tangents,
                     const glm::mat4& world_from_object = identity) {
  return tangents_of({{position, normal}}, tangents, world_from_object)[0];
}

const Tangents around_y{};
const Tangents along_x{.field = TangentField::along, .axis = {1, 0, 0}};

// --------------------------------------------------------------------------------- each field

TEST(Tangents, AroundFollowsTheParallelsOfASphere) {
  for (int i = 0; i < 64; ++i)
    for (int j = 1; j < 32; ++j) {
      const double phi = 2 * M_PI * i / 64, theta = M_PI * j / 32;
      const glm::vec3 p(std::sin(theta) * std::cos(phi), std::cos(theta),
                        std::sin(theta) * std::sin(phi));
      // y x p.
      expect_vector(tangent_of(p, p, around_y), {std::sin(phi), 0, -std::cos(phi)});
    }
}

TEST(Tangents, AroundBrushesAFlatDiscInCircles) {
  const glm::vec3 centre(0.3f, 5, -0.7f);
  const Tangents lathe{.axis = {0, 3, 0}, .centre = centre};
  for (const double radius : {1e-5, 0.1, 1.0, 100.0})
    for (int i = 0; i < 64; ++i) {
      const double phi = 2 * M_PI * i / 64;
      const glm::vec3 offset(radius * std::cos(phi), 0, radius * std::sin(phi));
      const glm::vec3 t = tangent_of(centre + offset, {0, 1, 0}, lathe);
      // As well as float knows where the point is.
      expect_vector(t, {std::sin(phi), 0, -std::cos(phi)}, radius < 1e-4 ? 1e-2f : 1e-5f);
    }
}

TEST(Tangents, AroundIsTurnedWithItsAxis) {
  const Tangents around_z{.axis = {0, 0, -2}};
  expect_vector(tangent_of({1, 0, 0}, {1, 0, 0}, around_z), {0, -1, 0});
  expect_vector(tangent_of({0, 1, 7}, {0, 0, 1}, around_z), {1, 0, 0});
}

TEST(Tangents, AlongIsTheAxisInTheSurface) {
  expect_vector(tangent_of({5, 5, 5}, {0, 0, 1}, along_x), {1, 0, 0});
  expect_vector(tangent_of({5, 5, 5}, {0.6f, 0, 0.8f}, along_x), {0.8f, 0, -0.6f});
}

TEST(Tangents, TexcoordFollowsTheMesh) {
  Mesh mesh;
  mesh.tangents.resize(1);
  const Tangents texcoord{.field = TangentField::texcoord};
  const std::vector<SurfacePointAt> points = {{{1, 2, 3}, {0, 0, 1}, {0.3f, 0.4f, 0.5f}},
                                              {{1, 2, 3}, {0, 1, 0}, {1e-20f, 0, 0}}};
  const auto t = tangents_of(points, texcoord, identity, mesh);
  expect_vector(t[0], {0.6f, 0.8f, 0});
  expect_vector(t[1], {1, 0, 0});
  // A mesh without texture coordinates: as `around`.
  expect_vector(tangents_of(points, texcoord, identity)[0],
                tangents_of(points, around_y, identity)[0]);
}

// -------------------------------------------------------------------------- where it has none

TEST(Tangents, PolesTakeAnotherDirection) {
  for (const float y : {1.0f, -1.0f}) {
    const glm::vec3 t = tangent_of({0, y, 0}, {0, y, 0}, around_y);
    EXPECT_TRUE(lies_in_surface(t, {0, 1, 0}));
    EXPECT_EQ(t, tangent_of({0, y, 0}, {0, y, 0}, around_y));
  }
}

TEST(Tangents, APlaneThroughTheAxisIsBrushedStraight) {
  // The circles leave it at right angles: one direction everywhere, not what rounding leaves.
  for (const glm::vec3& normal :
       {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::normalize(glm::vec3(1, 0, 1)),
        glm::normalize(glm::vec3(-0.3f, 0, 1))}) {
    const glm::vec3 across = glm::cross(normal, glm::vec3(0, 1, 0));
    const glm::vec3 first = tangent_of(across, normal, around_y);
    EXPECT_TRUE(lies_in_surface(first, normal));
    for (const float x : {-1.0f, -0.37f, 0.0f, 0.1f, 17.3f})
      for (const float y : {-2.0f, 0.0f, 0.77f})
        expect_vector(tangent_of(x * across + glm::vec3(0, y, 0), normal, around_y), first, 1e-4f);
  }
}

TEST(Tangents, AFaceAcrossTheAxisOfAlongIsBrushedStraightAlsoWhenTurned) {
  for (const float angle : {0.0f, 0.3f, 1.2f, 2.9f}) {
    const glm::mat4 turned = glm::rotate(identity, angle, glm::vec3(0.5f, 1, 0.2f));
    const glm::vec3 normal = glm::mat3(turned) * glm::vec3(1, 0, 0);
    const glm::vec3 first = tangent_of({0, 0, 0}, normal, along_x, turned);
    // It turns with the object.
    expect_vector(first, glm::mat3(turned) * tangent_of({0, 0, 0}, {1, 0, 0}, along_x));
    std::mt19937_64 random(1);
    std::uniform_real_distribution<float> rounding(-2e-7f, 2e-7f);
    for (int i = 0; i < 100; ++i) {
      const glm::vec3 noise(rounding(random), rounding(random), rounding(random));
      expect_vector(tangent_of({0, 0, 0}, glm::normalize(normal + noise), along_x, turned), first);
    }
  }
}

TEST(Tangents, AnObjectFlattenedToTheNormalsLineHasSome) {
  // Wherever the tangents point in the object, they point along the normal in the world.
  for (const glm::vec3& normal : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(0.6f, 0, 0.8f),
                                  glm::vec3(0.6f, 0, -0.8f), glm::vec3(0.48f, 0.6f, -0.64f)}) {
    glm::mat4 line(0);
    line[0] = glm::vec4(normal, 0), line[1] = 2.0f * line[0], line[2] = -line[0];
    line[3][3] = 1;
    EXPECT_TRUE(lies_in_surface(tangent_of({1, 2, 3}, normal, around_y, line), normal));
  }
}

// -------------------------------------------------------------------------------- transforms

TEST(Tangents, FollowTheSurfaceUnderUnevenScale) {
  // The surface z = 3/4 x, brushed along x, stretched twice in x: z = 3/8 x. The inverse transpose
  // would turn the brush out of it.
  const glm::mat4 stretched = glm::scale(identity, glm::vec3(2, 1, 1));
  const glm::vec3 normal = glm::normalize(glm::vec3(-3, 0, 8));
  expect_vector(tangent_of({0, 0, 0}, normal, along_x, stretched),
                glm::normalize(glm::vec3(8, 0, 3)));
  // Parallels of an ellipsoid are ellipses.
  const glm::vec3 p = glm::normalize(glm::vec3(1, 0.5f, 1));
  const glm::vec3 n = glm::normalize(glm::vec3(p.x / 2, p.y, p.z));
  expect_vector(tangent_of(p, n, around_y, stretched), glm::normalize(glm::vec3(2 * p.z, 0, -p.x)));
}

TEST(Tangents, DoNotDependOnScaleAndPlace) {
  const glm::vec3 p = glm::normalize(glm::vec3(1, 2, -3));
  const glm::vec3 expected = tangent_of(p, p, around_y);
  for (const float scale : {1e-30f, 1e-18f, 1e-3f, 1e3f, 1e18f, 1e30f}) {
    expect_vector(tangent_of(p, p, around_y, glm::scale(identity, glm::vec3(scale))), expected);
    // And so for meshes of any size.
    expect_vector(tangent_of(p * scale, p, around_y), expected);
  }
  expect_vector(tangent_of(p, p, around_y, glm::translate(identity, {1000, -70, 3})), expected);
}

TEST(Tangents, AreMirroredWithTheObject) {
  const glm::mat4 mirrored = glm::scale(identity, glm::vec3(-1, 1, 1));
  const glm::vec3 p = glm::normalize(glm::vec3(1, 2, -3)), image(-p.x, p.y, p.z);
  const glm::vec3 t = tangent_of(p, p, around_y);
  expect_vector(tangent_of(p, image, around_y, mirrored), {-t.x, t.y, t.z});
  // On a back face the normal turns and the tangent stays.
  expect_vector(tangent_of(p, -p, around_y), t);
}

TEST(Tangents, AreUnitAndInTheSurfaceWhateverTheInput) {
  EXPECT_TRUE(holds(300, [] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    std::normal_distribution<float> normal;
    const auto vector = [&] { return glm::vec3(normal(random), normal(random), normal(random)); };
    const auto size = [&] {
      return std::pow(10.0f, std::uniform_real_distribution<float>(-25, 25)(random));
    };
    glm::mat4 m(glm::mat3(vector(), vector(), vector()));
    const int kind = *rc::gen::inRange(0, 6);
    if (kind == 1) m[0] = m[1];                                  // flat
    if (kind == 2) m[0] = m[1] = glm::vec4(0);                   // a line
    if (kind == 3) m = glm::mat4(0), m[3][3] = 1;                // a point
    if (kind == 4) m = glm::scale(m, {size(), size(), size()});  // a needle, perhaps mirrored
    const Tangents tangents{.field = *rc::gen::element(TangentField::around, TangentField::along,
                                                       TangentField::texcoord),
                            .axis = vector(),
                            .centre = *rc::gen::element(glm::vec3(0), vector() * size())};
    Mesh mesh;
    mesh.tangents.resize(1);
    std::vector<SurfacePointAt> points;
    for (int i = 0; i < 50; ++i) {
      points.push_back({vector(), glm::normalize(vector()), vector()});
      SurfacePointAt& p = points.back();
      switch (i % 8) {
        case 0: p.normal = glm::normalize(tangents.axis); break;
        case 1: p.position = tangents.centre + tangents.axis; break;
        case 2: p.position = tangents.centre; break;
        case 3: p.mesh_tangent = p.normal; break;
        case 4: p.mesh_tangent = glm::vec3(0); break;
        case 5: p.normal = glm::normalize(p.normal * 1e-4f + glm::vec3(0, 0, -1)); break;
        case 6: p.position *= size(); break;
        default: break;
      }
    }
    const auto t = tangents_of(points, tangents, m, mesh);
    for (std::size_t i = 0; i < t.size(); ++i) RC_ASSERT(lies_in_surface(t[i], points[i].normal));
  }));
}

// ---------------------------------------------------------------------------------- bad input

TEST(Tangents, ABadAxisOrCentreIsAnError) {
  const auto error_of = [](const Tangents& tangents) -> std::string {
    Object object = object_of(triangle_soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    object.material.tangents = tangents;
    try {
      validate(scene_of({object}));
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(error_of({}), "no error");
  EXPECT_NE(error_of({.axis = {0, 0, 0}}).find("object 0: the tangents' axis"), std::string::npos);
  EXPECT_NE(error_of({.axis = {0, NAN, 0}}).find("axis"), std::string::npos);
  EXPECT_NE(error_of({.centre = {0, INFINITY, 0}}).find("centre"), std::string::npos);
}

}  // namespace
}  // namespace scanlit
