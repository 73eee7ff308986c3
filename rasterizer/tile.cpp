#include "rasterizer/tile.h"

#include <algorithm>

#include "rasterizer/stage_timer.h"

namespace scanlit {

namespace {

/// Depth and ids of sample 0, where the framebuffer asks for them.
void write_visibility(const Frame& frame, const VisibilityTile& visibility,
                      Framebuffer& framebuffer) {
  if (framebuffer.depth.empty() && framebuffer.object_id.empty()) return;
  const Rect& r = visibility.rect;
  for (int y = r.y_begin; y < r.y_end; ++y) {
    const std::size_t row = visibility.row(0, y);
    for (int x = r.x_begin; x < r.x_end; ++x) {
      const std::size_t from = row + std::size_t(x - r.x_begin);
      const std::size_t to = std::size_t(y) * std::size_t(framebuffer.width) + std::size_t(x);
      if (!framebuffer.depth.empty()) framebuffer.depth[to] = visibility.depth[from];
      if (framebuffer.object_id.empty() || visibility.triangle[from] == no_triangle) continue;
      const std::uint32_t source = frame.source(visibility.triangle[from]);
      const Draw& draw = frame.draw_of(source);
      framebuffer.object_id[to] = draw.index;
      framebuffer.triangle_id[to] = source - draw.first_triangle;
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
  {
    const StageTimer timer(stats, Stage::scan_conversion);
    clear(rect, framebuffer);
    worker.visibility.reset(rect, frame.settings.samples);
    scan_convert(frame, tile, worker.visibility);
  }
  const double shading_before = stats.seconds[std::size_t(Stage::shading)];
  {
    const StageTimer timer(stats, Stage::resolve);
    const auto shade = [&](const FragmentSpan& span) {
      const StageTimer shading_timer(stats, Stage::shading);
      worker.shader.shade(frame, span, framebuffer);
    };
    stats.covered_pixels += Resolver(frame, worker.visibility, worker.collector, shade).run();
    write_visibility(frame, worker.visibility, framebuffer);
    add_background(frame.scene.background, rect, framebuffer);
  }
  // Spans are shaded while resolving: that time is not resolving's.
  stats.seconds[std::size_t(Stage::resolve)] -=
      stats.seconds[std::size_t(Stage::shading)] - shading_before;
}

}  // namespace scanlit
