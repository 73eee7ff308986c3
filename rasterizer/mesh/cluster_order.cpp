// First along Morton's curve, which is cheap and sorts any number of triangles into blocks that
// stay in the cache; then each block is halved and halved again, which is what makes the groups
// compact. Of a sphere of a million triangles, groups of 128 have .80 vertices a triangle along
// Morton's curve alone and .81 along Hilbert's, which takes longer; halved blocks have .73. (The
// least, squares of 8 x 8 quadrilaterals, is .63.)
#include "rasterizer/mesh/cluster_order.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <glm/common.hpp>

#include "rasterizer/mesh/connected_pieces.h"

namespace scanlit {

namespace {

/// Fewer triangles that hang together than this are no surface: facets whose vertices are not
/// shared, leaves, hairs. They are sorted by place alone, so that groups of them are full.
constexpr std::uint32_t smallest_piece = 128;

constexpr std::uint32_t largest_block = 4096;

struct Box {
  glm::vec3 low, high;

  explicit Box(const glm::vec3& p) : low(p), high(p) {}
  void add(const glm::vec3& p) { low = glm::min(low, p), high = glm::max(high, p); }
  glm::vec3 extent() const { return high - low; }
};

float largest(const glm::vec3& v) { return std::max({v.x, v.y, v.z}); }

struct Key {
  std::uint64_t place;  // number of the piece, then place on the curve
  std::uint32_t triangle;

  friend bool operator<(const Key& a, const Key& b) {
    return a.place != b.place ? a.place < b.place : a.triangle < b.triangle;
  }
};

// Cells along each side of the curve's cube: 2^14. Above the 42 bits of a place on the curve there
// is room for the numbers of 2^22 pieces; more would merely share numbers.
constexpr int cell_bits = 14;
constexpr int place_bits = 3 * cell_bits;

/// Bit i goes to bit 3 i; of cell_bits bits.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x001f00000000ffff;
  bits = (bits | bits << 16) & 0x001f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

std::vector<Key> sorted_keys(const Mesh& mesh) {
  std::vector<Key> keys(mesh.triangle_count());
  if (keys.empty()) return keys;
  const std::vector<std::uint32_t> piece = connected_pieces(mesh, smallest_piece);
  Box box(mesh.positions[mesh.indices[0]]);
  for (const glm::vec3& p : mesh.positions) box.add(p);
  constexpr float last_cell = (1 << cell_bits) - 1;
  const float cells_per_length = last_cell / largest(box.extent());

  tbb::parallel_for(std::size_t(0), keys.size(), [&](std::size_t t) {
    const std::uint32_t* v = &mesh.indices[3 * t];
    const auto cell = [&](int axis) {
      const float sum =
          mesh.positions[v[0]][axis] + mesh.positions[v[1]][axis] + mesh.positions[v[2]][axis];
      const float cells = (sum / 3 - box.low[axis]) * cells_per_length;
      return cells > 0 ? std::uint64_t(std::min(cells, last_cell)) : 0;  // NaN becomes 0
    };
    const std::uint64_t place = spread(cell(0)) << 2 | spread(cell(1)) << 1 | spread(cell(2));
    keys[t] = {std::uint64_t(piece[v[0]]) << place_bits | place, std::uint32_t(t)};
  });
  tbb::parallel_sort(keys);
  return keys;
}

/// A triangle's centroid, and the mean of its vertices' normals: those of a rough surface differ
/// less than those of its triangles, which are better not sorted by direction.
struct Facet {
  glm::vec3 place[2];
  std::uint32_t triangle;
};

struct Halving {
  Facet* facets;
  float normal_scale;  // length that differs as much as normals do by 1
  std::uint32_t largest_group;
  std::vector<std::uint32_t> ends;

  /// Halves [begin, end) where it is longest, until groups are small enough; once more where a
  /// group bends so much that hardly any view shows only its back: on a sphere of 2,000 triangles a
  /// third of all groups face away then, not an eighth.
  void halve(std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t size = end - begin;
    Box centroids(facets[begin].place[0]), normals(facets[begin].place[1]);
    for (std::uint32_t i = begin + 1; i < end; ++i) {
      centroids.add(facets[i].place[0]);
      normals.add(facets[i].place[1]);
    }
    const bool bent = largest(normals.extent()) > 0.75f;
    const std::uint32_t enough = bent ? largest_group / 2 : largest_group;
    if (size <= enough) {
      ends.push_back(end);
      return;
    }
    const std::uint32_t groups = (size + enough - 1) / enough;
    const glm::vec3 extents[2] = {centroids.extent(), normals.extent() * normal_scale};
    const int kind = largest(extents[1]) > largest(extents[0]);
    const glm::vec3& e = extents[kind];
    const int axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;

    const std::uint32_t middle = begin + std::uint32_t(std::uint64_t(size) * (groups / 2) / groups);
    std::nth_element(facets + begin, facets + middle, facets + end,
                     [=](const Facet& a, const Facet& b) {
                       const float a_place = a.place[kind][axis], b_place = b.place[kind][axis];
                       return a_place != b_place ? a_place < b_place : a.triangle < b.triangle;
                     });
    halve(begin, middle);
    halve(middle, end);
  }
};

/// Regroups triangles[0, size); returns the groups' ends.
std::vector<std::uint32_t> halve_block(const Mesh& mesh, std::uint32_t* triangles,
                                       std::uint32_t size, std::uint32_t largest_group) {
  std::vector<Facet> facets(size);
  Box box(mesh.positions[mesh.indices[3 * std::size_t(triangles[0])]]);
  for (std::uint32_t i = 0; i < size; ++i) {
    Facet& facet = facets[i];
    facet = {.place = {glm::vec3(0), glm::vec3(0)}, .triangle = triangles[i]};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t vertex = mesh.indices[3 * std::size_t(triangles[i]) + c];
      facet.place[0] += mesh.positions[vertex] / 3.0f;
      facet.place[1] += mesh.normals[vertex] / 3.0f;
    }
    box.add(facet.place[0]);
  }
  // Opposite normals, whose distance is 2, count as much as this share of the block's extent: more
  // divides a thick plate into its sides before its parts are compact, less never does.
  const float opposite = 0.6f;
  Halving halving{facets.data(), opposite / 2 * largest(box.extent()), largest_group, {}};
  halving.halve(0, size);
  for (std::uint32_t i = 0; i < size; ++i) triangles[i] = facets[i].triangle;
  return std::move(halving.ends);
}

/// Ends of blocks of nearly equal size, each of one piece of the surface.
std::vector<std::uint32_t> block_ends(const std::vector<Key>& keys) {
  std::vector<std::uint32_t> ends;
  std::size_t begin = 0;
  for (std::size_t end = 1; end <= keys.size(); ++end) {
    if (end < keys.size() && keys[end].place >> place_bits == keys[begin].place >> place_bits)
      continue;
    const std::size_t size = end - begin, blocks = (size + largest_block - 1) / largest_block;
    for (std::size_t i = 1; i <= blocks; ++i)
      ends.push_back(std::uint32_t(begin + size * i / blocks));
    begin = end;
  }
  return ends;
}

}  // namespace

ClusterOrder cluster_order(const Mesh& mesh, std::uint32_t largest_group) {
  ClusterOrder order;
  order.triangles.resize(mesh.triangle_count());
  std::vector<std::uint32_t> blocks;
  {
    const std::vector<Key> keys = sorted_keys(mesh);
    for (std::size_t i = 0; i < keys.size(); ++i) order.triangles[i] = keys[i].triangle;
    blocks = block_ends(keys);
  }  // their memory is of use to what follows
  std::vector<std::vector<std::uint32_t>> ends(blocks.size());
  const auto begin = [&](std::size_t block) { return block == 0 ? 0 : blocks[block - 1]; };
  tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t b) {
    ends[b] = halve_block(mesh, &order.triangles[begin(b)], blocks[b] - begin(b), largest_group);
  });
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (const std::uint32_t end : ends[b]) order.ends.push_back(begin(b) + end);
  return order;
}

}  // namespace scanlit
