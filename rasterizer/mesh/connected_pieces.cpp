#include "rasterizer/mesh/connected_pieces.h"

#include <algorithm>
#include <numeric>

namespace scanlit {

namespace {

/// For each vertex the lowest vertex that triangles connect it to: union-find, with halved paths.
/// (Robert Tarjan, Jan van Leeuwen, "Worst-case analysis of set union algorithms", JACM 31(2),
/// 1984.)
std::vector<std::uint32_t> lowest_connected(const Mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    parent[high] = low;
    return low;
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::uint32_t joined = join(root(mesh.indices[i]), root(mesh.indices[i + 1]));
    join(joined, root(mesh.indices[i + 2]));
  }
  // Parents come before their children, and are roots by then.
  for (std::uint32_t& v : parent) v = parent[v];
  return parent;
}

}  // namespace

std::vector<std::uint32_t> connected_pieces(const Mesh& mesh, std::uint32_t smallest) {
  std::vector<std::uint32_t> piece = lowest_connected(mesh);
  std::vector<std::uint32_t> size(piece.size());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) ++size[piece[mesh.indices[i]]];
  std::uint32_t last = 0;
  for (std::size_t v = 0; v < piece.size(); ++v) {
    const bool is_root = piece[v] == v;
    piece[v] = !is_root ? piece[piece[v]] : size[v] < smallest ? 0 : ++last;
  }
  return piece;
}

}  // namespace scanlit
