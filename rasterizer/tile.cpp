#include "rasterizer/tile.h"

#include <algorithm>

#include "rasterizer/cost.h"
#include "rasterizer/frame_probe.h"
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

/// Where the tile's fragments go: codes at once where each pixel has one fragment; else sums, which
/// are the framebuffer's own or become codes at the end.
ColourTarget colour_target(const Frame& frame, const Rect& r, Worker& worker, Framebuffer& f) {
  const auto width = std::size_t(f.width);
  if (f.format == ColourFormat::linear_float) return {.linear = f.colour.data(), .width = width};
  if (frame.settings.samples == 1)
    return {.codes = f.rgba8.data(), .width = width, .format = f.format};
  worker.colours.resize(4 * width * std::size_t(r.y_end - r.y_begin));
  return {.linear = worker.colours.data(),
          .width = width,
          .first_pixel = width * std::size_t(r.y_begin),
          .format = f.format};
}

/// use(floats) for each row of the tile in a target of sums.
template <class Use>
void for_each_sum(const Rect& r, const Framebuffer& f, const ColourTarget& target, const Use& use) {
  for (int y = r.y_begin; y < r.y_end && target.linear; ++y) {
    const std::size_t pixel = std::size_t(y) * std::size_t(f.width) + std::size_t(r.x_begin);
    use(std::span(target.linear + 4 * (pixel - target.first_pixel),
                  4 * std::size_t(r.x_end - r.x_begin)),
        pixel);
  }
}

void clear(const Rect& r, const ColourTarget& target, const Rgb<double>& background,
           Framebuffer& f) {
  const auto fill = [&](auto& plane, std::size_t channels, auto value) {
    for_each_row(r, f, plane, channels,
                 [&](auto row) { std::fill(row.begin(), row.end(), value); });
  };
  for_each_sum(r, f, target, [](auto row, std::size_t) { std::ranges::fill(row, 0.0f); });
  if (target.codes) {
    const float pixel[] = {float(background.r), float(background.g), float(background.b), 0};
    std::uint8_t codes[4];
    PixelEncoder(f.format).row(pixel, codes);
    const bool black = std::ranges::all_of(codes, [](std::uint8_t code) { return code == 0; });
    for_each_row(r, f, f.rgba8, 4, [&](std::span<std::uint8_t> row) {
      if (black) std::ranges::fill(row, std::uint8_t(0));  // faster by whole cache lines
      for (std::size_t i = 0; i < row.size() && !black; i += 4) std::copy_n(codes, 4, &row[i]);
    });
  }
  fill(f.depth, 1, 0.0f);
  fill(f.normal, 3, 0.0f);
  fill(f.object_id, 1, no_id);
  fill(f.triangle_id, 1, no_id);
  for (auto* part : {&f.ambient, &f.diffuse, &f.glossy}) fill(*part, 3, 0.0f);
}

/// Finishes the sums, and turns them into codes.
void finish(const Rgb<double>& background, const Rect& r, const ColourTarget& target,
            Framebuffer& f) {
  for_each_sum(r, f, target, [&](std::span<float> row, std::size_t first_pixel) {
    put_behind(row, background);
    if (f.format != ColourFormat::linear_float)
      PixelEncoder(f.format).row(row, &f.rgba8[4 * first_pixel]);
  });
}

}  // namespace

void put_behind(std::span<float> rgba, const Rgb<double>& background) {
  if (background == Rgb<double>(0.0)) return;
  const float channels[3] = {float(background.r), float(background.g), float(background.b)};
  for (std::size_t i = 0; i < rgba.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c) rgba[i + c] += (1 - rgba[i + 3]) * channels[c];
}

void draw_tile(const Frame& frame, int tile, Redo redo, Worker& worker, VisibilityTile& visibility,
               Framebuffer& framebuffer) {
  FrameStats& stats = worker.shader.stats;
  const Rect rect = frame.grid.tile(tile);
  const ColourTarget target = colour_target(frame, rect, worker, framebuffer);
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
    for_each_row(rect, framebuffer, framebuffer.cost, 2,
                 [](std::span<float> row) { std::ranges::fill(row, 0.0f); });
    clear(rect, target, frame.scene.background, framebuffer);
    if (redo == Redo::shading) return;
    worker.triangles.gather(frame, tile, visibility);
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
    if (forward) clear(rect, target, frame.scene.background, framebuffer);
  });
  without_shading(Stage::resolve, [&] {
    stats.covered_pixels += Resolver(frame, visibility, worker.collector, shade).run();
    write_visibility(visibility, framebuffer);
    finish(frame.scene.background, rect, target, framebuffer);
  });
  if (frame.settings.probe) frame.settings.probe->tile_drawn(frame, visibility);
}

}  // namespace scanlit
