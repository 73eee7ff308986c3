// A1, scan conversion. README.md says what each function is to do; `scanlit check .` says how far
// you are.
#include "scan_conversion.h"

#include <algorithm>

#include "variant.h"

namespace a1 {

//<<
namespace {

Point centre(int column, int row) {
  return {256 * std::int64_t(column) + variant::centre, 256 * std::int64_t(row) + variant::centre};
}

/// Rounded down and up; C++ rounds towards 0.
std::int64_t floor_divide(std::int64_t a, std::int64_t positive) {
  return a / positive - (a % positive < 0);
}
std::int64_t ceil_divide(std::int64_t a, std::int64_t positive) {
  return -floor_divide(-a, positive);
}

}  // namespace

//>>
Edge edge(Point from, Point to, Point third) {
  //<< TODO(A1.1) E(p) = a p.x + b p.y + c, twice the area of (from, to, p), positive at `third`.
  Edge e{from.y - to.y, to.x - from.x, from.x * to.y - to.x * from.y};
  if (e.a * third.x + e.b * third.y + e.c < 0) e = {-e.a, -e.b, -e.c};
  return e;
  //== return {0, 0, 1};
  //>>
}

bool owns(const Edge& edge) {
  //<< TODO(A1.2) The fill rule: whether the points exactly on this edge are the triangle's.
  if (edge.a != 0) return (edge.a > 0) == variant::owns_left;
  const bool is_top = (edge.b > 0) != variant::y_up;
  return is_top == variant::owns_top;
  //== return true;
  //>>
}

bool covers(const Edge (&edges)[3], int column, int row) {
  //<< TODO(A1.3) Whether the triangle covers the centre of this pixel; Edge::owned is set.
  const Point p = centre(column, row);
  for (const Edge& e : edges) {
    const std::int64_t value = e.a * p.x + e.b * p.y + e.c;
    if (value < 0 || (value == 0 && !e.owned)) return false;
  }
  return true;
  //== return true;
  //>>
}

Span span(const Edge (&edges)[3], int row, int width) {
  //<< TODO(A1.4) The columns of this row that are covered, between 0 and width.
  std::int64_t begin = 0, end = width;
  const Point p = centre(0, row);
  for (const Edge& e : edges) {
    // At column i the edge's value is `first` + i `step`; what is covered has at least `least`.
    const std::int64_t first = e.a * p.x + e.b * p.y + e.c, step = 256 * e.a;
    const std::int64_t least = e.owned ? 0 : 1;
    if (step > 0) begin = std::max(begin, ceil_divide(least - first, step));
    if (step < 0) end = std::min(end, floor_divide(first - least, -step) + 1);
    if (step == 0 && first < least) end = begin;
  }
  return {int(std::min(begin, std::int64_t(width))), int(std::max(end, std::int64_t(0)))};
  //== return {0, width};
  //>>
}

void scan_convert(const Triangle& triangle, const Picture& picture, const Stages& stages,
                  std::vector<Fragment>& fragments) {
  //<< TODO(A1.5) Each pixel of the picture that the triangle covers, once. A triangle without area
  //<< covers nothing. For now: the triangle's box.
  const auto& [a, b, c] = triangle.corners;
  const std::int64_t twice_area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (twice_area == 0) return;
  Edge edges[3] = {stages.edge(a, b, c), stages.edge(b, c, a), stages.edge(c, a, b)};
  for (Edge& e : edges) e.owned = stages.owns(e);
  const auto [y_min, y_max] = std::minmax({a.y, b.y, c.y});
  const std::int64_t first = ceil_divide(y_min - variant::centre, 256);
  const std::int64_t last = floor_divide(y_max - variant::centre, 256);
  const int end = int(std::min(last + 1, std::int64_t(picture.height)));
  for (int row = int(std::max(first, std::int64_t(0))); row < end; ++row) {
    const Span s = stages.span(edges, row, picture.width);
    for (int column = s.begin; column < s.end; ++column) fragments.push_back({column, row});
  }
  //== (void)stages;
  //== const auto& [a, b, c] = triangle.corners;
  //== const auto [x_min, x_max] = std::minmax({a.x, b.x, c.x});
  //== const auto [y_min, y_max] = std::minmax({a.y, b.y, c.y});
  //== for (int row = 0; row < picture.height; ++row)
  //==   for (int column = 0; column < picture.width; ++column)
  //==     if (256 * column >= x_min && 256 * column <= x_max && 256 * row >= y_min &&
  //==         256 * row <= y_max)
  //==       fragments.push_back({column, row});
  //>>
}

}  // namespace a1
