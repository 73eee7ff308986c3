// (6) Assembly: the vertices of a cluster become triangles; what cannot be seen is dropped, what is
// cut is cut (4), and the rest is sorted into the tiles it may touch.
#include <algorithm>

#include "rasterizer/binning.h"
#include "rasterizer/cluster_culling.h"
#include "rasterizer/occlusion.h"
#include "rasterizer/shading.h"
#include "rasterizer/site_finder.h"
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
    sites_.end_chunk();
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
    sites_.begin_cluster(cluster);
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

  /// Triangles that lie in one tile go there together: most clusters do as a whole.
  void add_drawn() {
    const TileGrid& grid = frame_.grid;
    const Rect& box = culled_.box;
    TilesOfTriangles tiles(culled_, grid);
    for (int row = grid.row(box.y_begin); row <= grid.row(box.y_end - 1); ++row)
      for (int column = grid.column(box.x_begin); column <= grid.column(box.x_end - 1); ++column) {
        const auto begin = std::uint32_t(chunk_.triangles.size());
        record_drawn(tiles.in(row * grid.columns + column));
        const auto end = std::uint32_t(chunk_.triangles.size());
        if (begin == end) continue;
        const auto pixels = std::int64_t(culled_.pixels) * (end - begin) / culled_.drawn_count;
        binner_.add({begin, end, vertices_.nearest, intersection(box, grid.tile(column, row)),
                     std::int32_t(pixels)});
      }
    const auto places = tiles.in(TilesOfTriangles::several);
    const auto first = std::uint32_t(chunk_.triangles.size());
    record_drawn(places);
    for (std::uint32_t k = 0; k < places.size(); ++k) place(first + k, culled_.box_of(places[k]));
  }

  /// A triangle, or a piece of one, that need not be cut.
  Fate add_whole(const ScreenTriangle& t, int local, std::uint32_t piece) {
    const Fate fate = cull(t, draw_, frame_.viewport, frame_.settings.samples);
    if (fate == Fate::drawn || !skips().unseen_triangles) {
      const bool behind = (t.twice_area < 0) != draw_.mirrored;
      record(t.vertices[0], t.vertices[1], t.vertices[2], local, piece,
             *appended(chunk_.triangles, 1));
      sites_.add(
          1, [&](std::size_t) { return local; }, [&](std::size_t) { return behind; });
      // What hits no sample position and was not dropped has a place all the same: its box's
      // pixels.
      const int samples = skips().unseen_triangles ? frame_.settings.samples : 0;
      place(std::uint32_t(chunk_.triangles.size() - 1),
            intersection(pixel_bounds(t, samples), picture_rect(frame_.viewport)));
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

  /// Of the triangles that are drawn, those at these places are to be scan-converted.
  void record_drawn(std::span<const std::int32_t> places) {
    const auto local = [&](std::size_t i) { return culled_.drawn[places[i]]; };
    const auto vertex = [&](std::size_t i, int corner) -> const ScreenVertex& {
      return vertices_.screen[local_vertex(local(i), corner)];
    };
    DrawnTriangle* const drawn = appended(chunk_.triangles, places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      record(vertex(i, 0), vertex(i, 1), vertex(i, 2), local(i), DrawnTriangle::not_cut, drawn[i]);
    sites_.add(places.size(), local,
               [&](std::size_t i) { return culled_.from_behind[places[i]] != 0; });
  }

  void record(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, int local,
              std::uint32_t piece, DrawnTriangle& drawn) const {
    // Vertex by vertex into its place: 16 bytes at once.
    drawn.vertices[0] = a;
    drawn.vertices[1] = b;
    drawn.vertices[2] = c;
    drawn.draw = draw_.index;
    drawn.triangle = numbers_[local];
    drawn.chunk = chunk_.index;
    drawn.piece = piece;
  }

  /// Into its tiles goes a triangle of the chunk.
  void place(std::uint32_t number, const Rect& pixels) {
    if (pixels.empty()) return;
    const auto& [a, b, c] = chunk_.triangles[number].vertices;
    const float nearest = std::max({a.depth, b.depth, c.depth});
    binner_.add({number, number + 1, nearest, pixels, std::int32_t(area(pixels))});
  }

  const Frame& frame_;
  const Draw& draw_;
  Chunk& chunk_;
  ClusterVertices& vertices_;
  CulledCluster& culled_;
  Binner& binner_;
  ClusterCuller culler_;
  SiteFinder sites_{draw_, chunk_.lit};
  // Of the present cluster: its triangles' corners, as numbers of its vertices, and their numbers
  // in the mesh.
  const Cluster* cluster_ = nullptr;
  const std::uint8_t* corners_[3]{};
  const std::uint32_t* numbers_ = nullptr;
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
