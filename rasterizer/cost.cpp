#include "rasterizer/cost.h"

#include <algorithm>

#include "rasterizer/scan_conversion.h"

namespace scanlit {

namespace {

constexpr std::size_t tests = 0, evaluated = 1, channels = 2;

/// One depth test for each pixel of the tile that the triangle covers, at its centre.
void count(const ScreenTriangle& triangle, const Rect& tile, const VisibleColumns* columns,
           Framebuffer& framebuffer) {
  for_each_span(triangle, tile.y_begin, tile.y_end, [&](int y, int begin, int end) {
    if (columns && (y < columns->first_row || y >= columns->end_row)) return;
    int first = std::max(begin, tile.x_begin), last = std::min(end, tile.x_end);
    if (columns) {
      const auto& range = columns->at_row(y);
      first = std::max(first, range.begin), last = std::min(last, range.end);
    }
    const std::size_t row = std::size_t(y) * std::size_t(framebuffer.width);
    for (int x = first; x < last; ++x)
      framebuffer.cost[channels * (row + std::size_t(x)) + tests] += 1;
  });
}

}  // namespace

void count_depth_tests(TriangleId id, const VisibilityTile& visibility,
                       const VisibleColumns* columns, Framebuffer& framebuffer) {
  const auto& v = visibility.triangles[id]->vertices;
  ScreenTriangle triangle = screen_triangle(v[0], v[1], v[2]);
  for (const SampleOffset& offset : sample_offsets(visibility.samples)) {
    for (ScreenVertex& vertex : triangle.vertices) vertex.x -= offset.x, vertex.y -= offset.y;
    count(triangle, visibility.rect, columns, framebuffer);
    for (ScreenVertex& vertex : triangle.vertices) vertex.x += offset.x, vertex.y += offset.y;
  }
}

void add_evaluations(const FragmentSpan& span, const float* evaluations, Framebuffer& framebuffer) {
  const auto width = std::size_t(framebuffer.width);
  for (int i = 0; i < span.size; ++i)
    framebuffer.cost[channels * index_of_pixel(span.pixel[i], width) + evaluated] += evaluations[i];
}

}  // namespace scanlit
