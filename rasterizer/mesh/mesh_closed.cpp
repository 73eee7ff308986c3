#include "rasterizer/mesh/mesh_closed.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <tuple>

namespace scanlit::detail {
namespace {

/// For each vertex the first one at its position.
std::vector<std::uint32_t> welded(const std::vector<glm::vec3>& positions) {
  std::vector<std::uint32_t> order(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = std::uint32_t(i);
  const auto place = [&](std::uint32_t i) {
    return std::tie(positions[i].x, positions[i].y, positions[i].z);
  };
  std::ranges::sort(order, [&](auto a, auto b) {
    return place(a) < place(b) || (place(a) == place(b) && a < b);
  });
  std::vector<std::uint32_t> first(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] =
        i > 0 && place(order[i - 1]) == place(order[i]) ? first[order[i - 1]] : order[i];
  return first;
}

}  // namespace

Closedness closedness(const Mesh& mesh) {
  const std::vector<std::uint32_t> vertex = welded(mesh.positions);
  // Lower vertex, higher vertex, and in the last bit which way the triangle runs along the edge. A
  // mesh has fewer than 2^31 vertices: OpenMesh counts them in an int.
  std::vector<std::uint64_t> edges;
  edges.reserve(mesh.indices.size());
  const glm::dvec3 origin = mesh.positions.front();  // any point; a near one keeps the sum exact
  double volume = 0;                                 // six times
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::array v = {vertex[mesh.indices[i]], vertex[mesh.indices[i + 1]],
                          vertex[mesh.indices[i + 2]]};
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t from = v[k], to = v[(k + 1) % 3];
      edges.push_back(std::min(from, to) << 33 | std::max(from, to) << 1 | (from < to ? 0 : 1));
    }
    const glm::dvec3 a = mesh.positions[v[0]], b = mesh.positions[v[1]], c = mesh.positions[v[2]];
    volume += glm::dot(a - origin, glm::cross(b - origin, c - origin));
  }
  std::ranges::sort(edges);
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    const bool paired = i + 1 < edges.size() && edges[i + 1] == (edges[i] | 1);
    if (!paired || edges[i] % 2 == 1) return Closedness::open;
  }
  return volume > 0 ? Closedness::outward : volume < 0 ? Closedness::inside_out : Closedness::open;
}

}  // namespace scanlit::detail
