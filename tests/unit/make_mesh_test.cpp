// Normals, creases, closedness and the cutting of polygons, on meshes made from lists.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "rasterizer/error.h"
#include "rasterizer/mesh.h"

namespace scanlit {
namespace {

TEST(MakeMesh, WeightsNormalsByAngleOrArea) {
  // At the origin a long triangle facing +z and a short one facing +x, both with a right angle.
  const std::vector<glm::vec3> points = {{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::vector<std::uint32_t>> faces = {{0, 1, 2}, {0, 2, 3}};
  const Mesh by_angle = make_mesh("m", points, faces);
  EXPECT_NEAR(by_angle.normals[0].x, by_angle.normals[0].z, 1e-6);
  const Mesh by_area = make_mesh("m", points, faces, {NormalWeight::area, {}});
  EXPECT_NEAR(by_area.normals[0].z, 3 * by_area.normals[0].x, 1e-6);
}

std::vector<glm::vec3> cube_points() {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  return points;
}
const std::vector<std::vector<std::uint32_t>> cube_faces = {
    {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

TEST(MakeMesh, AngleWeightsDoNotSeeHowFacesAreCut) {
  for (const glm::vec3& n : make_mesh("cube", cube_points(), cube_faces).normals)
    EXPECT_NEAR(std::abs(n.x) + std::abs(n.y) + std::abs(n.z), std::sqrt(3.0f), 1e-5);
}

TEST(MakeMesh, SidesOfASheetThatCancelLeaveNoRandomNormals) {
  // Both sides of a slanted hexagon, cut along different diagonals: the sums at its corners are
  // what rounding leaves.
  const glm::vec3 u{0.3f, 0.1f, 0.2f}, v{0.1f, 0.2f, -0.1f},
      normal = glm::normalize(glm::cross(u, v));
  std::vector<glm::vec3> points;
  for (const auto& [a, b] : {std::pair(0, 0), {3, -1}, {5, 1}, {5, 4}, {3, 5}, {-1, 3}})
    points.push_back(float(a) * u + float(b) * v);
  const Mesh mesh = make_mesh(
      "sheet", points,
      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {2, 1, 0}, {2, 0, 5}, {2, 5, 4}, {2, 4, 3}});
  for (const glm::vec3& n : mesh.normals) EXPECT_GT(std::abs(glm::dot(n, normal)), 0.99f);
}

TEST(MakeMesh, SplitsNormalsAtCreases) {
  const auto cube = [](std::optional<double> crease_deg) {
    return make_mesh("cube", cube_points(), cube_faces, {NormalWeight::angle, crease_deg});
  };
  EXPECT_EQ(cube({}).positions.size(), 8u);
  EXPECT_EQ(cube(90).positions.size(), 8u) << "90 is not larger than 90";
  const Mesh sharp = cube(89);
  EXPECT_EQ(sharp.positions.size(), 24u);
  EXPECT_TRUE(sharp.closed);
  for (std::size_t i = 0; i < sharp.indices.size(); i += 3) {
    const auto p = [&](std::size_t k) { return sharp.positions[sharp.indices[i + k]]; };
    const glm::vec3 face = glm::normalize(glm::cross(p(1) - p(0), p(2) - p(0)));
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(glm::dot(sharp.normals[sharp.indices[i + k]], face), 1, 1e-6);
  }
  EXPECT_THROW(cube(181), Error);
  EXPECT_THROW(cube(-1), Error);
  EXPECT_THROW(cube(std::numeric_limits<double>::quiet_NaN()), Error);
}

TEST(MakeMesh, CreaseOfOneEdgeEndsInASmoothVertex) {
  // A disc that hangs down on both sides of the edge 0-1: there the faces meet at 43 degrees, at no
  // other edge at more than 15.
  std::vector<glm::vec3> points = {{0, 0, 0}};
  std::vector<std::vector<std::uint32_t>> faces;
  constexpr std::uint32_t segments = 24;
  for (std::uint32_t i = 0; i < segments; ++i) {
    const double angle_rad = 6.283185307179586 * i / segments;
    points.emplace_back(std::cos(angle_rad), std::sin(angle_rad), -0.8 * std::sin(angle_rad / 2));
    faces.push_back({0, i + 1, (i + 1) % segments + 1});
  }
  const Mesh mesh = make_mesh("disc", points, faces, {NormalWeight::angle, 30});
  // One normal at the centre, where the crease ends, and two at its other end.
  EXPECT_EQ(mesh.positions.size(), points.size() + 1);
  EXPECT_EQ(std::ranges::count(mesh.positions, points[0]), 1);
  EXPECT_EQ(std::ranges::count(mesh.positions, points[1]), 2);
}

TEST(MakeMesh, ClosedMeansOutwardWithoutBoundary) {
  EXPECT_TRUE(make_mesh("cube", cube_points(), cube_faces).closed);

  auto open = cube_faces;
  open.pop_back();
  EXPECT_FALSE(make_mesh("open", cube_points(), open).closed);

  auto turned = cube_faces;
  std::ranges::reverse(turned[0]);
  EXPECT_FALSE(make_mesh("turned", cube_points(), turned).closed);

  auto inside_out = cube_faces;
  for (auto& face : inside_out) std::ranges::reverse(face);
  const Mesh mesh = make_mesh("inside out", cube_points(), inside_out);
  EXPECT_FALSE(mesh.closed);
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_TRUE(mesh.warnings[0].starts_with("it is inside out")) << mesh.warnings[0];

  auto doubled = cube_faces;  // an edge shared by four triangles
  doubled.insert(doubled.end(), cube_faces.begin(), cube_faces.end());
  EXPECT_FALSE(make_mesh("doubled", cube_points(), doubled).closed);
}

TEST(MakeMesh, ClosedLooksAtPositionsNotAtIndices) {
  std::vector<glm::vec3> points;
  std::vector<std::vector<std::uint32_t>> faces;
  for (const auto& face : cube_faces) {
    faces.emplace_back();
    for (const std::uint32_t v : face) {
      faces.back().push_back(std::uint32_t(points.size()));
      points.push_back(cube_points()[v]);
    }
  }
  EXPECT_TRUE(make_mesh("cube of six loose faces", points, faces).closed);
}

TEST(MakeMesh, DrawsWhatOpenMeshRefuses) {
  const std::vector<glm::vec3> points = {{0, 0, 0}, {0, 1, 0},  {1, 0, 0},
                                         {0, 0, 1}, {0, 0, -1}, {-1, 0, 0}};
  // Four faces at the edge 0-1, two of them turned the same way.
  const Mesh book = make_mesh("book", points, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}});
  EXPECT_EQ(book.triangle_count(), 4u);
  ASSERT_EQ(book.warnings.size(), 1u);
  EXPECT_TRUE(book.warnings[0].starts_with("3 faces at an edge")) << book.warnings[0];

  const Mesh repeated = make_mesh("repeated", points, {{0, 0, 1, 2, 0}, {0, 2, 0}, {1, 1}, {}});
  EXPECT_EQ(repeated.triangle_count(), 1u);
  ASSERT_EQ(repeated.warnings.size(), 2u);
  EXPECT_TRUE(repeated.warnings[0].starts_with("1 face with a vertex named more than once"));
  EXPECT_TRUE(repeated.warnings[1].starts_with("3 faces of fewer than 3 distinct vertices"));
}

TEST(MakeMesh, SmoothsOverAVertexOfVeryManyFaces) {
  constexpr std::uint32_t segments = 1000;  // more than are put around one OpenMesh vertex
  std::vector<glm::vec3> points = {{0, 1, 0}};
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t i = 0; i < segments; ++i) {
    const double angle_rad = 6.283185307179586 * i / segments;
    points.emplace_back(std::sin(angle_rad), 0, std::cos(angle_rad));
    faces.push_back({0, i + 1, (i + 1) % segments + 1});
  }
  const Mesh mesh = make_mesh("cone", points, faces);
  EXPECT_TRUE(mesh.warnings.empty());
  EXPECT_EQ(mesh.triangle_count(), segments);
  for (const std::uint32_t i : mesh.indices)
    if (mesh.positions[i].y == 1) {
      EXPECT_GT(mesh.normals[i].y, 0.99999f);
    }
}

TEST(MakeMesh, NormalsAreUnitWhateverTheTriangles) {
  const auto normals = [](const std::vector<glm::vec3>& points,
                          const std::vector<std::vector<std::uint32_t>>& faces) {
    return make_mesh("m", points, faces).normals;
  };
  const glm::vec3 z{0, 0, 1};
  // zero area; the two sides of a sheet; the smallest and the largest floats
  for (const glm::vec3& n : normals({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}))
    EXPECT_EQ(n, z);
  for (const glm::vec3& n : normals({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}))
    EXPECT_EQ(std::abs(n.z), 1);
  for (const glm::vec3& n : normals({{0, 0, 0}, {1e-44f, 0, 0}, {0, 1e-44f, 0}}, {{0, 1, 2}}))
    EXPECT_EQ(n, z);
  for (const glm::vec3& n : normals({{-3e38f, 0, 0}, {3e38f, 0, 0}, {0, 3e38f, 0}}, {{0, 1, 2}}))
    EXPECT_EQ(n, z);
}

TEST(MakeMesh, LeavesOutVerticesWithoutAFace) {
  const Mesh mesh =
      make_mesh("m", {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {8, 8, 8}, {0, 1, 0}}, {{1, 2, 4}});
  ASSERT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.positions[2], glm::vec3(0, 1, 0));
}

/// The area, and that no triangle of the flat polygon is turned over.
double area_of(const Mesh& mesh) {
  double area = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto p = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[i + k]]); };
    const double z = glm::cross(p(1) - p(0), p(2) - p(0)).z;
    EXPECT_GE(z, 0);
    area += z / 2;
  }
  return area;
}

/// A polygon of `corners` corners, every other one near the centre.
Mesh star(std::uint32_t corners) {
  std::vector<glm::vec3> points;
  std::vector<std::uint32_t> outline;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double angle_rad = 6.283185307179586 * i / corners, radius = i % 2 ? 0.2 : 1;
    points.emplace_back(radius * std::cos(angle_rad), radius * std::sin(angle_rad), 0);
    outline.push_back(i);
  }
  return make_mesh("star", points, {outline});
}

TEST(MakeMesh, CutsConcavePolygons) {
  const Mesh l_shape =
      make_mesh("L", {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
                {{3, 4, 5, 0, 1, 2}});
  EXPECT_EQ(l_shape.triangle_count(), 4u);
  EXPECT_DOUBLE_EQ(area_of(l_shape), 3);

  const Mesh cut = star(24);
  EXPECT_TRUE(cut.warnings.empty());
  EXPECT_NEAR(area_of(cut), 12 * 0.2 * std::sin(6.2831853 / 24), 1e-6);
}

TEST(MakeMesh, SaysWhereAPolygonIsTooLongToBeCut) {
  const Mesh fan = star(1002);
  EXPECT_EQ(fan.triangle_count(), 1000u);
  ASSERT_EQ(fan.warnings.size(), 1u);
  EXPECT_TRUE(fan.warnings[0].starts_with("1 polygon whose outline")) << fan.warnings[0];
}

TEST(MakeMesh, CutsAPolygonWithABridgeToItsHole) {
  // A square of side 4 with a square hole of side 2; vertices 0 and 4 are named twice.
  const Mesh mesh = make_mesh(
      "frame",
      {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}},
      {{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}});
  EXPECT_DOUBLE_EQ(area_of(mesh), 12);
}

}  // namespace
}  // namespace scanlit
