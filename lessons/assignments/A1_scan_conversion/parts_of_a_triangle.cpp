// A1.1 to A1.4: one triangle, one edge, one row.
#include <algorithm>

#include "lessons/assignments/A1_scan_conversion/parts.h"
#include "lessons/assignments/judge/judged_picture.h"

namespace scanlit::assignments::scan {

using namespace a1;

std::string words(Point p) { return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")"; }

std::string words(const Triangle& t) {
  return words(t.corners[0]) + " " + words(t.corners[1]) + " " + words(t.corners[2]);
}

Triangle coarse_triangle(Dice& dice, int low, int high) {
  Triangle t;
  for (Point& p : t.corners) p = {128 * dice.between(low, high), 128 * dice.between(low, high)};
  return t;
}

std::string rule_of(const ScanVariant& variant) {
  return std::string(variant.owns_top ? "top" : "bottom") + "-" +
         (variant.owns_left ? "left" : "right");
}

namespace {

/// As coarse_triangle(), with an area, and with its edges.
Triangle with_edges(Dice& dice, const ScanVariant& variant, int low, int high, Edge (&edges)[3]) {
  for (;;) {
    const Triangle t = coarse_triangle(dice, low, high);
    if (right_edges(variant, t, edges)) return t;
  }
}

std::string kind_of(const ScanVariant& variant, const Edge& edge) {
  if (edge.a != 0)
    return edge.a > 0 ? "a left edge (the triangle lies to its right)"
                      : "a right edge (the triangle lies to its left)";
  return (edge.b > 0) != variant.y_up ? "a horizontal top edge (the triangle lies below it)"
                                      : "a horizontal bottom edge (the triangle lies above it)";
}

Finding wrong_span(const Triangle& t, int row, const Span& got, const Span& right) {
  const auto span = [](const Span& s) {
    return s.begin < s.end
               ? "columns " + std::to_string(s.begin) + " to " + std::to_string(s.end - 1) +
                     " (begin " + std::to_string(s.begin) + ", end " + std::to_string(s.end) + ")"
               : std::string("no column (end <= begin)");
  };
  return Finding::wrong("The triangle " + words(t) + ", row " + std::to_string(row) +
                        ":\n  yours:     " + span(got) + "\n  should be: " + span(right));
}

}  // namespace

Finding test_edge(Examination& e) {
  Dice dice(e.questions, "A1.1");
  for (int i = 0; i < 60; ++i) {
    // The largest come to 2^50: what is computed in 32 bits, or in float, is wrong there.
    const int size = i < 30 ? 2560 : (1 << 24) - 1;
    Triangle t;
    Edge right;
    do {
      for (Point& p : t.corners) p = {dice.between(-size, size), dice.between(-size, size)};
      right = right_edge(t.corners[0], t.corners[1], t.corners[2]);
    } while (right.a * t.corners[2].x + right.b * t.corners[2].y + right.c == 0);
    Numbers question;
    put(t, question);
    const auto got = e.student.ask(ask_edge, question, AnswerSize::integers(4)).integers;
    if (got[0] == right.a && got[1] == right.b && got[2] == right.c) continue;
    const auto coefficients = [](std::int64_t a, std::int64_t b, std::int64_t c) {
      return "a = " + std::to_string(a) + ", b = " + std::to_string(b) +
             ", c = " + std::to_string(c);
    };
    std::string why;
    if (got[0] == -right.a && got[1] == -right.b && got[2] == -right.c)
      why = "\nThe sign is wrong: E must be positive at the third corner.";
    else if (i >= 30)
      why = "\nSmall triangles were right: do the products fit into 64 bits all the way?";
    return Finding::wrong("edge(" + words(t.corners[0]) + ", " + words(t.corners[1]) + ", third " +
                          words(t.corners[2]) +
                          ")\n  yours:     " + coefficients(got[0], got[1], got[2]) +
                          "\n  should be: " + coefficients(right.a, right.b, right.c) + why);
  }
  return {};
}

Finding test_owns(Examination& e) {
  const ScanVariant variant = scan_variant(e.variant);
  Dice dice(e.questions, "A1.2");
  for (int i = 0; i < 64; ++i) {
    // First the eight winds, then edges of any slope, many of them almost horizontal or vertical.
    static constexpr int winds[8][2] = {{1, 0}, {0, 1},  {-1, 0},  {0, -1},
                                        {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    const auto any = [&] { return dice.between(-3, 3) * (dice.coin() ? 1 : 10000); };
    Edge edge{256 * any(), 256 * any(), dice.between(-100000, 100000)};
    if (i < 8) edge = {256 * winds[i][0], 256 * winds[i][1], edge.c};
    if (edge.a == 0 && edge.b == 0) continue;
    Numbers question;
    put(edge, question);
    const bool got = e.student.ask(ask_owns, question, AnswerSize::integers(1)).integers[0] != 0;
    if (got == right_owns(variant, edge)) continue;
    return Finding::wrong(
        "The edge with a = " + std::to_string(edge.a) + ", b = " + std::to_string(edge.b) +
        ", c = " + std::to_string(edge.c) + " is " + kind_of(variant, edge) + ".\nBy the " +
        rule_of(variant) + " rule its points " + (got ? "are not" : "are") +
        " the triangle's; your owns() says that they " + (got ? "are." : "are not."));
  }
  return {};
}

Finding test_covers(Examination& e) {
  const ScanVariant variant = scan_variant(e.variant);
  Dice dice(e.questions, "A1.3");
  constexpr int size = 9;
  for (int i = 0; i < 12; ++i) {
    Edge edges[3];
    const Triangle t = with_edges(dice, variant, 0, 2 * size - 1, edges);
    CoverageGrid grid(size, size);
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column) {
        Numbers question;
        put(edges, question);
        question.integers.insert(question.integers.end(), {column, row});
        const auto got = e.student.ask(ask_covers, question, AnswerSize::integers(1)).integers[0];
        grid.covered[grid.at(column, engine_row(variant, row, size))] = got != 0;
        grid.expected[grid.at(column, engine_row(variant, row, size))] =
            right_covers(variant, edges, column, row);
      }
    const std::string faults = draw_faults(grid, variant.y_up);
    if (!faults.empty())
      return Finding::wrong("The triangle " + words(t) + " by your covers(), pixel by pixel:\n" +
                            faults);
  }
  return {};
}

Finding test_span(Examination& e) {
  const ScanVariant variant = scan_variant(e.variant);
  Dice dice(e.questions, "A1.4");
  for (int i = 0; i < 40; ++i) {
    const bool large = i >= 30;  // far beyond the picture
    const int width = large ? 5000 : dice.between(6, 30), height = large ? 40 : 20;
    Edge edges[3];
    const Triangle t = large ? with_edges(dice, variant, -100000, 100000, edges)
                             : with_edges(dice, variant, i < 15 ? 0 : -20, i < 15 ? 12 : 50, edges);
    CoverageGrid grid(width, height);
    for (int row = 0; row < height; ++row) {
      Numbers question;
      put(edges, question);
      question.integers.insert(question.integers.end(), {row, width});
      const auto answer = e.student.ask(ask_span, question, AnswerSize::integers(2)).integers;
      const Span right = right_span(variant, edges, row, width);
      const Span got{int(std::clamp(answer[0], std::int64_t(-1 << 30), std::int64_t(1 << 30))),
                     int(std::clamp(answer[1], std::int64_t(-1 << 30), std::int64_t(1 << 30)))};
      const bool empty = got.begin >= got.end && right.begin >= right.end;
      if (empty || (got.begin == right.begin && got.end == right.end)) continue;
      Finding finding = wrong_span(t, row, got, right);
      if (got.begin < got.end && (got.begin < 0 || got.end > width))
        finding.message +=
            "\nThat leaves the picture, whose columns are 0 to " + std::to_string(width - 1) + ".";
      return finding;
    }
  }
  return {};
}

}  // namespace scanlit::assignments::scan
