// (6) Assembly: the vertices of a cluster become triangles; what cannot be seen is dropped, what is
// cut is cut (4), and the rest is sorted into the tiles it may touch.
#include <algorithm>

#include "rasterizer/binning.h"
#include "rasterizer/cluster_culling.h"
#include "rasterizer/occlusion.h"
#include "rasterizer/shading.h"
#include "rasterizer/stage_timer.h"
#include "rasterizer/triangle_culling.h"

namespace scanlit {

namespace {

/// What a thread keeps from chunk to chunk.
struct Scratch {
  ClusterVertices vertices;
  CulledCluster culled;
  Binner binner;
};

class Assembler {
 public:
  Assembler(const Frame& frame, Chunk& chunk, Scratch& scratch)
      : frame_(frame),
        draw_(*chunk.draw),
        chunk_(chunk),
        vertices_(scratch.vertices),
        culled_(scratch.culled),
        binner_(scratch.binner),
        culler_(draw_, frame.viewport) {}

  void run() {
    binner_.begin_chunk(frame_.grid);
    const auto& clusters = draw_.clusters->clusters;
    for (std::uint32_t i = chunk_.first_cluster; i < chunk_.end_cluster; ++i) add(clusters[i]);
    binner_.end_chunk(chunk_);
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
    if (view == ClusterView::inside && is_hidden(cluster)) {
      counts.behind += cluster.triangle_count;
      ++counts.clusters_hidden;
      return;
    }
    cluster_ = &cluster;
    for (int i = 0; i < 3; ++i) corners_[i] = &draw_.clusters->corners[i][cluster.first_triangle];
    numbers_ = &draw_.clusters->triangles[cluster.first_triangle];
    binner_.begin_cluster();
    if (shading_ == Shading::gouraud)
      for (auto& side : site_of_) std::fill_n(side, cluster.vertex_count, no_site);
    transform_vertices(draw_, cluster, frame_.viewport, vertices_);
    counts.vertices += cluster.vertex_count;
    if (vertices_.any_outcode == 0 && skips().clip_tests && skips().unseen_triangles)
      add_whole();
    else
      for (int i = 0; i < int(cluster.triangle_count); ++i) add_with_outcodes(i);
  }

  bool is_hidden(const Cluster& cluster) const {
    return frame_.occlusion && !draw_.occluder &&
           frame_.occlusion->hides(
               culler_.screen_bounds({glm::dvec3(cluster.centre), double(cluster.radius)}));
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
    if (culled_.drawn_count > 0) add_drawn();
    for (int i = 0; i < culled_.large_count; ++i)
      count(add_whole(screen(culled_.large[i]), culled_.large[i], DrawnTriangle::not_cut));
  }

  /// Most clusters lie in one tile: their triangles need not be looked at one by one.
  void add_drawn() {
    const Rect box = intersection(culled_.box, picture_rect(frame_.viewport));
    const bool in_one_tile = binner_.in_one_tile(box);
    const auto begin = std::uint32_t(chunk_.triangles.size());
    for (int i = 0; i < culled_.drawn_count; ++i) {
      const ScreenTriangle t = screen(culled_.drawn[i]);
      record(t, culled_.drawn[i], DrawnTriangle::not_cut);
      if (!in_one_tile) place(t);
    }
    const auto end = std::uint32_t(chunk_.triangles.size());
    if (in_one_tile) binner_.add({begin, end, vertices_.nearest, box, culled_.pixels});
  }

  /// A triangle, or a piece of one, that need not be cut.
  Fate add_whole(const ScreenTriangle& t, int local, std::uint32_t piece) {
    const Fate fate = cull(t, draw_, frame_.viewport, frame_.settings.samples);
    if (fate == Fate::drawn || !skips().unseen_triangles) {
      record(t, local, piece);
      place(t);
    }
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

  std::uint32_t local_vertex(int local, int corner) const { return corners_[corner][local]; }
  ScreenTriangle screen(int local) const {
    const ScreenVertex* v = vertices_.screen;
    return screen_triangle(v[local_vertex(local, 0)], v[local_vertex(local, 1)],
                           v[local_vertex(local, 2)]);
  }

  /// The triangle, or piece, is to be scan-converted.
  void record(const ScreenTriangle& t, int local, std::uint32_t piece) {
    // Vertex by vertex into its place: 16 bytes at once.
    DrawnTriangle& drawn = chunk_.triangles.emplace_back();
    drawn.vertices[0] = t.vertices[0];
    drawn.vertices[1] = t.vertices[1];
    drawn.vertices[2] = t.vertices[2];
    drawn.draw = draw_.index;
    drawn.triangle = numbers_[local];
    drawn.chunk = chunk_.index;
    drawn.piece = piece;
    const bool behind = (t.twice_area < 0) != draw_.mirrored;
    if (shading_ == Shading::flat)
      chunk_.lit.sites.push_back({drawn.triangle, behind});
    else if (shading_ == Shading::gouraud)
      for (int corner = 0; corner < 3; ++corner)
        chunk_.lit.corners.push_back(
            std::uint16_t(vertex_site(local_vertex(local, corner), behind)));
  }

  /// Into its tiles goes the triangle that was recorded last.
  void place(const ScreenTriangle& t) {
    // What hits no sample position and was not dropped has a place all the same: its box's pixels.
    const int samples = skips().unseen_triangles ? frame_.settings.samples : 0;
    const Rect r = intersection(pixel_bounds(t, samples), picture_rect(frame_.viewport));
    if (r.empty()) return;
    const float nearest = std::max({t.vertices[0].depth, t.vertices[1].depth, t.vertices[2].depth});
    const auto end = std::uint32_t(chunk_.triangles.size());
    binner_.add({end - 1, end, nearest, r, std::int32_t(area(r))});
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

  static constexpr std::uint32_t no_site = 0xffffffffu;

  const Frame& frame_;
  const Draw& draw_;
  Chunk& chunk_;
  ClusterVertices& vertices_;
  CulledCluster& culled_;
  Binner& binner_;
  ClusterCuller culler_;
  Shading shading_ = draw_.object->shading;
  // Of the present cluster: its triangles' corners, as numbers of its vertices, and their numbers
  // in the mesh.
  const Cluster* cluster_ = nullptr;
  const std::uint8_t* corners_[3]{};
  const std::uint32_t* numbers_ = nullptr;
  std::uint32_t site_of_[2][ClusterVertices::capacity];
};

/// A chunk of an object that lies outside of the view, or is hidden.
void skip_whole(Chunk& chunk) {
  FrameStats& counts = chunk.counts;
  const auto& clusters = chunk.draw->clusters->clusters;
  for (std::uint32_t i = chunk.first_cluster; i < chunk.end_cluster; ++i)
    counts.triangles += clusters[i].triangle_count;
  if (chunk.draw->outside) {
    counts.outside = counts.triangles;
  } else {
    counts.behind = counts.triangles;
    counts.clusters = counts.clusters_hidden = chunk.end_cluster - chunk.first_cluster;
  }
}

}  // namespace

void assemble(const Frame& frame, Chunk& chunk, FrameStats& stats) {
  thread_local Scratch scratch;
  chunk.triangles.clear();
  chunk.pieces.clear();
  chunk.lit.sites.clear();
  chunk.lit.corners.clear();
  chunk.bins.clear();
  chunk.counts = {};
  if (chunk.draw->outside || chunk.draw->hidden) return skip_whole(chunk);
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
