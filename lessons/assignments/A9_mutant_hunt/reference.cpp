#include "lessons/assignments/A9_mutant_hunt/reference.h"

#include <algorithm>
#include <string>

#include "lessons/assignments/judge/dice.h"
#include "rasterizer/scan_conversion.h"

namespace scanlit::assignments::mutants {

using namespace a1;
using namespace scan;

namespace {

void by_spans(const ScanVariant& variant, const Edge (&edges)[3], int width, int height,
              Fragments& out) {
  for (int row = 0; row < height; ++row) {
    const Span span = right_span(variant, edges, row, width);
    for (int column = span.begin; column < span.end; ++column) out.push_back({column, row});
  }
}

void by_columns(const ScanVariant& variant, const Edge (&edges)[3], int width, int height,
                Fragments& out) {
  for (int column = width; column-- > 0;)
    for (int row = height; row-- > 0;)
      if (right_covers(variant, edges, column, row)) out.push_back({column, row});
}

/// Halves the longer side until single pixels are left, the later half first.
void by_quarters(const ScanVariant& variant, const Edge (&edges)[3], int left, int top, int width,
                 int height, Fragments& out) {
  if (width == 1 && height == 1) {
    if (right_covers(variant, edges, left, top)) out.push_back({left, top});
  } else if (width >= height) {
    const int half = width / 2;
    by_quarters(variant, edges, left + half, top, width - half, height, out);
    by_quarters(variant, edges, left, top, half, height, out);
  } else {
    const int half = height / 2;
    by_quarters(variant, edges, left, top + half, width, height - half, out);
    by_quarters(variant, edges, left, top, width, half, out);
  }
}

/// As right_edges(), in so many bits.
bool edges_in_bits(const ScanVariant& variant, const Triangle& t, int bits, Edge (&edges)[3]) {
  if (!right_edges(variant, t, edges)) return false;
  const std::int64_t modulus = std::int64_t(1) << bits;
  for (Edge& e : edges) {
    e.c %= modulus;
    if (e.c >= modulus / 2) e.c -= modulus;
    if (e.c < -modulus / 2) e.c += modulus;
  }
  return true;
}

bool clockwise(const Triangle& t) {
  const Point &p = t.corners[0], &q = t.corners[1], &r = t.corners[2];
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x) < 0;
}

/// What is drawn of a triangle without area: the pixels between its corners, along x.
Fragments line(const ScanVariant& variant, const Request& r) {
  const auto pixel = [&](std::int64_t a) { return int(floor_divide(a - variant.centre(), 256)); };
  const auto [low, high] = std::ranges::minmax(r.triangle.corners, {}, &Point::x);
  Fragments all;
  for (int column = std::max(0, pixel(low.x)); column <= std::min(r.width - 1, pixel(high.x));
       ++column) {
    const int row = pixel(low.y);
    if (row >= 0 && row < r.height) all.push_back({column, row});
  }
  return all;
}

}  // namespace

Fragments right(int design, const ScanVariant& variant, const Request& request) {
  Edge edges[3];
  Fragments all;
  if (!right_edges(variant, request.triangle, edges)) return all;
  if (design == 0) by_spans(variant, edges, request.width, request.height, all);
  if (design == 1) by_columns(variant, edges, request.width, request.height, all);
  if (design == 2) by_quarters(variant, edges, 0, 0, request.width, request.height, all);
  return all;
}

namespace {

/// As many fragments as before, elsewhere in the picture.
void move(Fragments& all, const Request& r, int how) {
  const auto last = [](const Fragment& a, const Fragment& b) { return a.row < b.row; };
  const int last_row = std::ranges::max_element(all, last)->row;
  for (Fragment& f : all) {
    if (how == 0) f.column = (f.column + 1) % r.width;
    if (how == 1) f.row = (f.row + 1) % r.height;
    if (how == 2) f.column = r.width - 1 - f.column;
    if (how == 3 && f.row == last_row) f.column = (f.column + 1) % r.width;
  }
}

}  // namespace

const char* hint(int fault) {
  constexpr const char* hints[faults] = {
      "which of two triangles owns the points of an edge that is not horizontal",
      "which of two triangles owns the points of a horizontal edge",
      "the order of the corners",
      "triangles that are large",
      "triangles that leave the picture",
      "triangles that are small or thin",
      "how often a pixel is drawn",
      "triangles without area",
      "what the stage was asked before",
      "where fragments are, though there are as many as there should be"};
  return hints[fault];
}

Mutant::Mutant(int fault, std::uint64_t seed) : fault_(fault), variant_(scan_variant(seed)) {
  Dice dice(seed, "A9 fault " + std::to_string(fault));
  choice_ = dice.between(0, 3), amount_ = dice.between(0, 4);
}

Fragments Mutant::operator()(const Request& request) {
  ++calls_;
  Edge edges[3];
  Fragments all;
  if (fault_ == 7 && !right_edges(variant_, request.triangle, edges))
    return line(variant_, request);
  const int bits = fault_ == 3 ? 27 + 2 * amount_ : 62;
  if (!edges_in_bits(variant_, request.triangle, bits, edges)) return all;

  for (Edge& e : edges) {
    const bool vertical = e.a != 0 && e.b == 0, slanted = e.a != 0 && e.b != 0;
    if (fault_ == 0 && (choice_ == 0 ? vertical : choice_ == 1 ? slanted : e.a != 0))
      e.owned = choice_ == 3 || !e.owned;
    if (fault_ == 1 && e.a == 0) e.owned = choice_ < 2 ? !e.owned : choice_ == 2;
  }
  if (fault_ == 2 && clockwise(request.triangle) == (choice_ < 2)) {
    if (choice_ % 2 == 0) return all;
    for (Edge& e : edges) e.owned = !e.owned;
  }
  by_spans(variant_, edges, request.width, request.height, all);

  const auto drop = [&all](auto condition) { std::erase_if(all, condition); };
  const int last_column = request.width - 1, last_row = request.height - 1;
  if (fault_ == 4)
    drop([&](const Fragment& f) {
      return choice_ == 0   ? f.column == 0
             : choice_ == 1 ? f.column == last_column
             : choice_ == 2 ? f.row == 0
                            : f.row == last_row;
    });
  if (fault_ == 5) {
    if (choice_ < 2 && int(all.size()) <= 1 + amount_ / 2) all.clear();
    // Spans of a single pixel, in a row or in a column.
    const Fragments whole = all;
    if (choice_ >= 2)
      drop([&](const Fragment& f) {
        return std::ranges::count_if(whole, [&](const Fragment& g) {
                 return choice_ == 2 ? g.row == f.row : g.column == f.column;
               }) == 1;
      });
  }
  if (fault_ == 6 && !all.empty()) {
    const Fragment twice = choice_ == 0   ? all.front()
                           : choice_ == 1 ? all.back()
                                          : all[all.size() / 2];
    if (choice_ < 3 || all.size() > std::size_t(4 + amount_)) all.push_back(twice);
  }
  if (fault_ == 8 && calls_ > 2 + amount_ && !all.empty())
    choice_ < 2 ? all.erase(all.begin()) : all.end();
  if (fault_ == 8 && calls_ > 2 + amount_ && choice_ >= 2) all.clear();
  if (fault_ == 9 && all.size() > std::size_t(2 + amount_)) move(all, request, choice_);
  return all;
}

}  // namespace scanlit::assignments::mutants
