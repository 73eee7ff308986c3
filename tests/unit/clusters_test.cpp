// A mesh's clusters hold every triangle once, keep to their limits, and bound what they hold.
#include "rasterizer/mesh/clusters.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "rasterizer/shapes.h"

namespace scanlit {
namespace {

Mesh loose_triangles(int count) {
  Mesh mesh;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(-1, 1);
  for (int i = 0; i < 3 * count; ++i) {
    mesh.positions.emplace_back(unit(random), unit(random), unit(random));
    mesh.normals.emplace_back(0, 0, 1);
    mesh.indices.push_back(std::uint32_t(i));
  }
  return mesh;
}

/// The same surface, its triangles and vertices in another order.
Mesh shuffled(const Mesh& mesh) {
  std::mt19937 random(2);
  std::vector<std::uint32_t> triangles(mesh.triangle_count()), new_vertex(mesh.positions.size());
  std::iota(triangles.begin(), triangles.end(), 0u);
  std::iota(new_vertex.begin(), new_vertex.end(), 0u);
  std::shuffle(triangles.begin(), triangles.end(), random);
  std::shuffle(new_vertex.begin(), new_vertex.end(), random);
  Mesh result = mesh;
  for (std::size_t v = 0; v < new_vertex.size(); ++v) {
    result.positions[new_vertex[v]] = mesh.positions[v];
    result.normals[new_vertex[v]] = mesh.normals[v];
  }
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
    result.indices[i] = new_vertex[mesh.indices[3 * triangles[i / 3] + i % 3]];
  return result;
}

void require_bounds(const Mesh& mesh, const MeshClusters& clusters, const Cluster& cluster) {
  const glm::dvec3 centre(cluster.centre), axis(cluster.axis);
  for (std::uint32_t i = 0; i < cluster.triangle_count; ++i) {
    const std::uint32_t* v =
        &mesh.indices[3 * std::size_t(clusters.triangles[cluster.first_triangle + i])];
    const glm::dvec3 a(mesh.positions[v[0]]), b(mesh.positions[v[1]]), c(mesh.positions[v[2]]);
    for (const glm::dvec3& p : {a, b, c}) {
      ASSERT_LE(glm::distance(p, centre), double(cluster.radius));
      ASSERT_LE(glm::distance(p, clusters.bounds.centre), clusters.bounds.radius);
    }
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double twice_area = glm::length(normal);
    const double longest =
        std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    ASSERT_LE(double(cluster.height) * longest, twice_area);
    if (cluster.height == 0) continue;
    if (cluster.cosine > 0) {
      ASSERT_GE(glm::dot(axis, normal) / twice_area, double(cluster.cosine) - 3e-7);
    }
    ASSERT_LE(std::abs(glm::dot(normal, a - centre)) / twice_area,
              double(cluster.plane_distance) * (1 + 1e-12));
  }
  ASSERT_NEAR(glm::length(axis), 1, 2e-7);
  ASSERT_NEAR(std::hypot(cluster.cosine, cluster.sine), 1, 2e-7);
}

/// Everything that the header promises.
void require_clusters(const Mesh& mesh, const MeshClusters& clusters) {
  std::vector<int> times(mesh.triangle_count());
  std::uint32_t next_triangle = 0, next_vertex = 0;
  for (const Cluster& cluster : clusters.clusters) {
    ASSERT_EQ(cluster.first_triangle, next_triangle);
    ASSERT_EQ(cluster.first_vertex, next_vertex);
    ASSERT_GE(cluster.triangle_count, 1);
    ASSERT_LE(cluster.triangle_count, Cluster::max_triangles);
    ASSERT_LE(cluster.vertex_count, Cluster::max_vertices);
    const std::uint32_t* vertices = &clusters.vertices[cluster.first_vertex];
    ASSERT_EQ(std::set(vertices, vertices + cluster.vertex_count).size(), cluster.vertex_count);
    for (std::uint32_t i = next_triangle; i < next_triangle + cluster.triangle_count; ++i) {
      const std::uint32_t triangle = clusters.triangles[i];
      ++times[triangle];
      if (i > next_triangle) {
        ASSERT_LT(clusters.triangles[i - 1], triangle);
      }
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_LT(clusters.corners[c][i], cluster.vertex_count);
        ASSERT_EQ(vertices[clusters.corners[c][i]], mesh.indices[3 * std::size_t(triangle) + c]);
      }
    }
    require_bounds(mesh, clusters, cluster);
    next_triangle += cluster.triangle_count;
    next_vertex += cluster.vertex_count;
  }
  EXPECT_TRUE(std::ranges::all_of(times, [](int n) { return n == 1; }));
  EXPECT_EQ(clusters.triangles.size(), mesh.triangle_count());
  EXPECT_EQ(clusters.vertices.size(), next_vertex);
  for (const auto& corners : clusters.corners)
    EXPECT_EQ(corners.size(), mesh.triangle_count() + MeshClusters::padding);
}

TEST(Clusters, HoldEveryTriangleOnceWithinTheirLimitsAndBounds) {
  for (const char* shape : {"plane:1", "cube", "sphere", "cone", "trefoil", "teapot"})
    require_clusters(make_shape(shape), make_clusters(make_shape(shape)));
  for (const int count : {1, 85, 86, 128, 129, 5000}) {
    const Mesh mesh = loose_triangles(count);
    require_clusters(mesh, make_clusters(mesh));
  }
}

TEST(Clusters, OfAnEmptyMeshAreNone) {
  const MeshClusters clusters = make_clusters(Mesh());
  EXPECT_TRUE(clusters.clusters.empty());
  EXPECT_EQ(clusters.corners[0].size(), std::size_t(MeshClusters::padding));
}

TEST(Clusters, HoldTrianglesWithoutArea) {
  Mesh mesh = make_shape("sphere:20");
  for (std::size_t i = 0; i < mesh.indices.size(); i += 30) mesh.indices[i] = mesh.indices[i + 1];
  const MeshClusters clusters = make_clusters(mesh);
  require_clusters(mesh, clusters);
  for (const Cluster& cluster : clusters.clusters) EXPECT_EQ(cluster.height, 0);

  // All of them in one point.
  mesh.positions.assign(mesh.positions.size(), glm::vec3(1, 2, 3));
  require_clusters(mesh, make_clusters(mesh));
}

TEST(Clusters, BoundHugeAndTinyMeshes) {
  for (const float scale : {1e-30f, 1e-12f, 1e12f, 1e37f}) {
    Mesh mesh = make_shape("sphere:20");
    for (glm::vec3& p : mesh.positions) p *= scale;
    require_clusters(mesh, make_clusters(mesh));
  }
}

TEST(Clusters, OfWhatIsNotFiniteHaveNoFiniteBounds) {
  Mesh mesh = make_shape("sphere:20");
  mesh.positions[100].y = std::numeric_limits<float>::quiet_NaN();
  const MeshClusters clusters = make_clusters(mesh);
  EXPECT_FALSE(std::isfinite(clusters.bounds.radius));
}

TEST(Clusters, DoNotDependOnThreads) {
  const Mesh mesh = shuffled(make_shape("torus:120"));
  MeshClusters by_threads[2];
  for (const int threads : {1, 4})
    tbb::task_arena(threads).execute([&] { by_threads[threads / 4] = make_clusters(mesh); });
  const auto& [one, four] = by_threads;
  EXPECT_EQ(one.triangles, four.triangles);
  EXPECT_EQ(one.vertices, four.vertices);
  for (int c = 0; c < 3; ++c) EXPECT_EQ(one.corners[c], four.corners[c]);
  EXPECT_EQ(one.clusters.size(), four.clusters.size());
}

TEST(Clusters, AreCompactWhateverTheOrderOfTriangles) {
  const Mesh in_rows = make_shape("sphere:100");
  for (const Mesh& mesh : {in_rows, shuffled(in_rows)}) {
    const MeshClusters clusters = make_clusters(mesh);
    EXPECT_LT(double(clusters.vertices.size()), 0.76 * double(mesh.triangle_count()));
    EXPECT_LT(double(clusters.clusters.size()), double(mesh.triangle_count()) / 120);
    double degrees = 0;
    for (const Cluster& cluster : clusters.clusters)
      degrees += std::acos(double(cluster.cosine)) * 57.29578;
    EXPECT_LT(degrees / double(clusters.clusters.size()), 12);
  }
}

// One within another, much closer than a cluster is wide.
TEST(Clusters, DoNotMixSurfacesThatDoNotMeet) {
  const Mesh sphere = make_shape("sphere:22");
  Mesh nested;
  for (int i = 0; i < 20; ++i) {
    const auto first = std::uint32_t(nested.positions.size());
    for (const glm::vec3& p : sphere.positions)
      nested.positions.push_back(p * (1 + 0.01f * float(i)));
    nested.normals.insert(nested.normals.end(), sphere.normals.begin(), sphere.normals.end());
    for (const std::uint32_t v : sphere.indices) nested.indices.push_back(first + v);
  }
  const MeshClusters clusters = make_clusters(nested);
  for (const Cluster& cluster : clusters.clusters) {
    const std::uint32_t* first = &clusters.triangles[cluster.first_triangle];
    EXPECT_EQ(first[0] / sphere.triangle_count(),
              first[cluster.triangle_count - 1] / sphere.triangle_count());
  }
}

TEST(ClusterCache, KnowsAMeshFromItsCopies) {
  ClusterCache cache;
  auto mesh = std::make_shared<Mesh>(make_shape("cube"));
  const auto clusters = cache.of(mesh);
  EXPECT_EQ(cache.of(mesh), clusters);

  const auto copy = std::make_shared<Mesh>(*mesh);
  copy->indices.resize(3);
  EXPECT_EQ(cache.of(copy)->triangles.size(), 1u);

  // A mesh that is gone, and another at its place.
  Mesh place = *mesh;
  const auto nothing = [](const Mesh*) {};
  cache.of(std::shared_ptr<const Mesh>(&place, nothing));
  place.indices.resize(6);
  EXPECT_EQ(cache.of(std::shared_ptr<const Mesh>(&place, nothing))->triangles.size(), 2u);
}

}  // namespace
}  // namespace scanlit
