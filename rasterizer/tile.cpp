#include "rasterizer/tile.h"

#include <algorithm>

#include "rasterizer/cost.h"
#include "rasterizer/frame_probe.h"
#include "rasterizer/scan_conversion.h"
#include "rasterizer/stage_timer.h"

namespace scanlit {

namespace {

/// Depth and ids of sample 0, where the framebuffer asks for them.
void write_visibility(const VisibilityTile& visibility, Framebuffer& framebuffer) {
  if (framebuffer.depth.empty() && framebuffer.object_id.empty()) return;
  const Rect& r = visibility.touched;
  for (int y = r.y_begin; y < r.y_end; ++y) {
    const std::size_t row = visibility.row(0, y);
    for (int x = r.x_begin; x < r.x_end; ++x) {
      const std::size_t from = row + std::size_t(x - visibility.rect.x_begin);
      const std::size_t to = std::size_t(y) * std::size_t(framebuffer.width) + std::size_t(x);
      if (!framebuffer.depth.empty()) framebuffer.depth[to] = visibility.depth[from];
      if (framebuffer.object_id.empty() || visibility.triangle[from] == no_triangle) continue;
      const DrawnTriangle& seen = *visibility.triangles[visibility.triangle[from]];
      framebuffer.object_id[to] = seen.draw;
      framebuffer.triangle_id[to] = seen.triangle;
    }
  }
}

/// All planes but the colour.
void clear(const Rect& r, Framebuffer& f) {
  const auto fill = [&](auto& plane, int channels, auto value) {
    if (plane.empty()) return;
    for (int y = r.y_begin; y < r.y_end; ++y) {
      const auto first = std::ptrdiff_t(channels) * (std::ptrdiff_t(y) * f.width + r.x_begin);
      std::fill_n(plane.begin() + first, channels * (r.x_end - r.x_begin), value);
    }
  };
  fill(f.depth, 1, 0.0f);
  fill(f.normal, 3, 0.0f);
  fill(f.object_id, 1, no_id);
  fill(f.triangle_id, 1, no_id);
  for (auto* part : {&f.ambient, &f.diffuse, &f.glossy}) fill(*part, 3, 0.0f);
  fill(f.cost, 2, 0.0f);
}

}  // namespace

void draw_tile(const Frame& frame, int tile, Redo redo, Worker& worker, VisibilityTile& visibility,
               Framebuffer& framebuffer) {
  FrameStats& stats = worker.shader.stats;
  const Rect rect = frame.grid.tile(tile);
  ColourTarget target;
  const auto shade = [&](const FragmentSpan& span) {
    const StageTimer shading_timer(stats, Stage::shading);
    worker.shader.shade(frame, span, target, framebuffer);
  };
  // Spans are shaded while resolving, and without hidden_fragments while scan-converting: that time
  // is not theirs.
  const auto without_shading = [&](Stage stage, const auto& work) {
    const double before = stats.seconds[std::size_t(Stage::shading)];
    {
      const StageTimer timer(stats, stage);
      work();
    }
    stats.seconds[std::size_t(stage)] -= stats.seconds[std::size_t(Stage::shading)] - before;
  };
  const bool count = !framebuffer.cost.empty();
  without_shading(Stage::scan_conversion, [&] {
    clear(rect, framebuffer);
    if (redo == Redo::all) worker.triangles.gather(frame, tile, visibility);
    target = worker.colours.begin(frame, rect, visibility.touched, framebuffer);
    if (redo == Redo::shading) return;
    const bool forward = !frame.settings.skips.hidden_fragments && visibility.samples == 1;
    const auto nothing = [](TriangleId, const VisibleColumns*) {};
    if (!forward && !count)
      return worker.triangles.scan_convert_all(frame, visibility, stats, nothing);
    const auto after_each = [&](TriangleId id, const VisibleColumns* columns) {
      if (count) count_depth_tests(id, visibility, columns, framebuffer);
      if (!forward) return;
      const auto& v = visibility.triangles[id]->vertices;
      const Rect box =
          intersection(centre_bounds(screen_triangle(v[0], v[1], v[2])), visibility.touched);
      Resolver(frame, visibility, worker.collector, shade).run(id, box);
    };
    worker.triangles.scan_convert_all(frame, visibility, stats, after_each);
  });
  without_shading(Stage::resolve, [&] {
    stats.covered_pixels += Resolver(frame, visibility, worker.collector, shade).run();
    write_visibility(visibility, framebuffer);
    worker.colours.finish();
  });
  if (frame.settings.probe) frame.settings.probe->tile_drawn(frame, visibility);
}

}  // namespace scanlit
