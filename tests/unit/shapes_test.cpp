#include "rasterizer/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <map>

#include "rasterizer/error.h"
#include "rasterizer/mesh/mesh_closed.h"

namespace scanlit {
namespace {

using glm::dvec3;

dvec3 face_normal(const Mesh& mesh, std::size_t triangle) {
  const auto p = [&](std::size_t k) {
    return dvec3(mesh.positions[mesh.indices[3 * triangle + k]]);
  };
  return glm::normalize(glm::cross(p(1) - p(0), p(2) - p(0)));
}

/// The smallest cosine between a triangle's normal and the vertex normals at its corners.
double least_agreement(const Mesh& mesh) {
  double least = 1;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      least = std::min(
          least, glm::dot(face_normal(mesh, t), dvec3(mesh.normals[mesh.indices[3 * t + k]])));
  return least;
}

void expect_normals(const std::string& specification,
                    const std::function<dvec3(const dvec3& position)>& expected) {
  const Mesh mesh = make_shape(specification);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    ASSERT_LT(glm::distance(dvec3(mesh.normals[i]), expected(mesh.positions[i])), 1e-6)
        << specification << " vertex " << i;
}

TEST(Shapes, EveryOneKeepsTheInvariantsOfAMesh) {
  for (const ShapeInfo& info : shapes())
    for (const int n :
         {info.min_tessellation, info.min_tessellation + 1, info.default_tessellation}) {
      SCOPED_TRACE(info.name + ":" + std::to_string(n));
      const Mesh mesh = make_shape(info.name + ":" + std::to_string(n));
      EXPECT_EQ(mesh.name, info.name + ":" + std::to_string(n));
      EXPECT_TRUE(mesh.warnings.empty());
      EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
      EXPECT_EQ(mesh.texcoords.size(), mesh.positions.size());
      for (const glm::vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1, 1e-6);
      for (const std::uint32_t i : mesh.indices) ASSERT_LT(i, mesh.positions.size());
      for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
        ASSERT_NEAR(glm::length(face_normal(mesh, t)), 1, 1e-6) << "zero area";
    }
}

TEST(Shapes, SolidsAreClosedAndTheOthersAreNot) {
  for (const ShapeInfo& info : shapes())
    for (int n = info.min_tessellation; n < info.min_tessellation + 20; ++n) {
      const std::string specification = info.name + ":" + std::to_string(n);
      const Mesh mesh = make_shape(specification);
      EXPECT_EQ(mesh.closed, info.name != "plane" && info.name != "teapot") << specification;
      EXPECT_EQ(detail::closedness(mesh) == detail::Closedness::outward, mesh.closed)
          << specification;
    }
}

TEST(Shapes, WindingAgreesWithTheNormals) {
  for (const ShapeInfo& info : shapes())
    if (info.name != "teapot") {
      EXPECT_GT(least_agreement(make_shape(info.name)), 0.98) << info.name;
    }
}

TEST(Shapes, TriangleCountsAreThoseOfTheDescription) {
  for (const auto& [specification, count] :
       std::map<std::string, std::size_t>{{"plane:7", 98},
                                          {"cube:5", 300},
                                          {"sphere:2", 8},
                                          {"sphere:501", 1002000},
                                          {"icosphere:1", 20},
                                          {"icosphere:9", 1620},
                                          {"torus:8", 256},
                                          {"trefoil:6", 576},
                                          {"cylinder:4", 16},
                                          {"cone:4", 8}})
    EXPECT_EQ(make_shape(specification).triangle_count(), count) << specification;
}

TEST(Shapes, NormalsAreThoseOfTheSurface) {
  for (const std::string sphere : {"sphere:2", "sphere:33", "icosphere:1", "icosphere:13"})
    expect_normals(sphere, [](const dvec3& p) { return p; });
  expect_normals("plane:3", [](const dvec3& p) { return dvec3(0, 0, 1 + p.z); });
  expect_normals("torus:20", [](const dvec3& p) {
    const dvec3 ring = 0.7 * glm::normalize(dvec3(p.x, p.y, 0));
    return (p - ring) / 0.3;
  });
}

TEST(Shapes, CylinderAndConeAreSharpAtTheirRims) {
  for (const std::string name : {"cylinder", "cone"}) {
    const Mesh mesh = make_shape(name + ":40");
    const double up = name == "cone" ? 1 : 0;  // the side's normal rises 1 where it goes out 2
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const dvec3 p = mesh.positions[i], n = mesh.normals[i];
      if (std::abs(n.y) > 0.99) {  // an end
        EXPECT_EQ(std::abs(p.y), 1);
        EXPECT_EQ(n, dvec3(0, p.y, 0));
      } else {
        EXPECT_NEAR(n.y, up == 1 ? 1 / std::sqrt(5.0) : 0, 1e-6) << name;
        if (p.y == 1 && up == 1) continue;  // the apex
        const dvec3 out = glm::normalize(dvec3(p.x, 0, p.z));
        EXPECT_LT(glm::distance(glm::normalize(dvec3(n.x, 0, n.z)), out), 1e-6) << name;
      }
    }
  }
}

TEST(Shapes, TrefoilIsATubeAroundItsKnot) {
  const Mesh mesh = make_shape("trefoil:24");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    // Going in along the normal by the tube's radius leads to the knot.
    const dvec3 centre = (dvec3(mesh.positions[i]) - 0.18 * dvec3(mesh.normals[i])) / 0.27;
    double nearest = 1e9;
    for (int k = 0; k < 192; ++k) {
      const double t = 6.283185307179586 * k / 192;
      nearest = std::min(nearest, glm::distance(centre, dvec3(std::sin(t) + 2 * std::sin(2 * t),
                                                              std::cos(t) - 2 * std::cos(2 * t),
                                                              -std::sin(3 * t))));
    }
    ASSERT_LT(nearest, 1e-5) << "vertex " << i;
  }
}

TEST(Shapes, TextureCoordinatesRunRoundWithoutATriangleAcross) {
  for (const std::string name :
       {"sphere:16", "icosphere:5", "cylinder:16", "cone:16", "torus:16"}) {
    const Mesh mesh = make_shape(name);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::vec2 a = mesh.texcoords[mesh.indices[i + k]];
        const glm::vec2 b = mesh.texcoords[mesh.indices[i + (k + 1) % 3]];
        ASSERT_LT(glm::distance(a, b), 0.55) << name;
      }
  }
}

TEST(Shapes, SpecificationsAreNamesWithANumber) {
  EXPECT_TRUE(is_shape("teapot"));
  EXPECT_TRUE(is_shape("sphere:64"));
  EXPECT_TRUE(is_shape("sphere:many"));  // a shape with a bad number, not a file
  EXPECT_FALSE(is_shape("sphere.obj"));
  EXPECT_FALSE(is_shape(""));
}

TEST(Shapes, BadSpecificationsSayWhatWouldBeRight) {
  const auto error_of = [](const std::string& specification) -> std::string {
    try {
      make_shape(specification);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(error_of("tea-pot"), "unknown shape 'tea-pot'; did you mean 'teapot'?");
  EXPECT_EQ(error_of("dodecahedron:3"),
            "unknown shape 'dodecahedron'; there are: plane, cube, sphere, icosphere, cylinder, "
            "cone, torus, trefoil, teapot");
  for (const std::string n : {"", "1", "1601", "-5", "3.5", "3x", " 3", "99999999999"})
    EXPECT_EQ(error_of("sphere:" + n),
              "sphere:" + n + ": '" + n +
                  "' is not a whole number from 2 to 1600 (stacks, with 2 N slices; 4 N^2 - 4 N "
                  "triangles)");
}

}  // namespace
}  // namespace scanlit
