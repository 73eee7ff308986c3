// A9, a mutant hunt. README.md says what the stage under test is to do; `scanlit check .` says
// which faults your tests find.
#include "mutant_hunt.h"

#include <algorithm>
#include <utility>

#include "variant.h"

namespace a9 {

namespace {

//<<
/// What the stage should give, by the plainest way there is: every pixel, every edge.
std::vector<std::pair<int, int>> expected(const Triangle& t, int width, int height) {
  struct Edge {
    std::int64_t a, b, c;
    bool owned;
  } edges[3];
  for (int i = 0; i < 3; ++i) {
    const Point p = t.corners[i], q = t.corners[(i + 1) % 3], r = t.corners[(i + 2) % 3];
    Edge e{p.y - q.y, q.x - p.x, p.x * q.y - q.x * p.y, false};
    const std::int64_t area = e.a * r.x + e.b * r.y + e.c;
    if (area == 0) return {};
    if (area < 0) e = {-e.a, -e.b, -e.c, false};
    const bool is_top = (e.b > 0) != variant::y_up;
    e.owned = e.a != 0 ? (e.a > 0) == variant::owns_left : is_top == variant::owns_top;
    edges[i] = e;
  }
  std::vector<std::pair<int, int>> all;
  for (int column = 0; column < width; ++column)
    for (int row = 0; row < height; ++row) {
      const std::int64_t x = 256 * column + variant::centre, y = 256 * row + variant::centre;
      if (std::ranges::all_of(edges, [&](const Edge& e) {
            const std::int64_t value = e.a * x + e.b * y + e.c;
            return value > 0 || (value == 0 && e.owned);
          }))
        all.emplace_back(column, row);
    }
  return all;
}

/// The fragments of the stage are the expected ones, each once, in any order.
void check_fragments(const Triangle& t, int width = 16, int height = 16) {
  std::vector<std::pair<int, int>> got;
  for (const Fragment& f : scan_convert(t, width, height)) got.emplace_back(f.column, f.row);
  std::ranges::sort(got);
  check(got == expected(t, width, height));
}

/// A corner at so many half pixels from the centre of pixel (0, 0).
Point at(int half_columns, int half_rows) {
  return {variant::centre + 128 * std::int64_t(half_columns),
          variant::centre + 128 * std::int64_t(half_rows)};
}
//>>
void covers_something() {
  //<< TODO(A9.1) A first test. Which triangles, and what must hold?
  check_fragments({{at(0, 0), at(8, 0), at(0, 8)}});
  check_fragments({{at(1, 1), at(23, 5), at(9, 27)}});
  //== check(true);
  //>>
}
//<<

void vertical_and_slanted_edges() {
  check_fragments({{at(4, 2), at(4, 20), at(22, 11)}});
  check_fragments({{at(22, 2), at(22, 20), at(4, 11)}});
  check_fragments({{at(4, 4), at(12, 20), at(20, 4)}});
  check_fragments({{at(4, 20), at(12, 4), at(20, 20)}});
}

void horizontal_edges() {
  check_fragments({{at(4, 4), at(20, 4), at(13, 17)}});
  check_fragments({{at(4, 20), at(20, 20), at(13, 5)}});
}

void every_order_of_corners() {
  for (const Triangle& t :
       {Triangle{{at(3, 3), at(25, 7), at(11, 21)}}, Triangle{{at(4, 4), at(20, 4), at(4, 20)}}})
    for (int i = 0; i < 3; ++i) {
      const Point a = t.corners[i], b = t.corners[(i + 1) % 3], c = t.corners[(i + 2) % 3];
      check_fragments({{a, b, c}});
      check_fragments({{a, c, b}});
    }
}

void large_triangles() {
  for (std::int64_t far = 1 << 13; far < (1 << 24); far *= 2) {
    check_fragments({{{-far + 1, -far / 2}, {far - 1, -far / 3}, {100, far - 1}}});
    check_fragments({{{700, 700}, {far - 1, 1300}, {900, far - 5}}});
    check_fragments({{{-far + 5, 900}, {3000, 800}, {2900, 2000}}});
  }
}

void leaves_the_picture() {
  for (const auto& [x, y] :
       {std::pair{-9, -9}, {-9, 9}, {9, -9}, {9, 9}, {0, -9}, {0, 9}, {-9, 0}, {9, 0}})
    check_fragments({{at(x - 3, y - 2), at(x + 25, y + 9), at(x + 8, y + 27)}}, 8, 8);
  check_fragments({{at(-100, -100), at(300, -100), at(-100, 300)}}, 9, 7);
}

void small_and_thin() {
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y) {
      const Point p = at(8, 8), q{p.x + 25 * x - 60, p.y + 25 * y - 60};
      check_fragments({{q, {q.x + 90, q.y + 10}, {q.x + 20, q.y + 90}}});
      check_fragments({{q, {q.x + 280, q.y + 30}, {q.x + 60, q.y + 290}}});
    }
  for (int shift = -140; shift <= 140; shift += 20) {
    check_fragments(
        {{{at(2, 8).x, at(2, 8).y + shift}, {at(26, 9).x, at(26, 9).y + shift}, at(26, 12)}});
    check_fragments(
        {{{at(8, 2).x + shift, at(8, 2).y}, {at(9, 26).x + shift, at(9, 26).y}, at(12, 26)}});
  }
}

void without_area() {
  check_fragments({{at(2, 2), at(2, 2), at(2, 2)}});
  check_fragments({{at(2, 2), at(12, 2), at(22, 2)}});
  check_fragments({{at(2, 2), at(2, 12), at(2, 22)}});
  check_fragments({{at(2, 2), at(12, 12), at(22, 22)}});
}

void remembers_nothing() {
  const Triangle t{{at(1, 1), at(23, 5), at(9, 27)}};
  for (int i = 0; i < 6; ++i) {
    check_fragments(t);
    check_fragments({{at(2, 2), at(2, 2), at(2, 2)}});
    check_fragments({{at(-20, -20), at(-10, -20), at(-20, -10)}});
  }
}
//>>

}  // namespace

const std::vector<Test>& tests() {
  static const std::vector<Test> all{
      {"covers something", covers_something},
      //<<
      {"vertical and slanted edges", vertical_and_slanted_edges},
      {"horizontal edges", horizontal_edges},
      {"every order of corners", every_order_of_corners},
      {"large triangles", large_triangles},
      {"leaves the picture", leaves_the_picture},
      {"small and thin", small_and_thin},
      {"without area", without_area},
      {"remembers nothing", remembers_nothing},
      //>>
  };
  return all;
}

}  // namespace a9
