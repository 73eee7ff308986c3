// The order in which a mesh's triangles are cut into clusters.
#pragma once

#include <cstdint>
#include <vector>

#include "rasterizer/mesh.h"

namespace scanlit {

/// The mesh's triangles along a curve that keeps neighbours together, one connected piece of the
/// surface after another: sheets that lie close, one behind the other, stay apart.
struct ClusterOrder {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> section_ends;  // in `triangles`; no cluster should reach beyond one
};
ClusterOrder cluster_order(const Mesh& mesh);

/// Where (x, y, z) lies along Hilbert's curve through a cube of (2^hilbert_bits)^3 cells.
constexpr int hilbert_bits = 14;
std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y, std::uint32_t z);

}  // namespace scanlit
