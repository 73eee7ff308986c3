// The tangents of a mesh, made from its texture coordinates when it is made or read.
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <string>

#include "rasterizer/mesh.h"
#include "rasterizer/shapes.h"
#include "tests/unit/tangent_checks.h"

namespace scanlit {
namespace {

using namespace test;

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

}  // namespace
}  // namespace scanlit
