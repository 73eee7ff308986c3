// The order in which a mesh's triangles are cut into clusters.
#pragma once

#include <cstdint>
#include <vector>

#include "rasterizer/mesh.h"

namespace scanlit {

/// The mesh's triangles in compact groups of nearly equal size, one after another. Sheets that lie
/// close behind one another stay apart: where no triangles connect them always, otherwise where
/// their normals differ.
struct ClusterOrder {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> ends;  // of the groups, in `triangles`
};
ClusterOrder cluster_order(const Mesh& mesh, std::uint32_t largest_group);

}  // namespace scanlit
