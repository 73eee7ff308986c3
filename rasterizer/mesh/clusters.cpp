#include "rasterizer/mesh/clusters.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "rasterizer/mesh/cluster_order.h"

namespace scanlit {

namespace {

// Rounded to float, to the safe side.
float upwards(double value) {
  return std::nextafter(float(value), std::numeric_limits<float>::infinity());
}
float downwards(double positive) {
  return positive > 0 ? std::max(0.0f, std::nextafter(float(positive), 0.0f)) : 0.0f;
}

/// What is not finite is larger than anything: a sphere that holds it is never culled.
double larger(double a, double b) {
  return std::isfinite(b) ? std::max(a, b) : std::numeric_limits<double>::infinity();
}

void bound_by_sphere(const Mesh& mesh, const std::uint32_t* vertices, Cluster& cluster) {
  glm::vec3 low = mesh.positions[vertices[0]], high = low;
  for (int v = 1; v < cluster.vertex_count; ++v) {
    low = glm::min(low, mesh.positions[vertices[v]]);
    high = glm::max(high, mesh.positions[vertices[v]]);
  }
  cluster.centre = low * 0.5f + high * 0.5f;
  double radius = 0;
  for (int v = 0; v < cluster.vertex_count; ++v) {
    const glm::dvec3 offset = glm::dvec3(mesh.positions[vertices[v]]) - glm::dvec3(cluster.centre);
    radius = larger(radius, glm::length(offset));
  }
  cluster.radius = upwards(radius);
}

void bound_normals(const Mesh& mesh, const std::uint32_t* triangles, Cluster& cluster) {
  // Of a thinner triangle the normal is not known well enough, even in double.
  const double thinnest = 1e-6;
  cluster.axis = {0, 0, 1};
  cluster.cosine = 0;
  cluster.sine = 1;
  cluster.height = 0;
  cluster.plane_distance = cluster.radius;

  glm::dvec3 normals[Cluster::max_triangles], sum(0);
  double height = std::numeric_limits<double>::infinity(), plane_distance = 0;
  for (int i = 0; i < cluster.triangle_count; ++i) {
    const std::uint32_t* v = &mesh.indices[3 * std::size_t(triangles[i])];
    const glm::dvec3 a(mesh.positions[v[0]]), b(mesh.positions[v[1]]), c(mesh.positions[v[2]]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double twice_area = glm::length(normal);
    const double longest =
        std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    if (!(twice_area > thinnest * longest * longest)) return;
    normals[i] = normal / twice_area;
    sum += normals[i];
    height = std::min(height, twice_area / longest);
    plane_distance =
        std::max(plane_distance, std::abs(glm::dot(normals[i], a - glm::dvec3(cluster.centre))));
  }
  cluster.height = downwards(height);
  cluster.plane_distance = std::min(cluster.radius, upwards(plane_distance));

  const double length = glm::length(sum);
  if (!(length > 1e-3)) return;  // they cancel
  const glm::dvec3 axis = sum / length;
  double cosine = 1;
  for (int i = 0; i < cluster.triangle_count; ++i)
    cosine = std::min(cosine, glm::dot(axis, normals[i]));
  if (!(cosine > 0)) return;
  cluster.axis = axis;
  cluster.cosine = float(cosine);
  cluster.sine = float(std::sqrt(1 - cosine * cosine));
}

/// The vertices of one cluster, numbered in the order in which they are first met: a small table of
/// open addresses.
class LocalNumbers {
 public:
  LocalNumbers() { clear(); }
  void clear() {
    std::fill_n(numbers_, size, std::int16_t(-1));
    vertices.clear();
  }
  int of(std::uint32_t vertex) {
    std::uint32_t slot = vertex * 2654435769u >> 23;  // 2^32 / golden ratio: Knuth's hash
    while (numbers_[slot] >= 0 && keys_[slot] != vertex) slot = (slot + 1) % size;
    if (numbers_[slot] < 0) {
      numbers_[slot] = std::int16_t(vertices.size());
      keys_[slot] = vertex;
      vertices.push_back(vertex);
    }
    return numbers_[slot];
  }
  std::vector<std::uint32_t> vertices;

 private:
  static constexpr std::uint32_t size = 512;  // 9 bits of the hash
  std::uint32_t keys_[size];
  std::int16_t numbers_[size];
};

/// Cuts [begin, end) of the order, at most max_triangles, into one cluster, or more where vertices
/// are too many; appends the clusters and their vertices.
void cut(const Mesh& mesh, std::uint32_t begin, std::uint32_t end, LocalNumbers& local,
         MeshClusters& result, std::vector<Cluster>& clusters,
         std::vector<std::uint32_t>& vertices) {
  while (begin < end) {
    local.clear();
    std::uint32_t stop = begin;
    for (; stop < end; ++stop) {
      for (int c = 0; c < 3; ++c)
        local.of(mesh.indices[3 * std::size_t(result.triangles[stop]) + std::size_t(c)]);
      if (local.vertices.size() > Cluster::max_vertices) break;
    }
    // In the mesh's order vertices are met more nearly in the order in which they lie in memory.
    std::sort(&result.triangles[begin], result.triangles.data() + stop);
    local.clear();
    for (std::uint32_t i = begin; i < stop; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        result.corners[c][i] =
            std::uint8_t(local.of(mesh.indices[3 * std::size_t(result.triangles[i]) + c]));

    Cluster& cluster = clusters.emplace_back();
    cluster.first_triangle = begin;
    cluster.first_vertex = std::uint32_t(vertices.size());
    cluster.triangle_count = std::uint16_t(stop - begin);
    cluster.vertex_count = std::uint16_t(local.vertices.size());
    bound_by_sphere(mesh, local.vertices.data(), cluster);
    bound_normals(mesh, &result.triangles[begin], cluster);
    vertices.insert(vertices.end(), local.vertices.begin(), local.vertices.end());
    begin = stop;
  }
}

bool flat(const Mesh& mesh) {
  const auto normal = [&](std::size_t corner) { return mesh.normals[mesh.indices[corner]]; };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    if (normal(i) != normal(i + 1) || normal(i) != normal(i + 2)) return false;
  return true;
}

Sphere bounds_of(const std::vector<Cluster>& clusters) {
  if (clusters.empty()) return {};
  glm::dvec3 low(clusters[0].centre), high(low);
  for (const Cluster& cluster : clusters) {
    low = glm::min(low, glm::dvec3(cluster.centre) - double(cluster.radius));
    high = glm::max(high, glm::dvec3(cluster.centre) + double(cluster.radius));
  }
  Sphere bounds{(low + high) * 0.5, 0};
  for (const Cluster& cluster : clusters) {
    const double distance = glm::distance(bounds.centre, glm::dvec3(cluster.centre));
    bounds.radius = larger(bounds.radius, distance + double(cluster.radius));
  }
  bounds.radius *= 1 + 1e-12;  // the rounding of the lines above
  return bounds;
}

}  // namespace

MeshClusters make_clusters(const Mesh& mesh) {
  ClusterOrder order = cluster_order(mesh, Cluster::max_triangles);
  MeshClusters result;
  result.triangles = std::move(order.triangles);
  for (auto& corners : result.corners)
    corners.resize(result.triangles.size() + MeshClusters::padding);

  struct Part {
    std::vector<Cluster> clusters;
    std::vector<std::uint32_t> vertices;
  };
  const std::size_t grain = 64, groups = order.ends.size();
  std::vector<Part> parts((groups + grain - 1) / grain);
  tbb::parallel_for(std::size_t(0), parts.size(), [&](std::size_t p) {
    LocalNumbers local;
    for (std::size_t i = p * grain; i < std::min(groups, (p + 1) * grain); ++i)
      cut(mesh, i == 0 ? 0 : order.ends[i - 1], order.ends[i], local, result, parts[p].clusters,
          parts[p].vertices);
  });

  std::size_t cluster_count = 0, vertex_count = 0;
  for (const Part& part : parts) {
    cluster_count += part.clusters.size();
    vertex_count += part.vertices.size();
  }
  result.clusters.reserve(cluster_count);
  result.vertices.reserve(vertex_count);
  for (const Part& part : parts) {
    const auto first_vertex = std::uint32_t(result.vertices.size());
    for (Cluster cluster : part.clusters) {
      cluster.first_vertex += first_vertex;
      result.clusters.push_back(cluster);
    }
    result.vertices.insert(result.vertices.end(), part.vertices.begin(), part.vertices.end());
  }
  result.positions.resize(vertex_count + MeshClusters::padding);
  tbb::parallel_for(std::size_t(0), cluster_count, [&](std::size_t i) {
    const Cluster& cluster = result.clusters[i];
    for (std::size_t k = 0; k < cluster.vertex_count; ++k)
      result.positions[cluster.first_vertex + k] =
          mesh.positions[result.vertices[cluster.first_vertex + k]];
  });
  result.bounds = bounds_of(result.clusters);
  result.flat = flat(mesh);
  return result;
}

std::shared_ptr<const MeshClusters> ClusterCache::of(const std::shared_ptr<const Mesh>& mesh) {
  // A mesh that is gone may have had the same address.
  const auto found = entries_.find(mesh.get());
  if (found != entries_.end() && found->second.mesh.lock() == mesh) return found->second.clusters;
  std::erase_if(entries_, [](const auto& entry) { return entry.second.mesh.expired(); });
  const auto clusters = std::make_shared<const MeshClusters>(make_clusters(*mesh));
  entries_[mesh.get()] = {mesh, clusters};
  return clusters;
}

}  // namespace scanlit
