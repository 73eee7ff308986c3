// (6), (9) Assembly: the sites at which the triangles of a flat or a Gouraud object are lit.
#pragma once

#include <algorithm>

#include "rasterizer/pipeline.h"

namespace scanlit {

/// Makes room for `count` more at once, in which to write them: push_back would ask each time
/// whether there is room.
template <class T>
T* appended(std::vector<T>& to, std::size_t count) {
  to.resize(to.size() + count);
  return to.data() + to.size() - count;
}

/// Fills a chunk's LitSites, cluster by cluster.
class SiteFinder {
 public:
  SiteFinder(const Draw& draw, LitSites& lit)
      : clusters_(*draw.clusters), shading_(draw.object->shading), lit_(lit) {}

  void begin_cluster(const Cluster& cluster) {
    for (int k = 0; k < 3; ++k) corners_[k] = &clusters_.corners[k][cluster.first_triangle];
    triangles_ = &clusters_.triangles[cluster.first_triangle];
    vertices_ = &clusters_.vertices[cluster.first_vertex];
    if (shading_ != Shading::gouraud) return;
    for (auto& side : site_of_) std::fill_n(side, cluster.vertex_count, no_site);
    lit_.sites.resize(count_ + 2 * std::size_t(cluster.vertex_count) + 1);
  }

  /// For triangles that are drawn: the i-th has number local(i) in the cluster.
  template <class Local, class FromBehind>
  void add(std::size_t count, const Local& local, const FromBehind& from_behind) {
    if (shading_ == Shading::flat) {
      LitSites::Site* const sites = appended(lit_.sites, count);
      for (std::size_t i = 0; i < count; ++i) sites[i] = {triangles_[local(i)], from_behind(i)};
    } else if (shading_ == Shading::gouraud) {
      add_vertices(count, local, from_behind);
    }
  }

  void end_chunk() {
    if (shading_ == Shading::gouraud) lit_.sites.resize(count_);
  }

 private:
  template <class Local, class FromBehind>
  void add_vertices(std::size_t count, const Local& local, const FromBehind& from_behind) {
    std::uint16_t* corner = appended(lit_.corners, 3 * count);
    LitSites::Site* const sites = lit_.sites.data();
    std::uint32_t next = count_;
    for (std::size_t i = 0; i < count; ++i) {
      const bool behind = from_behind(i);
      // A site is made when first asked for. Whether that is so cannot be foreseen: no branch.
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t vertex = corners_[k][local(i)], known = site_of_[behind][vertex];
        const bool is_new = known == no_site;
        const std::uint32_t site = is_new ? next : known;
        sites[next] = {vertices_[vertex], behind};
        site_of_[behind][vertex] = site;
        next += is_new;
        *corner++ = std::uint16_t(site);
      }
    }
    count_ = next;
  }

  static constexpr std::uint32_t no_site = 0xffffffffu;

  const MeshClusters& clusters_;
  const Shading shading_;
  LitSites& lit_;
  std::uint32_t count_ = 0;  // Gouraud: lit_.sites is longer, for one more to be put behind them
  // Of the present cluster: its triangles' corners, as numbers of its vertices, and the mesh's
  // numbers of both.
  const std::uint8_t* corners_[3]{};
  const std::uint32_t *triangles_ = nullptr, *vertices_ = nullptr;
  std::uint32_t site_of_[2][ClusterVertices::capacity];  // of each vertex, from each side
};

}  // namespace scanlit
