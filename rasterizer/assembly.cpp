// (6) Assembly: the vertices of a cluster become triangles; what cannot be seen is dropped, what is
// cut is cut (4), and the rest is sorted into the tiles it may touch.
#include <algorithm>
#include <limits>

#include "rasterizer/cluster_culling.h"
#include "rasterizer/shading.h"
#include "rasterizer/stage_timer.h"
#include "rasterizer/triangle_culling.h"

namespace scanlit {

namespace {

/// A triangle's place in one tile, before the tiles are in order.
struct Placed {
  std::uint32_t tile;
  BinEntry entry;
};

/// What a thread keeps from chunk to chunk.
struct Scratch {
  ClusterVertices vertices;
  CulledCluster culled;
  std::vector<Placed> placed;
  std::vector<Bin> bins;  // of all tiles; empty between chunks
};

class Assembler {
 public:
  Assembler(const Frame& frame, Chunk& chunk, Scratch& scratch)
      : frame_(frame),
        draw_(*chunk.draw),
        chunk_(chunk),
        vertices_(scratch.vertices),
        culled_(scratch.culled),
        placed_(scratch.placed),
        bins_(scratch.bins),
        culler_(draw_, frame.viewport) {}

  void run() {
    placed_.clear();
    bins_.resize(std::max(bins_.size(), std::size_t(frame_.grid.count())));
    const auto& clusters = draw_.clusters->clusters;
    for (std::uint32_t i = chunk_.first_cluster; i < chunk_.end_cluster; ++i) add(clusters[i]);
    sort_into_bins();
  }

 private:
  const Skips& skips() const { return frame_.settings.skips; }

  void add(const Cluster& cluster) {
    FrameStats& counts = chunk_.counts;
    counts.triangles += cluster.triangle_count;
    ++counts.clusters;
    const ClusterView view = culler_.view(cluster);
    if (view == ClusterView::outside && skips().outside_clusters) {
      counts.outside += cluster.triangle_count;
      ++counts.clusters_outside;
      return;
    }
    if (view == ClusterView::back_facing && skips().back_facing_clusters) {
      counts.back_facing += cluster.triangle_count;
      ++counts.clusters_back_facing;
      return;
    }
    cluster_ = &cluster;
    if (chunk_.draw->object->shading == Shading::gouraud)
      for (auto& side : site_of_) std::fill_n(side, cluster.vertex_count, no_site);
    transform_vertices(draw_, cluster, frame_.viewport, vertices_);
    counts.vertices += cluster.vertex_count;
    if (vertices_.any_outcode == 0 && skips().clip_tests && skips().unseen_triangles)
      add_whole();
    else
      for (int i = 0; i < int(cluster.triangle_count); ++i) add_with_outcodes(i);
  }

  /// A cluster none of whose vertices is outside of anything.
  void add_whole() {
    FrameStats& counts = chunk_.counts;
    culled_.drawn_count = culled_.large_count = 0;
    culled_.outside = culled_.no_pixel = culled_.back_facing = 0;
    cull_cluster(draw_, *cluster_, vertices_, frame_.viewport, frame_.settings.samples, culled_);
    counts.outside += culled_.outside;
    counts.no_pixel += culled_.no_pixel;
    counts.back_facing += culled_.back_facing;
    counts.drawn += culled_.drawn_count;
    for (int i = 0; i < culled_.drawn_count; ++i) {
      const ScreenTriangle t = screen(culled_.drawn[i]);
      emit(t, culled_.drawn[i], DrawnTriangle::not_cut);
    }
    for (int i = 0; i < culled_.large_count; ++i)
      count(add_whole(screen(culled_.large[i]), culled_.large[i], DrawnTriangle::not_cut));
  }

  /// A triangle, or a piece of one, that need not be cut.
  Fate add_whole(const ScreenTriangle& t, int local, std::uint32_t piece) {
    const Fate fate = cull(t, draw_, frame_.viewport, frame_.settings.samples);
    if (fate == Fate::drawn || !skips().unseen_triangles) emit(t, local, piece);
    return fate;
  }

  void add_with_outcodes(int local) {
    unsigned any = 0, all = 0xff;
    for (int corner = 0; corner < 3; ++corner) {
      const unsigned code = vertices_.outcodes[local_vertex(local, corner)];
      any |= code, all &= code;
    }
    if (any == 0) {
      count(add_whole(screen(local), local, DrawnTriangle::not_cut));
    } else if (all != 0 || (any & out_of_range) != 0) {
      count(Fate::outside);
    } else {
      count(add_cut(local, any));
    }
  }

  Fate add_cut(int local, unsigned outcodes) {
    ClipVertex corners[3];
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t local_v = local_vertex(local, corner);
      const std::uint32_t v = draw_.clusters->vertices[cluster_->first_vertex + local_v];
      corners[corner] = transform(draw_, draw_.mesh->positions[v]);
    }
    auto& pieces = chunk_.pieces;
    const std::size_t first = pieces.size();
    clip(corners, outcodes, frame_.viewport, pieces);
    Fate fate = Fate::outside;
    for (std::size_t i = first; i < pieces.size(); ++i) {
      const auto& v = pieces[i].vertices;
      fate = std::max(fate, add_whole(screen_triangle(v[0], v[1], v[2]), local, std::uint32_t(i)));
    }
    chunk_.counts.clipped += fate == Fate::drawn;
    return fate;
  }

  void count(Fate fate) {
    FrameStats& counts = chunk_.counts;
    switch (fate) {
      case Fate::outside: ++counts.outside; break;
      case Fate::no_pixel: ++counts.no_pixel; break;
      case Fate::back_facing: ++counts.back_facing; break;
      case Fate::drawn: ++counts.drawn; break;
    }
  }

  std::uint32_t local_vertex(int local, int corner) const {
    return draw_.clusters->corners[corner][cluster_->first_triangle + std::size_t(local)];
  }
  ScreenTriangle screen(int local) const {
    const ScreenVertex* v = vertices_.screen;
    return screen_triangle(v[local_vertex(local, 0)], v[local_vertex(local, 1)],
                           v[local_vertex(local, 2)]);
  }

  /// The triangle, or piece, is to be scan-converted: a record, its sites, its tiles.
  void emit(const ScreenTriangle& t, int local, std::uint32_t piece) {
    const std::uint32_t number =
        draw_.clusters->triangles[cluster_->first_triangle + std::size_t(local)];
    const auto record = std::uint32_t(chunk_.triangles.size());
    chunk_.triangles.push_back(
        {{t.vertices[0], t.vertices[1], t.vertices[2]}, draw_.index, number, chunk_.index, piece});
    const bool behind = (t.twice_area < 0) != draw_.mirrored;
    if (draw_.object->shading == Shading::flat)
      chunk_.lit.sites.push_back({number, behind});
    else if (draw_.object->shading == Shading::gouraud)
      for (int corner = 0; corner < 3; ++corner)
        chunk_.lit.corners.push_back(vertex_site(local_vertex(local, corner), behind));

    // What hits no sample position and was not dropped has a place all the same: its box's pixels.
    const int samples = skips().unseen_triangles ? frame_.settings.samples : 0;
    const Rect r = intersection(pixel_bounds(t, samples), picture_rect(frame_.viewport));
    if (r.empty()) return;
    const float nearest = std::max({t.vertices[0].depth, t.vertices[1].depth, t.vertices[2].depth});
    const TileGrid& grid = frame_.grid;
    for (int row = grid.row(r.y_begin); row <= grid.row(r.y_end - 1); ++row)
      for (int column = grid.column(r.x_begin); column <= grid.column(r.x_end - 1); ++column) {
        const int tile = row * grid.columns + column;
        const Rect pixels = intersection(r, grid.tile(column, row));
        Bin& bin = bins_[std::size_t(tile)];
        bin.touched = bin.end++ == 0 ? pixels : united(bin.touched, pixels);
        bin.pixels += area(pixels);
        first_tile_ = std::min(first_tile_, tile), last_tile_ = std::max(last_tile_, tile);
        placed_.push_back({std::uint32_t(tile), {record, nearest}});
      }
  }

  /// The site of a vertex of the present cluster: made when first asked for.
  std::uint32_t vertex_site(std::uint32_t local, bool behind) {
    std::uint32_t& site = site_of_[behind][local];
    if (site == no_site) {
      site = std::uint32_t(chunk_.lit.sites.size());
      const std::uint32_t v = draw_.clusters->vertices[cluster_->first_vertex + local];
      chunk_.lit.sites.push_back({v, behind});
    }
    return site;
  }

  /// A counting sort by tile; in each tile the order stays.
  void sort_into_bins() {
    chunk_.entries.resize(placed_.size());
    if (placed_.empty()) return;
    const auto first = bins_.begin() + first_tile_, end = bins_.begin() + last_tile_ + 1;
    chunk_.first_tile = first_tile_;
    chunk_.bins.assign(first, end);
    std::fill(first, end, Bin());
    std::uint32_t position = 0;
    for (Bin& bin : chunk_.bins) {
      const std::uint32_t size = bin.end;
      bin.begin = bin.end = position;
      position += size;
    }
    Bin* const bins = chunk_.bins.data() - first_tile_;
    for (const Placed& p : placed_) chunk_.entries[bins[p.tile].end++] = p.entry;
  }

  static constexpr std::uint32_t no_site = 0xffffffffu;

  const Frame& frame_;
  const Draw& draw_;
  Chunk& chunk_;
  ClusterVertices& vertices_;
  CulledCluster& culled_;
  std::vector<Placed>& placed_;
  std::vector<Bin>& bins_;
  int first_tile_ = std::numeric_limits<int>::max(), last_tile_ = 0;
  ClusterCuller culler_;
  const Cluster* cluster_ = nullptr;
  std::uint32_t site_of_[2][ClusterVertices::capacity];
};

}  // namespace

void assemble(const Frame& frame, Chunk& chunk, FrameStats& stats) {
  thread_local Scratch scratch;
  chunk.triangles.clear();
  chunk.pieces.clear();
  chunk.lit.sites.clear();
  chunk.lit.corners.clear();
  chunk.bins.clear();
  chunk.counts = {};
  if (chunk.draw->outside) {
    const auto& clusters = chunk.draw->clusters->clusters;
    for (std::uint32_t i = chunk.first_cluster; i < chunk.end_cluster; ++i)
      chunk.counts.triangles += clusters[i].triangle_count;
    chunk.counts.outside = chunk.counts.triangles;
    return;
  }
  {
    const StageTimer timer(stats, Stage::assembly);
    Assembler(frame, chunk, scratch).run();
  }
  light_chunk(frame, chunk, stats);
}

void light_chunk(const Frame& frame, Chunk& chunk, FrameStats& stats) {
  if (chunk.lit.sites.empty()) return;
  const StageTimer timer(stats, Stage::light_vertices);
  light_sites(frame, *chunk.draw, chunk.lit, stats);
}

}  // namespace scanlit
