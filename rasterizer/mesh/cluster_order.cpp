#include "rasterizer/mesh/cluster_order.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <glm/common.hpp>
#include <numeric>

namespace scanlit {

namespace {

/// Fewer triangles that hang together than this are no surface: facets whose vertices are not
/// shared, leaves, hairs. They are sorted by place alone, so that clusters of them are full.
constexpr std::uint32_t smallest_piece = 128;

/// For each vertex the lowest vertex that it is connected to by triangles: union-find, with halved
/// paths. (Robert Tarjan, Jan van Leeuwen, "Worst-case analysis of set union algorithms", JACM
/// 31(2), 1984.)
std::vector<std::uint32_t> connected_pieces(const Mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    parent[std::max(a, b)] = std::min(a, b);
    return std::min(a, b);
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::uint32_t a = join(root(mesh.indices[i]), root(mesh.indices[i + 1]));
    join(a, root(mesh.indices[i + 2]));
  }
  // Parents come before their children.
  for (std::uint32_t& v : parent) v = parent[v];
  return parent;
}

/// For each vertex the number of its piece of the surface, from 1 in the order of the mesh; 0 for
/// all that are too small.
std::vector<std::uint32_t> number_pieces(const Mesh& mesh) {
  std::vector<std::uint32_t> piece = connected_pieces(mesh);
  std::vector<std::uint32_t> size(piece.size());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) ++size[piece[mesh.indices[i]]];
  std::uint32_t last = 0;
  for (std::size_t v = 0; v < piece.size(); ++v) {
    const bool is_root = piece[v] == v;
    piece[v] = !is_root ? piece[piece[v]] : size[v] < smallest_piece ? 0 : ++last;
  }
  return piece;
}

struct Key {
  std::uint64_t place;  // number of the piece, then place on the curve
  std::uint32_t triangle;

  friend bool operator<(const Key& a, const Key& b) {
    return a.place != b.place ? a.place < b.place : a.triangle < b.triangle;
  }
};
constexpr int place_bits = 3 * hilbert_bits;

/// Cells of the curve's cube, whose sides are those of the mesh's longest extent.
class Grid {
 public:
  explicit Grid(const Mesh& mesh) {
    glm::vec3 high(low_);
    if (!mesh.positions.empty()) low_ = high = mesh.positions[0];
    for (const glm::vec3& p : mesh.positions) low_ = glm::min(low_, p), high = glm::max(high, p);
    const glm::dvec3 extent = glm::dvec3(high) - glm::dvec3(low_);
    const double longest = std::max({extent.x, extent.y, extent.z});
    if (longest > 0) cells_per_length_ = ((1 << hilbert_bits) - 1) / longest;
  }
  std::uint32_t cell(const glm::dvec3& p, int axis) const {
    const double cell = (p[axis] - low_[axis]) * cells_per_length_;
    // So that NaN becomes 0.
    return cell > 0 ? std::uint32_t(std::min(cell, double((1 << hilbert_bits) - 1))) : 0;
  }

 private:
  glm::vec3 low_{0};
  double cells_per_length_ = 0;
};

std::vector<Key> sorted_keys(const Mesh& mesh) {
  const std::vector<std::uint32_t> piece = number_pieces(mesh);
  const Grid grid(mesh);
  std::vector<Key> keys(mesh.triangle_count());
  tbb::parallel_for(std::size_t(0), keys.size(), [&](std::size_t t) {
    const std::uint32_t* v = &mesh.indices[3 * t];
    const glm::dvec3 a(mesh.positions[v[0]]), b(mesh.positions[v[1]]), c(mesh.positions[v[2]]);
    const glm::dvec3 centroid = (a + b + c) / 3.0;
    const std::uint64_t place =
        hilbert_index(grid.cell(centroid, 0), grid.cell(centroid, 1), grid.cell(centroid, 2));
    keys[t] = {std::uint64_t(piece[v[0]]) << place_bits | place, std::uint32_t(t)};
  });
  tbb::parallel_sort(keys);
  return keys;
}

}  // namespace

// John Skilling, "Programming the Hilbert curve", AIP Conference Proceedings 707, 2004: the cube's
// cells are turned and mirrored level by level, without a table, then Gray-coded.
std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  std::uint32_t axes[3] = {x, y, z};
  for (std::uint32_t bit = 1u << (hilbert_bits - 1); bit > 1; bit >>= 1) {
    const std::uint32_t below = bit - 1;
    for (std::uint32_t& axis : axes) {
      // Mirror the first axis where the bit is set, and exchange it with this one where it is not.
      const std::uint32_t is_set = axis & bit ? below : 0;
      const std::uint32_t exchange = (axes[0] ^ axis) & below & ~is_set;
      axes[0] ^= is_set | exchange;
      axis ^= exchange;
    }
  }
  axes[1] ^= axes[0];
  axes[2] ^= axes[1];
  std::uint32_t parity = 0;
  for (std::uint32_t bit = 1u << (hilbert_bits - 1); bit > 1; bit >>= 1)
    parity ^= axes[2] & bit ? bit - 1 : 0;

  std::uint64_t index = 0;
  for (int bit = hilbert_bits - 1; bit >= 0; --bit)
    for (const std::uint32_t axis : axes) index = index << 1 | ((axis ^ parity) >> bit & 1);
  return index;
}

ClusterOrder cluster_order(const Mesh& mesh) {
  const std::vector<Key> keys = sorted_keys(mesh);
  ClusterOrder order;
  order.triangles.resize(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    order.triangles[i] = keys[i].triangle;
    const bool last = i + 1 == keys.size();
    if (last || keys[i].place >> place_bits != keys[i + 1].place >> place_bits)
      order.section_ends.push_back(std::uint32_t(i + 1));
  }
  return order;
}

}  // namespace scanlit
