// Clusters: a mesh's triangles, cut once into compact groups that are accepted or rejected whole.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "rasterizer/camera.h"
#include "rasterizer/mesh.h"

namespace scanlit {

/// A group of neighbouring triangles, and what holds for each of them. All bounds are in object
/// space and rounded to the safe side, but for the cone's, which are rounded to nearest.
struct Cluster {
  static constexpr int max_triangles = 128;
  static constexpr int max_vertices = 255;

  std::uint32_t first_triangle;  // in MeshClusters::triangles and corners
  std::uint32_t first_vertex;    // in MeshClusters::vertices
  std::uint16_t triangle_count;  // 1..max_triangles
  std::uint16_t vertex_count;    // 1..max_vertices

  // A sphere that holds every vertex.
  glm::vec3 centre;
  float radius;

  // A cone that holds every triangle's geometric normal: cosine and sine of its half angle. Where
  // it would be as wide as a half space or wider there is none: cosine 0, sine 1.
  glm::vec3 axis;  // unit
  float cosine, sine;

  float plane_distance;  // the centre's largest distance from a triangle's plane, <= radius
  float height;          // the smallest height of any triangle: 0 where one has no area
};

/// Every triangle of a mesh is in one cluster, those of zero area too.
struct MeshClusters {
  std::vector<Cluster> clusters;
  std::vector<std::uint32_t> triangles;  // triangle of the mesh; cluster after cluster
  std::vector<std::uint32_t> vertices;   // vertex of the mesh; cluster after cluster
  // Object space, of each element of `vertices`: the vertex stage reads them one after the other,
  // where those of the mesh would be fetched from all over it. Followed by `padding` zeros.
  std::vector<glm::vec3> positions;
  // Corner c of the triangle triangles[i] is the vertex vertices[first_vertex + corners[c][i]] of
  // its cluster. Followed by `padding` zeros, so that vectors may be loaded beyond the end.
  std::vector<std::uint8_t> corners[3];
  static constexpr int padding = 64;
  Sphere bounds;      // of every vertex that a triangle names; object space
  bool flat = false;  // each triangle's three normals are the same
};

/// Deterministic, whatever the number of threads; runs on the oneTBB threads of the caller's arena.
/// The triangles of one cluster are sorted by their numbers in the mesh.
MeshClusters make_clusters(const Mesh& mesh);

/// The clusters of the meshes that were asked for, for as long as those live. A Mesh never changes,
/// and a copy of it is a mesh of its own. Not for use by two threads at once.
class ClusterCache {
 public:
  std::shared_ptr<const MeshClusters> of(const std::shared_ptr<const Mesh>& mesh);

 private:
  struct Entry {
    std::weak_ptr<const Mesh> mesh;
    std::shared_ptr<const MeshClusters> clusters;
  };
  std::unordered_map<const Mesh*, Entry> entries_;
};

}  // namespace scanlit
