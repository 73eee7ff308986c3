// New idea: an edge parts the plane in two, and a triangle is where three of the halves overlap.
// Builds on: lesson 1, pixels and their centres.
// Try: --x 30, which moves a corner; --x -20 turns the triangle around: why is nothing inside?
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/lesson.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// Twice the area of the triangle a, b, p; above 0 where p lies to the right of the way from a to b
/// as the screen shows it, with y down; 0 on the line through both.
double edge(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

struct Triangle {
  glm::dvec2 a, b, c;  // clockwise on the screen

  /// On which edges' inner sides p lies: bit 0 for a b, bit 1 for b c, bit 2 for c a.
  int sides(glm::dvec2 p) const {
    return (edge(a, b, p) > 0) | (edge(b, c, p) > 0) << 1 | (edge(c, a, p) > 0) << 2;
  }
  double area() const { return edge(a, b, c) / 2; }
};
constexpr int inside = 0b111;
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("A triangle is what three half-planes have in common.", 1640, 640);
  double x = 22.3;
  lesson.knob("--x", x, {-100, 100}, "where the corner on the right is, in pixels");

  return lesson.run(argc, argv, [&] {
    const Triangle t{{7.2, 1.9}, {x, 9.4}, {3.6, 16.3}};
    constexpr int columns = 26, rows = 18;
    const glm::dvec2 ends[3][2] = {{t.a, t.b}, {t.b, t.c}, {t.c, t.a}};
    const Rgb<double> colours[] = {ink::vermilion, ink::green, ink::blue};
    int covered = 0;
    const auto draw = [&](int panel, int width, int height) {
      studio::Canvas canvas(width, height, {columns, rows});
      for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
          const int sides = t.sides({i + .5, j + .5});
          Rgb<double> tint(1.0);  // as of three coloured glasses, one on the other
          for (int k = 0; k < 3; ++k)
            if (sides >> k & 1) tint = tint * (colours[k] * .35 + Rgb<double>(.65));
          canvas.cell(i, j, panel == 0 ? tint : sides == inside ? ink::orange : ink::paper);
          covered += panel == 1 && sides == inside;
        }
      canvas.grid(columns, rows);
      for (int k = 0; k < 3; ++k) {
        const glm::dvec2 along = (ends[k][1] - ends[k][0]) * (panel == 0 ? 9.0 : 0.0);
        canvas.line(ends[k][0] - along, ends[k][1] + along, colours[k]);
      }
      for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) canvas.dot({i + .5, j + .5}, ink::black, 3);
      return canvas.finish();
    };
    Framebuffer sheet =
        studio::panels(lesson.width(), lesson.height(), 2,
                       {"three half-planes", "centres inside of all three"}, draw, ink::paper);
    lesson.figure("area of the triangle, in pixels", studio::fixed(t.area(), 2));
    lesson.figure("centres inside", std::to_string(covered));
    return sheet;
  });
}
