#include "rasterizer/tile.h"

#include <algorithm>

#include "rasterizer/scan_conversion.h"
#include "rasterizer/stage_timer.h"
#include "rasterizer/triangle_culling.h"

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

/// A tile of a plane whose pixels have `channels` elements, row by row.
template <class Element, class Use>
void for_each_row(const Rect& r, const Framebuffer& framebuffer, std::vector<Element>& plane,
                  std::size_t channels, const Use& use) {
  if (plane.empty()) return;
  for (int y = r.y_begin; y < r.y_end; ++y) {
    const std::size_t first =
        std::size_t(y) * std::size_t(framebuffer.width) + std::size_t(r.x_begin);
    use(std::span(&plane[channels * first], channels * std::size_t(r.x_end - r.x_begin)));
  }
}

void clear(const Rect& r, Framebuffer& f) {
  const auto fill = [&](auto& plane, std::size_t channels, auto value) {
    for_each_row(r, f, plane, channels,
                 [&](auto row) { std::fill(row.begin(), row.end(), value); });
  };
  fill(f.colour, 4, 0.0f);
  fill(f.depth, 1, 0.0f);
  fill(f.normal, 3, 0.0f);
  fill(f.object_id, 1, no_id);
  fill(f.triangle_id, 1, no_id);
  for (auto* part : {&f.ambient, &f.diffuse, &f.glossy}) fill(*part, 3, 0.0f);
}

/// Puts the background behind what is covered in part or not at all.
void add_background(const Rgb<double>& background, const Rect& r, Framebuffer& framebuffer) {
  if (background == Rgb<double>(0.0)) return;
  const float channels[3] = {float(background.r), float(background.g), float(background.b)};
  for_each_row(r, framebuffer, framebuffer.colour, 4, [&](std::span<float> row) {
    for (std::size_t i = 0; i < row.size(); i += 4)
      for (std::size_t c = 0; c < 3; ++c) row[i + c] += (1 - row[i + 3]) * channels[c];
  });
}

}  // namespace

void draw_tile(const Frame& frame, int tile, Worker& worker, Framebuffer& framebuffer) {
  FrameStats& stats = worker.shader.stats;
  const Rect rect = frame.grid.tile(tile);
  VisibilityTile& visibility = worker.visibility;
  const auto shade = [&](const FragmentSpan& span) {
    const StageTimer shading_timer(stats, Stage::shading);
    worker.shader.shade(frame, span, framebuffer);
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
  without_shading(Stage::scan_conversion, [&] {
    clear(rect, framebuffer);
    worker.triangles.gather(frame, tile, visibility);
    const bool forward = !frame.settings.skips.hidden_fragments && visibility.samples == 1;
    worker.triangles.scan_convert_all(visibility, stats, [&](TriangleId id) {
      if (!forward) return;
      const auto& v = visibility.triangles[id]->vertices;
      const Rect box =
          intersection(centre_bounds(screen_triangle(v[0], v[1], v[2])), visibility.touched);
      Resolver(frame, visibility, worker.collector, shade).run(id, box);
    });
    if (forward) clear(rect, framebuffer);
  });
  without_shading(Stage::resolve, [&] {
    stats.covered_pixels += Resolver(frame, visibility, worker.collector, shade).run();
    write_visibility(visibility, framebuffer);
    add_background(frame.scene.background, rect, framebuffer);
  });
}

}  // namespace scanlit
