// Which triangles of a mesh hang together.
#pragma once

#include <cstdint>
#include <vector>

#include "rasterizer/mesh.h"

namespace scanlit {

/// For each vertex the number of the piece of surface it belongs to: from 1, in the order of the
/// mesh, where triangles that share vertices make a piece of at least `smallest` triangles; 0
/// elsewhere.
std::vector<std::uint32_t> connected_pieces(const Mesh& mesh, std::uint32_t smallest);

}  // namespace scanlit
