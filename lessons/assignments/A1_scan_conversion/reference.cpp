#include "lessons/assignments/A1_scan_conversion/reference.h"

#include <algorithm>

#include "lessons/assignments/judge/dice.h"
#include "rasterizer/scan_conversion.h"

namespace scanlit::assignments::scan {

using namespace a1;

ScanVariant scan_variant(std::uint64_t seed) {
  Dice dice(seed, "A1");
  const int rule = dice.between(1, 3);  // 0 would be top-left
  return {.y_up = dice.coin(),
          .centres_at_integers = dice.coin(),
          .owns_left = (rule & 1) == 0,
          .owns_top = (rule & 2) == 0};
}

Edge right_edge(Point from, Point to, Point third) {
  const Edge e{from.y - to.y, to.x - from.x, from.x * to.y - to.x * from.y};
  if (e.a * third.x + e.b * third.y + e.c >= 0) return e;
  return {-e.a, -e.b, -e.c};
}

bool right_owns(const ScanVariant& variant, const Edge& edge) {
  if (edge.a != 0) return (edge.a > 0) == variant.owns_left;
  return ((edge.b > 0) != variant.y_up) == variant.owns_top;
}

std::int64_t value_at(const ScanVariant& variant, const Edge& edge, int column, int row) {
  return edge.a * (256 * std::int64_t(column) + variant.centre()) +
         edge.b * (256 * std::int64_t(row) + variant.centre()) + edge.c;
}

bool right_covers(const ScanVariant& variant, const Edge (&edges)[3], int column, int row) {
  return std::ranges::all_of(edges, [&](const Edge& edge) {
    return value_at(variant, edge, column, row) >= (edge.owned ? 0 : 1);
  });
}

Span right_span(const ScanVariant& variant, const Edge (&edges)[3], int row, int width) {
  std::int64_t begin = 0, end = width;
  for (const Edge& edge : edges) {
    // Covered is where (room + column * step) >= 0.
    const std::int64_t step = 256 * edge.a;
    const std::int64_t room = value_at(variant, edge, 0, row) - (edge.owned ? 0 : 1);
    if (step > 0) begin = std::max(begin, -floor_divide(room, step));
    if (step < 0) end = std::min(end, floor_divide(room, -step) + 1);
    if (step == 0 && room < 0) end = 0;
  }
  return begin < end ? Span{int(begin), int(end)} : Span{0, 0};
}

bool right_edges(const ScanVariant& variant, const Triangle& triangle, Edge (&edges)[3]) {
  for (int i = 0; i < 3; ++i) {
    const Point &from = triangle.corners[i], &to = triangle.corners[(i + 1) % 3],
                &third = triangle.corners[(i + 2) % 3];
    edges[i] = right_edge(from, to, third);
    if (edges[i].a * third.x + edges[i].b * third.y + edges[i].c == 0) return false;
    edges[i].owned = right_owns(variant, edges[i]);
  }
  return true;
}

std::vector<Fragment> right_fragments(const ScanVariant& variant, const Triangle& triangle,
                                      const Picture& picture) {
  std::vector<Fragment> all;
  Edge edges[3];
  if (!right_edges(variant, triangle, edges)) return all;
  const auto [a, b, c] = triangle.corners;
  const auto [low, high] = std::minmax({a.y, b.y, c.y});
  const auto first = std::max(low / 256 - 1, std::int64_t(0));
  const auto end = std::min(high / 256 + 2, std::int64_t(picture.height));
  for (int row = int(first); row < int(end); ++row) {
    const Span span = right_span(variant, edges, row, picture.width);
    for (int column = span.begin; column < span.end; ++column) all.push_back({column, row});
  }
  return all;
}

Triangle in_variant(const ScanVariant& variant, const ScreenTriangle& triangle, int height) {
  Triangle turned;
  for (int i = 0; i < 3; ++i) {
    const ScreenVertex& v = triangle.vertices[i];
    turned.corners[i] = {v.x, variant.y_up ? height * subpixel - v.y : v.y};
  }
  return turned;
}

int engine_row(const ScanVariant& variant, int row, int height) {
  return variant.y_up ? height - 1 - row : row;
}

}  // namespace scanlit::assignments::scan
