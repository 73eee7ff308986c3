// (9) Tangent fields: each points where it says, on every surface and under every transform, and
// is a unit vector in the surface where it has nowhere to point.
#include "rasterizer/tangents.h"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/error.h"
#include "rasterizer/shapes.h"
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

void expect_vector(const glm::vec3& actual, const glm::vec3& expected, float tolerance = 1e-6f) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance) << "component " << c;
}

bool lies_in_surface(const glm::vec3& tangent, const glm::vec3& normal) {
  return std::abs(glm::length(glm::dvec3(tangent)) - 1) <= 1e-6 &&
         std::abs(glm::dot(glm::dvec3(tangent), glm::dvec3(normal))) <= 1e-6;
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

// --------------------------------------------------------------- the mesh's own, from texcoords

void expect_unit_or_zero(const Mesh& mesh) {
  ASSERT_EQ(mesh.tangents.size(), mesh.positions.size()) << mesh.name;
  for (std::size_t v = 0; v < mesh.tangents.size(); ++v)
    if (mesh.tangents[v] != glm::vec3(0)) {
      ASSERT_TRUE(lies_in_surface(mesh.tangents[v], mesh.normals[v])) << mesh.name << ' ' << v;
    }
}

TEST(MeshTangents, OfShapesFollowTheirSurfaces) {
  for (const ShapeInfo& shape : shapes()) {
    const Mesh mesh = make_shape(shape.name);
    expect_unit_or_zero(mesh);
    std::size_t none = 0;
    for (const glm::vec3& t : mesh.tangents) none += t == glm::vec3(0);
    EXPECT_EQ(none, 0u) << shape.name;
  }
  // u grows with longitude, right up to the poles.
  const int stacks = 32;
  const Mesh sphere = make_shape("sphere:" + std::to_string(stacks));
  for (std::size_t v = 0; v < sphere.tangents.size(); ++v) {
    const glm::vec3& p = sphere.positions[v];
    if (std::abs(p.y) > 0.999f) continue;
    const bool seam = std::abs(sphere.texcoords[v].x - 0.5f) > 0.499f;
    expect_vector(sphere.tangents[v], glm::normalize(glm::cross(glm::vec3(0, 1, 0), p)),
                  seam ? float(M_PI / (2 * stacks)) : 2e-3f);
  }
}

TEST(MeshTangents, PlaneTurnsWithItsTexcoords) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  struct Case {
    std::string texcoords;
    glm::vec3 expected;
  };
  const float d = std::sqrt(0.5f);
  for (const Case& c : {Case{"vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n", {1, 0, 0}},
                        Case{"vt 1 0\nvt 0 0\nvt 0 1\nvt 1 1\n", {-1, 0, 0}},  // mirrored
                        Case{"vt 0 0\nvt 0 1\nvt 7 1\nvt 7 0\n", {0, 1, 0}},
                        Case{"vt 0 0\nvt .5 -.5\nvt 1 0\nvt .5 .5\n", {d, d, 0}},
                        Case{"vt .5 0\nvt .5 1\nvt .5 1\nvt .5 0\n", {0, 0, 0}},    // constant u
                        Case{"vt 0 0\nvt .1 .1\nvt .2 .2\nvt .3 .3\n", {0, 0, 0}},  // on a line
                        Case{"vt 3 3\nvt 3 3\nvt 3 3\nvt 3 3\n", {0, 0, 0}}}) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) /
                                       ("tangents-" + std::to_string(getpid()) + ".obj");
    std::ofstream(file) << square << c.texcoords << "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
    const Mesh mesh = load_mesh(file);
    std::filesystem::remove(file);
    expect_unit_or_zero(mesh);
    for (const glm::vec3& t : mesh.tangents) expect_vector(t, c.expected);
  }
}

TEST(MeshTangents, AreThereOnlyWhereTexcoordsAre) {
  EXPECT_TRUE(make_mesh("t", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}).tangents.empty());
}

// ------------------------------------------------------------------------------- in a picture

/// Shows the tangent's world coordinates, which are dot products of the frame with fixed l and v.
class ShowTangent : public ReflectionModel {
 public:
  Needs needs() const override { return {.frame = true}; }
  void evaluate(const DirectionSpan& in, const ReflectionSpan& out) const override {
    for (int c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < in.size; ++i) {
        out.diffuse[c][i] = in.tangent[c][i];
        out.glossy[c][i] = in.normal[c][i];
      }
  }
  Reflection<double> evaluate(const Vec3<double>&, const Vec3<double>&,
                              const SurfacePoint<double>&) const override {
    return {};
  }
  Reflection<float> evaluate(const Vec3<float>&, const Vec3<float>&,
                             const SurfacePoint<float>&) const override {
    return {};
  }
};

Picture tangents_in_picture(const std::string& shape, const Tangents& tangents, Shading shading,
                            const RenderSettings& settings = {}) {
  Object object = object_of(std::make_shared<Mesh>(make_shape(shape)), White(), shading);
  object.material.model = std::make_shared<ShowTangent>();
  object.material.tangents = tangents;
  object.world_from_object = glm::rotate(identity, 0.9f, glm::vec3(1, 0.3f, 0));
  return picture_of(scene_of({object}), Camera(), 96, 96, settings);
}

TEST(TangentPictures, AreUnitAndInTheSurfaceAtEveryFragment) {
  for (const char* shape : {"sphere:8", "cylinder:12", "cone:12", "cube", "plane", "torus:9"})
    for (const TangentField field :
         {TangentField::around, TangentField::along, TangentField::texcoord})
      for (const Shading shading : {Shading::phong, Shading::flat}) {
        const Picture picture = tangents_in_picture(shape, {.field = field}, shading);
        ASSERT_GT(picture.stats.covered_pixels, 500);
        const Framebuffer& f = picture.framebuffer;
        for (std::size_t i = 0; i < f.pixel_count(); ++i) {
          if (f.colour[4 * i + 3] == 0) continue;
          const glm::vec3 t(f.diffuse[3 * i], f.diffuse[3 * i + 1], f.diffuse[3 * i + 2]);
          const glm::vec3 n(f.glossy[3 * i], f.glossy[3 * i + 1], f.glossy[3 * i + 2]);
          ASSERT_TRUE(lies_in_surface(t, n)) << shape << ' ' << int(field) << ' ' << int(shading);
        }
      }
}

TEST(TangentPictures, ByTexcoordAndAroundAgreeOnASphere) {
  const Picture by_position = tangents_in_picture("sphere:64", around_y, Shading::phong);
  const Picture by_texcoord =
      tangents_in_picture("sphere:64", {.field = TangentField::texcoord}, Shading::phong);
  int compared = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) {
      if (by_position.triangle(x, y) == no_id) continue;
      const float *p = &by_position.framebuffer.diffuse[3 * by_position.index(x, y)],
                  *q = &by_texcoord.framebuffer.diffuse[3 * by_texcoord.index(x, y)];
      compared += p[0] * q[0] + p[1] * q[1] + p[2] * q[2] > 0.99f;
    }
  // Apart from the triangles at the poles, over which u is not linear.
  EXPECT_GT(compared, 0.98 * double(by_position.stats.covered_pixels));
}

TEST(TangentPictures, DoNotDependOnThreads) {
  RenderSettings one, four;
  one.threads = 1, four.threads = 4;
  for (const TangentField field :
       {TangentField::around, TangentField::along, TangentField::texcoord}) {
    const Tangents tangents{.field = field, .axis = {0.3f, 1, 0}, .centre = {0.1f, 0, 0}};
    EXPECT_EQ(
        tangents_in_picture("cylinder:40", tangents, Shading::phong, one).framebuffer.diffuse,
        tangents_in_picture("cylinder:40", tangents, Shading::phong, four).framebuffer.diffuse);
  }
}

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
