// A frame as pipeline.h tells it, without anything that makes it fast: see stages.h.
#include <algorithm>
#include <cmath>

#include "rasterizer/draw.h"
#include "rasterizer/error.h"
#include "rasterizer/resolve.h"
#include "rasterizer/scan_conversion.h"
#include "rasterizer/shading.h"
#include "rasterizer/stages.h"
#include "rasterizer/tile_colours.h"
#include "rasterizer/triangle_culling.h"

namespace scanlit {

namespace {

// ------------------------------------------------------------------------- the engine's own stages

void engine_clip(const ClipVertex (&triangle)[3], const Viewport& viewport,
                 std::vector<ClippedTriangle>& pieces) {
  // Planes that nothing is outside of cut nothing.
  constexpr unsigned all_planes =
      outside_near | outside_far | outside_left | outside_right | outside_bottom | outside_top;
  clip(triangle, all_planes, viewport, pieces);
}

void engine_spans(const ScreenTriangle& triangle, const Rect& picture, const EmitSpan& emit) {
  for_each_span(triangle, picture.y_begin, picture.y_end, emit);
}

void engine_depth(const ScreenTriangle& triangle, int x, int y, std::span<float> depth) {
  int first = x;  // the row's first covered pixel, maybe left of the picture
  for_each_span(triangle, y, y + 1, [&](int, int begin, int) { first = begin; });
  const DepthPlane plane(triangle);
  const float anchor = plane.at(first, y), per_pixel = plane.per_pixel();
  for (std::size_t i = 0; i < depth.size(); ++i)
    depth[i] = std::clamp(anchor + float(x - first + int(i)) * per_pixel, plane.min(), plane.max());
}

void engine_depth_test(std::span<const float> depth, std::span<const float> there,
                       std::span<std::uint8_t> seen) {
  for (std::size_t i = 0; i < depth.size(); ++i) seen[i] = depth[i] > there[i];
}

template <class Own, class Engine>
Own own_or(const Own& own, const Engine& engine) {
  return own ? own : Own(engine);
}

// --------------------------------------------------------------------------------------- the frame

class StagedFrame {
 public:
  StagedFrame(Frame& frame, Framebuffer& framebuffer, FrameStats& stats)
      : frame_(frame),
        framebuffer_(framebuffer),
        stats_(stats),
        stages_(*frame.settings.stages),
        depth_(framebuffer.pixel_count()),
        covered_(framebuffer.pixel_count()) {}

  void run() {
    const Viewport& viewport = frame_.viewport;
    const glm::dmat4 view_projection =
        clip_from_world(frame_.camera, double(viewport.width) / viewport.height);
    ClusterCache clusters;
    for (const Object& object : frame_.scene.objects)
      frame_.draws.push_back(
          make_draw(object, std::uint32_t(frame_.draws.size()), view_projection, clusters));
    for (Draw& draw : frame_.draws) {
      draw.illumination = illuminate(frame_, draw);
      for (std::uint32_t i = 0; i < draw.mesh->triangle_count(); ++i) draw_triangle(draw, i);
    }
    put_behind(framebuffer_.colour, frame_.scene.background);
    stats_.covered_pixels = std::ranges::count(covered_, true);
    if (!framebuffer_.depth.empty()) framebuffer_.depth = depth_;
  }

 private:
  /// (3), (4), (5)
  void draw_triangle(const Draw& draw, std::uint32_t triangle) {
    ++stats_.triangles;
    ClipVertex corners[3];
    bool in_range = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = draw.mesh->indices[3 * std::size_t(triangle) + k];
      const ClipVertex& c = corners[k] = transform(draw, draw.mesh->positions[v]);
      for (const float coordinate : {c.x, c.y, c.z, c.w})
        in_range &= std::abs(coordinate) <= 1e18f;  // see out_of_range
    }
    std::vector<ClippedTriangle> pieces;
    if (in_range) clip_(corners, frame_.viewport, pieces);
    Fate fate = Fate::outside;
    for (const ClippedTriangle& piece : pieces)
      fate = std::max(fate, draw_piece(draw, triangle, piece));
    switch (fate) {
      case Fate::outside: ++stats_.outside; break;
      case Fate::no_pixel: ++stats_.no_pixel; break;
      case Fate::back_facing: ++stats_.back_facing; break;
      case Fate::drawn: ++stats_.drawn; break;
    }
  }

  /// (6) and, of a piece that faces the right way, the rest.
  Fate draw_piece(const Draw& draw, std::uint32_t triangle, const ClippedTriangle& corners) {
    const auto& [a, b, c] = corners.vertices;
    const ScreenTriangle screen = screen_triangle(a, b, c);
    if (screen.twice_area == 0) return Fate::no_pixel;
    const bool behind = (screen.twice_area < 0) != draw.mirrored;
    if (behind && !draw.draw_back_faces) return Fate::back_facing;
    // A chunk of this piece alone, for the engine's own shading to find it in.
    Chunk& chunk = frame_.chunks[0];
    chunk.draw = &draw;
    chunk.pieces = {corners};
    chunk.triangles = {{{a, b, c}, draw.index, triangle, 0, 0}};
    if (!stages_.shade) light_corners(triangle, behind);

    const Rect picture = picture_rect(frame_.viewport);
    const StagedPiece piece{draw.object, draw.index, triangle, behind, screen, corners};
    spans_(screen, picture, [&](int y, int begin, int end) {
      if (y < 0 || y >= picture.y_end) return;
      begin = std::max(begin, 0), end = std::min(end, picture.x_end);
      for (int x = begin; x < end; x += FragmentSpan::capacity)
        draw_span(piece, x, y, std::size_t(std::min(end - x, FragmentSpan::capacity)));
    });
    return Fate::drawn;
  }

  /// (9) where fragments are not what is lit: flat and Gouraud.
  void light_corners(std::uint32_t triangle, bool behind) {
    Chunk& chunk = frame_.chunks[0];
    chunk.lit.sites.clear();
    chunk.lit.corners = {0, 1, 2};
    if (chunk.draw->object->shading == Shading::flat) chunk.lit.sites = {{triangle, behind}};
    if (chunk.draw->object->shading == Shading::gouraud)
      for (std::size_t k = 0; k < 3; ++k)
        chunk.lit.sites.push_back(
            {chunk.draw->mesh->indices[3 * std::size_t(triangle) + k], behind});
    light_chunk(frame_, chunk, stats_);
  }

  /// (7) to (10)
  void draw_span(const StagedPiece& piece, int x, int y, std::size_t count) {
    const std::size_t first = std::size_t(y) * std::size_t(frame_.viewport.width) + std::size_t(x);
    const std::span there(&depth_[first], count);
    std::vector<float> depth(count), b1(count), b2(count);
    std::vector<std::uint8_t> seen(count);
    depth_of_(piece.screen, x, y, depth);
    depth_test_(depth, there, seen);
    if (std::ranges::count(seen, 0) == std::ptrdiff_t(count)) return;
    if (stages_.barycentric) stages_.barycentric(piece, x, y, b1, b2);

    FragmentSpan& span = *span_;
    span.draw = &frame_.draws[piece.object_index];
    span.with_derivatives = span.draw->object->shading == Shading::phong &&
                            span.draw->object->material.model->needs().texcoord_derivatives;
    span.size = 0;
    const ExactWeights weights(frame_, frame_.chunks[0].triangles[0]);
    for (std::size_t i = 0; i < count; ++i) {
      if (!seen[i]) continue;
      const int k = span.size++, column = x + int(i);
      // One pixel of a row at a time: the vector's other elements are overwritten.
      const ExactWeights::Row row(weights, column * subpixel + half_pixel,
                                  y * subpixel + half_pixel);
      const auto [exact_b1, exact_b2] = row.at(Batch(0));
      if (span.with_derivatives) row.store_derivatives(Batch(0), k, span);
      exact_b1.store(span.b1 + k), exact_b2.store(span.b2 + k);
      if (stages_.barycentric) span.b1[k] = b1[i], span.b2[k] = b2[i];
      span.run[k] = 0;
      span.pixel[k] = packed_pixel(column, y);
      span.weight[k] = 1;
      there[i] = depth[i];
      covered_[first + i] = true;
      if (framebuffer_.object_id.empty()) continue;
      framebuffer_.object_id[first + i] = piece.object_index;
      framebuffer_.triangle_id[first + i] = piece.triangle;
    }
    shade(piece);
  }

  void shade(const StagedPiece& piece) {
    FragmentSpan& span = *span_;
    const auto size = std::size_t(span.size);
    const auto width = std::size_t(frame_.viewport.width);
    if (!stages_.shade) {
      span.run_count = 1, span.pixels = span.size;
      span.exact = {0};  // b1 and b2 are there
      span.facing[0] = piece.back_facing ? -1 : 1;
      span.runs[0] = {&frame_.chunks[0].triangles[0], 0, std::uint16_t(size), 1,
                      std::uint16_t(size)};
      shader_->shade(frame_, span, {.linear = framebuffer_.colour.data(), .width = width},
                     framebuffer_);
      return;
    }
    std::vector<Rgb<float>> colours(size);
    stages_.shade(piece, {span.b1, size}, {span.b2, size}, colours);
    stats_.fragments += span.size;
    for (std::size_t i = 0; i < size; ++i) {
      float* const pixel = &framebuffer_.colour[4 * index_of_pixel(span.pixel[i], width)];
      pixel[0] = colours[i].r, pixel[1] = colours[i].g, pixel[2] = colours[i].b, pixel[3] = 1;
    }
  }

  Frame& frame_;
  Framebuffer& framebuffer_;
  FrameStats& stats_;
  const StageFunctions& stages_;
  const decltype(StageFunctions::clip) clip_ = own_or(stages_.clip, engine_clip);
  const decltype(StageFunctions::spans) spans_ = own_or(stages_.spans, engine_spans);
  const decltype(StageFunctions::depth) depth_of_ = own_or(stages_.depth, engine_depth);
  const decltype(StageFunctions::depth_test) depth_test_ =
      own_or(stages_.depth_test, engine_depth_test);
  std::vector<float> depth_;
  std::vector<bool> covered_;
  std::unique_ptr<FragmentSpan> span_ = std::make_unique<FragmentSpan>();
  std::unique_ptr<SpanShader> shader_ = std::make_unique<SpanShader>();
};

}  // namespace

FrameStats render_staged(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                         Framebuffer& framebuffer) {
  if (settings.samples != 1) throw Error("stages of one's own want one sample a pixel");
  if (framebuffer.format != ColourFormat::linear_float)
    throw Error("stages of one's own want a framebuffer in linear_float");
  framebuffer = Framebuffer(framebuffer.width, framebuffer.height, framebuffer.planes());
  FrameStats stats;
  Frame frame{.scene = scene,
              .camera = camera,
              .settings = settings,
              .viewport = {framebuffer.width, framebuffer.height},
              .grid = {},
              .draws = {},
              .chunks = {},
              .with_parts = !framebuffer.ambient.empty()};
  frame.chunks.resize(1);
  StagedFrame(frame, framebuffer, stats).run();
  stats.threads = 1;
  return stats;
}

}  // namespace scanlit
