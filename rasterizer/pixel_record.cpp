#include "rasterizer/pixel_record.h"

#include <algorithm>

#include "rasterizer/error.h"
#include "rasterizer/frame_probe.h"
#include "rasterizer/resolve.h"
#include "rasterizer/scan_conversion.h"
#include "rasterizer/shading.h"
#include "rasterizer/tile_colours.h"

namespace scanlit {

namespace {

Rgb<float> rgb(const glm::vec4& v) { return {v.x, v.y, v.z}; }
Rgb<float> rgb(const std::vector<float>& values) { return {values[0], values[1], values[2]}; }

/// The points of a flat or Gouraud object's triangle, with the colours that assembly lit them with.
std::vector<PointRecord> site_points(const Frame& frame, const Run& run, SurfaceSpan& surface) {
  const Chunk& chunk = frame.chunks[run.drawn->chunk];
  const Draw& draw = frame.draw_of(*run.drawn);
  const std::size_t triangle = chunk.number_of(*run.drawn);
  std::vector<std::size_t> sites{triangle};
  if (draw.object->shading == Shading::gouraud) {
    const auto* corners = &chunk.lit.corners[3 * triangle];
    sites.assign(corners, corners + 3);
  }
  std::vector<LitSites::Site> own;
  for (const std::size_t site : sites) own.push_back(chunk.lit.sites[site]);
  put_sites(draw, draw.object->material.model->needs(), own, surface);
  std::vector<PointRecord> points = light_points(frame, draw, surface);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const LitSites& lit = chunk.lit;
    const std::size_t site = sites[i];
    points[i].element = lit.sites[site].element;
    points[i].ambient = rgb(lit.ambient[site]), points[i].diffuse = rgb(lit.diffuse[site]);
    points[i].glossy = rgb(lit.glossy[site]), points[i].colour = rgb(lit.colour[site]);
  }
  return points;
}

/// Fragment i of a span, alone in one of its own.
void take_fragment(const FragmentSpan& from, const Run& run, int i, FragmentSpan& to) {
  const auto r = &run - from.runs;
  to.draw = from.draw;
  to.size = to.run_count = to.pixels = 1;
  to.runs[0] = {run.drawn, 0, 1, 1, 1};
  to.facing[0] = from.facing[r];
  to.run[0] = 0;
  to.pixel[0] = from.pixel[i];
  to.weight[0] = from.weight[i];
  to.planes.column[0] = from.planes.column[r];
  for (int c = 0; c < 4; ++c) {
    to.planes.start[c][0] = from.planes.start[c][r];
    to.planes.per_column[c][0] = from.planes.per_column[c][r];
  }
  to.exact.clear();
  if (std::ranges::count(from.exact, r) > 0) to.exact = {0};
  to.b1[0] = from.b1[i], to.b2[0] = from.b2[i];
  to.with_derivatives = from.with_derivatives;
  if (!from.with_derivatives) return;
  to.dx.b1[0] = from.dx.b1[i], to.dx.b2[0] = from.dx.b2[i];
  to.dy.b1[0] = from.dy.b1[i], to.dy.b2[0] = from.dy.b2[i];
}

class PixelProbe final : public FrameProbe {
 public:
  PixelProbe(int x, int y) { record.x = x, record.y = y; }

  void tile_drawn(const Frame& frame, const VisibilityTile& visibility) override {
    const Rect& rect = visibility.rect;
    if (record.x < rect.x_begin || record.x >= rect.x_end || record.y < rect.y_begin ||
        record.y >= rect.y_end)
      return;
    find_layers(visibility);
    if (!intersection(pixel(), visibility.touched).empty()) resolve(frame, visibility);
    std::ranges::copy(sum_.colour, record.covered);
    put_behind(sum_.colour, frame.scene.background);
    std::ranges::copy(sum_.colour, record.colour);
  }

  PixelRecord record;

 private:
  Rect pixel() const { return {record.x, record.y, record.x + 1, record.y + 1}; }

  /// Scan-converts, each alone, the triangles whose boxes hold the pixel.
  void find_layers(const VisibilityTile& visibility);
  /// Gathers and shades the pixel's fragments as draw_tile() does those of a tile.
  void resolve(const Frame& frame, const VisibilityTile& visibility);
  /// Adds fragment i of a span to the pixel, and records it.
  void add(const Frame& frame, const FragmentSpan& span, const Run& run, int i);

  Framebuffer sum_{1, 1};
  SpanShader shader_;
  SurfaceSpan surface_;
  FragmentSpan one_;
};

void PixelProbe::find_layers(const VisibilityTile& visibility) {
  const auto offsets = sample_offsets(visibility.samples);
  record.samples.resize(offsets.size());
  std::vector<std::vector<std::pair<float, const DrawnTriangle*>>> layers(offsets.size());
  VisibilityTile alone;
  for (const DrawnTriangle* triangle : visibility.triangles) {
    const auto& v = triangle->vertices;
    Rect box = centre_bounds(screen_triangle(v[0], v[1], v[2]));
    box = {box.x_begin - 1, box.y_begin - 1, box.x_end + 1,
           box.y_end + 1};  // samples are not centres
    if (intersection(box, pixel()).empty()) continue;
    alone.reset(visibility.rect, pixel(), visibility.samples);
    alone.triangles = {triangle};
    scan_convert(0, alone, nullptr);
    for (std::size_t s = 0; s < offsets.size(); ++s) {
      const std::size_t at =
          alone.row(int(s), record.y) + std::size_t(record.x - alone.rect.x_begin);
      if (alone.triangle[at] == 0) layers[s].emplace_back(alone.depth[at], triangle);
    }
  }
  for (std::size_t s = 0; s < offsets.size(); ++s) {
    std::ranges::sort(layers[s], [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first > b.first : drawn_before(*a.second, *b.second);
    });
    record.samples[s].offset = offsets[s];
    for (const auto& [depth, triangle] : layers[s])
      record.samples[s].layers.push_back({triangle->draw, triangle->triangle, depth});
  }
}

void PixelProbe::resolve(const Frame& frame, const VisibilityTile& visibility) {
  const std::uint32_t pixel = packed_pixel(record.x, record.y);
  // The whole tile: in which order a pixel's fragments are added depends on how spans fill up.
  SpanCollector collector;
  const auto shade = [&](const FragmentSpan& span) {
    for (int r = 0; r < span.run_count; ++r) {
      const int end = span.runs[r].first + span.runs[r].size;
      for (int i = span.runs[r].first; i < end; ++i)
        if (span.pixel[i] == pixel) add(frame, span, span.runs[r], i);
    }
  };
  Resolver(frame, visibility, collector, shade).run();
}

void PixelProbe::add(const Frame& frame, const FragmentSpan& span, const Run& run, int i) {
  take_fragment(span, run, i, one_);
  // A picture of this one pixel.
  const std::size_t first = index_of_pixel(span.pixel[i], 1);
  const auto target = [&](Framebuffer& f) {
    return ColourTarget{
        .linear = f.colour.data(), .width = 1, .first_pixel = first, .first_in_planes = first};
  };
  shader_.shade(frame, one_, target(sum_), sum_);
  one_.weight[0] = 1;
  const DrawnTriangle& drawn = *run.drawn;
  const auto& [a, b, c] = drawn.vertices;
  FragmentRecord result{.object = drawn.draw,
                        .triangle = drawn.triangle,
                        .back_facing = one_.facing[0] < 0,
                        .clipped = drawn.piece != DrawnTriangle::not_cut,
                        .screen = screen_triangle(a, b, c),
                        .b1 = span.b1[i],
                        .b2 = span.b2[i],
                        .weight = span.weight[i]};
  for_each_span(result.screen, record.y, record.y + 1,
                [&](int, int begin, int end) { result.x_begin = begin, result.x_end = end; });

  Framebuffer picture(1, 1, {.normal = true, .parts = true});
  shader_.shade(frame, one_, target(picture), picture);
  result.colour = rgb(picture.colour);
  result.ambient = rgb(picture.ambient), result.diffuse = rgb(picture.diffuse);
  result.glossy = rgb(picture.glossy);
  result.normal = {picture.normal[0], picture.normal[1], picture.normal[2]};

  if (span.draw->object->shading != Shading::phong) {
    result.points = site_points(frame, run, surface_);
  } else {
    interpolate_surface(one_, surface_);
    result.points = light_points(frame, *span.draw, surface_);
    result.points[0].element = drawn.triangle;
  }
  record.fragments.push_back(std::move(result));
}

}  // namespace

PixelRecord record_pixel(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                         int width, int height, int x, int y) {
  validate_size(width, height);
  if (x < 0 || x >= width || y < 0 || y >= height)
    throw Error("pixel " + std::to_string(x) + "," + std::to_string(y) +
                " is not in the picture, whose columns are 0.." + std::to_string(width - 1) +
                " and rows 0.." + std::to_string(height - 1));
  PixelProbe probe(x, y);
  RenderSettings all = settings;
  all.probe = &probe;
  all.reuse = false;
  all.tolerance = 0;  // a pixel between two shaded ones has no derivation
  // So that every light, direction and hidden triangle is there to be recorded.
  all.skips.dark_lights = all.skips.far_directions = all.skips.unused_attributes = false;
  all.skips.hidden_clusters = all.skips.hidden_triangles = all.skips.empty_pixels = false;
  Framebuffer framebuffer(width, height, {.parts = true});
  render(scene, camera, all, framebuffer);
  std::copy_n(&framebuffer.colour[4 * (std::size_t(y) * std::size_t(width) + std::size_t(x))], 4,
              probe.record.drawn);
  return std::move(probe.record);
}

}  // namespace scanlit
