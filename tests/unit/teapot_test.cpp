#include "rasterizer/mesh/teapot.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "rasterizer/shapes.h"

namespace scanlit {
namespace {

using glm::dvec3;
using Place = std::tuple<float, float, float>;

Place place(const glm::vec3& p) { return {p.x, p.y, p.z}; }

TEST(Teapot, IsCentredWithYUp) {
  const Mesh mesh = make_shape("teapot:20");
  dvec3 low(9), high(-9);
  for (const glm::vec3& p : mesh.positions) {
    low = glm::min(low, dvec3(p));
    high = glm::max(high, dvec3(p));
  }
  EXPECT_LT(glm::distance(low, dvec3(-1, -0.48959, -0.6217)), 2e-4);
  EXPECT_LT(glm::distance(high, dvec3(1, 0.48959, 0.6217)), 2e-4);
}

/// How often each edge is run along in each direction.
std::map<std::pair<Place, Place>, int> directed_edges(const Mesh& mesh) {
  std::map<std::pair<Place, Place>, int> edges;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k)
      ++edges[{place(mesh.positions[mesh.indices[i + k]]),
               place(mesh.positions[mesh.indices[i + (k + 1) % 3]])}];
  return edges;
}

TEST(Teapot, PatchesMeetToTheBitAndAreWoundTheSameWay) {
  for (const int n : {2, 5, 16}) {
    const auto edges = directed_edges(make_shape("teapot:" + std::to_string(n)));
    int border = 0;
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      if (!edges.contains({edge.second, edge.first})) ++border;
    }
    // The rim inside (4 patches' sides), the lid's rim (4), and the ends of handle and spout (8).
    EXPECT_EQ(border, 16 * n);
  }
}

TEST(Teapot, NormalsPointOut) {
  const Mesh mesh = make_shape("teapot:12");
  const double half_length = 3.217, axis_x = -0.217 / half_length;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const dvec3 p = mesh.positions[i], n = mesh.normals[i];
    const double radius = std::hypot(p.x - axis_x, p.z) * half_length;
    const double height = (p.y * half_length) + 1.575;
    if (height < 0.149) {
      EXPECT_LT(n.y, 0) << "bottom";
    }
    if (height > 0.2 && height < 2.39 && std::abs(p.z) > 0.25) {  // beside handle and spout
      EXPECT_GT((p.x - axis_x) * n.x + p.z * n.z, 0) << "body";
    }
    if (height > 3.1) {
      EXPECT_GT(n.y, 0) << "knob";
    }
    if (radius > 2.3 && std::abs(p.z) > 0.05) {
      EXPECT_GT(p.z * n.z, -1e-6) << "handle and spout";
    }
  }
}

TEST(Teapot, NormalsAreRightWherePatchesCollapseToAPoint) {
  const Mesh mesh = make_shape("teapot:9");
  int tops = 0, bottoms = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const dvec3 p = mesh.positions[i], n = mesh.normals[i];
    const dvec3 top = detail::shape_from_teapot({0, 0, 3.15});
    const dvec3 bottom = detail::shape_from_teapot({0, 0, 0});
    if (glm::distance(p, top) < 1e-6) {
      ++tops;
      EXPECT_LT(glm::distance(n, dvec3(0, 1, 0)), 1e-6);
    }
    if (glm::distance(p, bottom) < 1e-6) {
      ++bottoms;
      EXPECT_LT(glm::distance(n, dvec3(0, -1, 0)), 1e-6);
    }
  }
  EXPECT_EQ(tops, 36);  // a vertex for each triangle there
  EXPECT_EQ(bottoms, 36);
}

TEST(Teapot, NormalsAreThoseOfAFineTessellation) {
  const Mesh mesh = make_shape("teapot:64");
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto p = [&](std::size_t k) { return dvec3(mesh.positions[mesh.indices[i + k]]); };
    const dvec3 face = glm::normalize(glm::cross(p(1) - p(0), p(2) - p(0)));
    for (std::size_t k = 0; k < 3; ++k)
      ASSERT_GT(glm::dot(face, dvec3(mesh.normals[mesh.indices[i + k]])), 0.97);
  }
}

// The points of a teapot made by others from the same patches lie on ours.
TEST(Teapot, AgreesWithATeapotMadeByOthers) {
  const std::filesystem::path file = SCANLIT_SOURCE_DIR "/../shared/meshes/teapot.obj";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const Mesh theirs = load_mesh(file);
  const Mesh ours = make_shape("teapot:60");

  // Ours in cells, so that each of their points is compared with its neighbours only.
  constexpr double cell = 0.05;
  const auto cell_of = [](const dvec3& p) {
    const glm::ivec3 c(glm::floor(p / cell));
    return std::tuple(c.x, c.y, c.z);
  };
  std::map<std::tuple<int, int, int>, std::vector<dvec3>> cells;
  for (const glm::vec3& p : ours.positions) cells[cell_of(p)].push_back(p);
  for (const glm::vec3& published : theirs.positions) {
    // Theirs has y up already, and the published scale.
    const dvec3 p = detail::shape_from_teapot({published.x, -published.z, published.y});
    double nearest = 1;
    for (int i = 0; i < 27; ++i)
      for (const dvec3& q : cells[cell_of(p + cell * dvec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1))])
        nearest = std::min(nearest, glm::distance(p, q));
    ASSERT_LT(nearest, 0.012) << published.x << " " << published.y << " " << published.z;
  }
}

}  // namespace
}  // namespace scanlit
