// New idea: a span is half-open, so that a centre on a shared edge belongs to one triangle only.
// Builds on: lesson 3, the edges of a triangle.
// Try: --x 8.25, an edge that meets no centre; --x 8.5 again: how many pixels does each rule lose?
#include <cmath>
#include <functional>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/lesson.h"

using namespace scanlit;
namespace ink = studio::ink;

using Triangle = std::vector<glm::dvec2>;
enum Rule { closed, open, half_open };

// new idea
/// Calls hit(i, j) for the pixels of a triangle, row by row. In a row, the edges that cross its
/// centre line say where the span begins and ends; a rule says whose a centre is that lies on an
/// end. `half_open`: the left end's. Likewise the upper end of an edge belongs to it, the lower
/// not.
void scan_convert(const Triangle& t, Rule rule, const std::function<void(int, int)>& hit) {
  for (int j = 0; j < 100; ++j) {
    const double y = j + .5;  // of the row's centres
    double left = 1e9, right = -1e9;
    for (int k = 0; k < 3; ++k) {
      glm::dvec2 a = t[k], b = t[(k + 1) % 3];
      if (a.y > b.y) std::swap(a, b);
      if (y < a.y || y >= b.y) continue;  // also: horizontal edges cross no row
      const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
      left = std::min(left, x), right = std::max(right, x);
    }
    const int first = rule == open ? std::floor(left + .5) : std::ceil(left - .5);
    const int end = rule == closed ? std::floor(right + .5) : std::ceil(right - .5);
    for (int i = first; i < end; ++i) hit(i, j);
  }
}
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("Half-open spans cover a shared edge's pixels once.", 1800, 660);
  double x = 8.5;
  lesson.knob("--x", x, {4, 12}, "where the shared edge is, at its upper end");

  return lesson.run(argc, argv, [&] {
    constexpr int columns = 17, rows = 16;
    const glm::dvec2 top(x, 1.5), bottom(x, 14.5), left(1.3, 9.1), right(15.6, 6.7);
    const char* const names[] = {"both ends", "neither end", "left end only"};
    const auto draw = [&](int panel, int width, int height) {
      studio::Canvas canvas(width, height, {columns, rows});
      std::vector<int> hits(columns * rows);
      const auto count = [&](int i, int j) { ++hits[std::size_t(j * columns + i)]; };
      scan_convert({top, bottom, left}, Rule(panel), count);
      int twice = 0;
      for (int k = 0; k < columns * rows; ++k)
        if (hits[k]) canvas.cell(k % columns, k / columns, ink::sky);
      scan_convert({top, right, bottom}, Rule(panel), [&](int i, int j) {
        const bool again = hits[std::size_t(j * columns + i)] > 0;
        canvas.cell(i, j, again ? ink::vermilion : ink::yellow);
        twice += again;
        count(i, j);
      });
      canvas.grid(columns, rows);
      canvas.outline({top, right, bottom, left}, ink::black, 5);
      canvas.line(top, bottom, ink::black, 5);
      int pixels = 0;
      for (int k = 0; k < columns * rows; ++k) pixels += hits[k] > 0;
      for (int j = 1; j < rows - 1; ++j) canvas.dot({8.5, j + .5}, ink::black);
      lesson.figure(names[panel], std::to_string(pixels) + " pixels, " + std::to_string(twice) +
                                      " of them hit twice");
      return canvas.finish();
    };
    return studio::panels(lesson.width(), lesson.height(), 3,
                          {"both ends: hit twice", "neither end: missed", "left end only: once"},
                          draw, ink::paper);
  });
}
