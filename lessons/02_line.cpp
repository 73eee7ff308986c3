// New idea: in each column a line lights the pixel whose centre is nearest, found in whole numbers.
// Builds on: lesson 1, pixels and their centres.
// Try: --dx 24 --dy 5; --dy 24, its steepest; --dy 30, which fails. Why?
#include <cmath>
#include <cstdlib>

#include "lessons/studio/drawing/canvas.h"
#include "lessons/studio/lesson.h"

using namespace scanlit;
namespace ink = studio::ink;

struct Pixel {
  int i, j;
};

// new idea
/// Bresenham's line from pixel a to pixel b, where b lies to the right and 0 <= dy <= dx: the next
/// pixel is the one on the right or the one below that. `error` is 2 dx times how far, in pixels,
/// the line runs below the midpoint of the two; its sign decides.
std::vector<Pixel> line(Pixel a, Pixel b) {
  const int dx = b.i - a.i, dy = b.j - a.j;
  int error = 2 * dy - dx;
  std::vector<Pixel> pixels;
  for (int i = a.i, j = a.j; i <= b.i; ++i) {
    pixels.push_back({i, j});
    if (error > 0) {
      ++j;
      error -= 2 * dx;
    }
    error += 2 * dy;
  }
  return pixels;
}
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("A line lights the nearest pixel in each column.", 1500, 840);
  int dx = 24, dy = 11;
  lesson.knob("--dx", dx, {1, 200}, "columns from the first pixel to the last");
  lesson.knob("--dy", dy, {0, 200}, "rows");

  return lesson.run(argc, argv, [&] {
    const Pixel a{1, 1}, b{1 + dx, 1 + dy};
    studio::Canvas canvas(lesson.width(), lesson.height(), {dx + 3, dy + 3});
    const std::vector<Pixel> pixels = line(a, b);
    double farthest = 0;
    for (const auto& [i, j] : pixels) {
      canvas.cell(i, j, ink::sky);
      farthest = std::max(farthest, std::abs(j - a.j - double(dy) / dx * (i - a.i)));
    }
    canvas.grid(dx + 3, dy + 3);
    canvas.line({a.i + .5, a.j + .5}, {b.i + .5, b.j + .5}, ink::vermilion);
    for (const auto& [i, j] : pixels) canvas.dot({i + .5, j + .5}, ink::black);

    lesson.figure("pixels", std::to_string(pixels.size()));
    lesson.figure("farthest centre, in pixels above or below the line", studio::fixed(farthest, 3));
    return canvas.finish();
  });
}
