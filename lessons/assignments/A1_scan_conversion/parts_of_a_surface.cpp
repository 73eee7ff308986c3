// A1.5: triangles that share edges.
#include <algorithm>

#include "lessons/assignments/A1_scan_conversion/parts.h"
#include "lessons/assignments/judge/judged_picture.h"

namespace scanlit::assignments::scan {

using namespace a1;

namespace {

/// Whether numbers are such that no product of theirs overflows: points, or edges and then a row
/// and the width.
bool is_small(int kind, const std::vector<std::int64_t>& numbers) {
  constexpr std::int64_t point = 1 << 25, slope = 1 << 26, constant = 1LL << 52, pixel = 1 << 16;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::int64_t most = kind == ask_edge ? point
                              : i >= 12        ? pixel
                              : i % 4 == 2     ? constant
                                               : slope;
    if (numbers[i] < -most || numbers[i] > most) return false;
  }
  return true;
}

/// What the student's scan_convert() asks back, while it is judged alone.
Numbers right_answer(const ScanVariant& variant, int kind, const Numbers& question) {
  const auto& n = question.integers;
  constexpr std::size_t counts[] = {0, 6, 4, 14, 14};
  if (kind < ask_edge || kind > ask_span || n.size() != counts[kind] || !is_small(kind, n))
    throw Unanswered("your program asked back for what there is not");
  Numbers answer;
  Edge edges[3];
  for (std::size_t i = 0; i < 3 && kind >= ask_covers; ++i)
    edges[i] = {n[4 * i], n[4 * i + 1], n[4 * i + 2], n[4 * i + 3] != 0};
  switch (kind) {
    case ask_edge: put(right_edge({n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}), answer); break;
    case ask_owns: answer.integers = {right_owns(variant, {n[0], n[1], n[2]})}; break;
    case ask_covers:
      answer.integers = {right_covers(variant, edges, int(n[12]), int(n[13]))};
      break;
    default: {
      const Span span = right_span(variant, edges, int(n[12]), int(n[13]));
      answer.integers = {span.begin, span.end};
    }
  }
  return answer;
}

}  // namespace

std::vector<Fragment> ask_fragments(Respondent& student, const ScanVariant& variant,
                                    const Triangle& t, const Picture& picture, bool alone) {
  Numbers question{.integers = {alone, picture.width, picture.height}, .reals = {}};
  put(t, question);
  const auto most = std::size_t(4) * std::size_t(picture.width * picture.height);
  const auto counsel = [&](int kind, const Numbers& asked) {
    return right_answer(variant, kind, asked);
  };
  const auto n = student
                     .ask(ask_scan_convert, question, {.most_integers = most},
                          alone ? Counsel(counsel) : Counsel())
                     .integers;
  std::vector<Fragment> fragments;
  for (std::size_t i = 0; i + 1 < n.size(); i += 2) {
    const auto limited = [](std::int64_t x) {
      return int(std::clamp(x, std::int64_t(-1 << 30), std::int64_t(1 << 30)));
    };
    fragments.push_back({limited(n[i]), limited(n[i + 1])});
  }
  return fragments;
}

std::string outside(const Fragment& f, const Picture& picture) {
  if (f.column >= 0 && f.column < picture.width && f.row >= 0 && f.row < picture.height) return "";
  return "the fragment at column " + std::to_string(f.column) + ", row " + std::to_string(f.row) +
         " lies outside of the picture of " + std::to_string(picture.width) + " x " +
         std::to_string(picture.height) + " pixels";
}

namespace {

/// Triangles around a point, which together cover what each of their outer edges bounds: every
/// pixel in the middle once, whatever the rule.
std::vector<Triangle> fan(Dice& dice, int size) {
  const int count = dice.between(3, 9);
  const Point middle{128 * dice.between(size - 4, size + 4),
                     128 * dice.between(size - 4, size + 4)};
  const int corners[8][2] = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  std::vector<Point> around;
  for (int i = 0; i < 8 && int(around.size()) < count; ++i)
    around.push_back({128 * (size * corners[i][0] + dice.between(-2, 2)),
                      128 * (size * corners[i][1] + dice.between(-2, 2))});
  std::vector<Triangle> all;
  for (std::size_t i = 0; i < around.size(); ++i)
    all.push_back({{middle, around[i], around[(i + 1) % around.size()]}});
  return all;
}

Finding test_group(Examination& e, const std::vector<Triangle>& group, const Picture& picture,
                   const std::string& what) {
  const ScanVariant variant = scan_variant(e.variant);
  CoverageGrid grid(picture.width, picture.height);
  for (const Triangle& t : group) {
    const auto at = [&](const Fragment& f) {
      return grid.at(f.column, engine_row(variant, f.row, picture.height));
    };
    for (const Fragment& f : right_fragments(variant, t, picture)) ++grid.expected[at(f)];
    for (const Fragment& f : ask_fragments(e.student, variant, t, picture, true)) {
      const std::string where = outside(f, picture);
      if (!where.empty()) return Finding::wrong("The triangle " + words(t) + ": " + where + ".");
      ++grid.covered[at(f)];
    }
  }
  const std::string faults = draw_faults(grid, variant.y_up);
  return faults.empty() ? Finding() : Finding::wrong(what + ":\n" + faults);
}

}  // namespace

Finding test_scan_convert(Examination& e) {
  Dice dice(e.questions, "A1.5");
  for (int i = 0; i < 24; ++i) {
    const Picture picture{dice.between(8, 40), dice.between(8, 20)};
    const Triangle t = i < 12 ? coarse_triangle(dice, 0, 24) : coarse_triangle(dice, -30, 90);
    const Finding finding = test_group(e, {t}, picture, "The triangle " + words(t));
    if (finding.share < 1) return finding;
  }
  for (int i = 0; i < 6; ++i) {
    const auto group = fan(dice, 16);
    std::string what = std::to_string(group.size()) + " triangles around the point " +
                       words(group[0].corners[0]) +
                       ", which share edges: each pixel belongs to one of them";
    const Finding finding = test_group(e, group, {20, 20}, what);
    if (finding.share < 1) return finding;
  }
  return {};
}

}  // namespace scanlit::assignments::scan
