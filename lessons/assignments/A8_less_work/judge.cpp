// A8: the judge evaluates the model for the student's program, and counts.
#include <algorithm>
#include <cmath>

#include "lessons/assignments/A8_less_work/reference.h"
#include "lessons/assignments/judge/judged_picture.h"
#include "lessons/assignments/judge/registry.h"
#include "lessons/assignments/judge/worded.h"
#include "rasterizer/framebuffer.h"

namespace scanlit::assignments {
namespace {

using namespace less_work;

enum Kind { ask_shade = 1, ask_evaluate };  // as in main.cpp

constexpr int rows = 12;

/// What the student's program made of some rows.
struct Shaded {
  double error = 0;  // the largest, of tolerances
  std::string worst;
  int evaluations = 0;
  Work work;
};

Numbers question_of(const a8::Row& row) {
  Numbers question{{row.width, std::int64_t(row.fragments.size()), std::int64_t(row.lights.size())},
                   {row.peak, row.tolerance}};
  const auto put = [&](const a8::Vector& v) {
    question.reals.insert(question.reals.end(), {v.x, v.y, v.z});
  };
  for (const a8::Fragment& f : row.fragments) {
    question.integers.push_back(f.column);
    question.reals.push_back(f.depth);
    put(f.position), put(f.normal);
  }
  for (const a8::Light& l : row.lights) {
    put(l.position);
    question.reals.insert(question.reals.end(), {l.intensity, l.reach});
  }
  return question;
}

Numbers evaluated(const a8::Row& row, const Numbers& question, int& evaluations) {
  Numbers answer;
  const auto& n = question.integers;
  if (n.size() % 2 != 0) throw Unanswered("evaluate() was asked for half a pair");
  for (std::size_t i = 0; i < n.size(); i += 2) {
    if (n[i] < 0 || n[i] >= std::int64_t(row.fragments.size()) || n[i + 1] < 0 ||
        n[i + 1] >= std::int64_t(row.lights.size()))
      throw Unanswered("evaluate() was asked for a fragment or a light that the row has not");
    const a8::Colour c = added(row, {int(n[i]), int(n[i + 1])});
    answer.reals.insert(answer.reals.end(), {c.r, c.g, c.b});
    if (++evaluations > 1000000) throw Unanswered("evaluate() was asked a million times");
  }
  return answer;
}

std::vector<double> shade(Examination& e, const a8::Row& row, int& evaluations) {
  const std::size_t reals = 3 * std::size_t(row.width);
  return e.student
      .ask(ask_shade, question_of(row), AnswerSize::reals(reals),
           [&](int, const Numbers& question) { return evaluated(row, question, evaluations); })
      .reals;
}

Shaded shade_rows(Examination& e) {
  const Variant variant(e.variant);
  Shaded all;
  for (int i = 0; i < rows; ++i) {
    const a8::Row row = drawn_row(variant, e.questions * 100 + std::uint64_t(i));
    const std::vector<double> got = shade(e, row, all.evaluations);
    const std::vector<a8::Colour> right = right_pixels(variant, row);
    const Work needed = work(variant, row);
    all.work.visible += needed.visible, all.work.lit += needed.lit;
    all.work.bounded += needed.bounded;
    for (std::size_t x = 0; x < right.size(); ++x) {
      const double off =
          std::max({std::abs(got[3 * x] - right[x].r), std::abs(got[3 * x + 1] - right[x].g),
                    std::abs(got[3 * x + 2] - right[x].b)}) /
          row.tolerance;
      if (off <= all.error) continue;
      all.error = off;
      all.worst = worded(
          "Row %d, column %zu:\n  yours:     (%.5f, %.5f, %.5f)\n"
          "  should be: (%.5f, %.5f, %.5f), within %.5f",
          i, x, got[3 * x], got[3 * x + 1], got[3 * x + 2], right[x].r, right[x].g, right[x].b,
          row.tolerance);
    }
  }
  return all;
}

/// Rounding apart.
bool is_right(const Shaded& shaded) { return shaded.error <= 1 + 1e-6; }

Finding test_right(Examination& e) {
  const Shaded shaded = shade_rows(e);
  if (is_right(shaded)) return {};
  return Finding::wrong(
      worded("The worst pixel is off by %.3g times the tolerance. ", shaded.error) + shaded.worst);
}

/// All points at `full` evaluations, none at `none`.
Finding test_work(Examination& e, int Work::*none, int Work::*full, const char* hint) {
  const Shaded shaded = shade_rows(e);
  if (!is_right(shaded))
    return Finding::wrong("Work counts only where the picture is right. " + shaded.worst);
  const double most = shaded.work.*none, least = shaded.work.*full;
  const double share = std::clamp((most - shaded.evaluations) / (most - least), 0., 1.);
  if (share == 1) return {};
  return {std::round(share * 100) / 100,
          worded("%d evaluations, where %.0f will do; from %.0f on there are no points.\n%s",
                 shaded.evaluations, least, most, hint)};
}

Finding test_visible(Examination& e) {
  const Shaded shaded = shade_rows(e);
  if (!is_right(shaded))
    return Finding::wrong("Work counts only where the picture is right. " + shaded.worst);
  if (shaded.evaluations <= shaded.work.visible) return {};
  return Finding::wrong(
      worded("%d evaluations, where %d will do.\nFragments are evaluated that "
             "another one hides.",
             shaded.evaluations, shaded.work.visible));
}

Finding test_lit(Examination& e) {
  return test_work(e, &Work::visible, &Work::lit,
                   "Which lights stand behind the surface, or out of reach?");
}
Finding test_bounded(Examination& e) {
  return test_work(
      e, &Work::lit, &Work::bounded,
      "The tolerance is for all that is left out at a pixel, together: how many of the "
      "weakest lights is that at most?");
}

Words words_of(std::uint64_t seed) {
  const Variant variant(seed);
  return {{"larger_is_nearer", variant.larger_is_nearer ? "true" : "false"},
          {"first_wins", variant.first_wins ? "true" : "false"},
          {"nearer", variant.larger_is_nearer ? "larger" : "smaller"},
          {"winner", variant.first_wins ? "first" : "last"}};
}

/// The rows one below the other, as strips.
std::map<std::string, JudgedPicture> illustrations(std::uint64_t seed) {
  const Variant variant(seed);
  constexpr int scale = 5, strip = 16;
  Framebuffer before(64 * scale, rows * strip), after(64 * scale, rows * strip);
  for (int y = 0; y < before.height; ++y) {
    const std::vector<a8::Colour> right =
        right_pixels(variant, drawn_row(variant, 100 + std::uint64_t(y / strip)));
    for (int x = 0; x < before.width; ++x) {
      const a8::Colour& c = right[std::size_t(x / scale)];
      const auto at = 4 * std::size_t(y * before.width + x);
      const double all[] = {c.r, c.g, c.b, 1};
      for (std::size_t k = 0; k < 4; ++k)
        before.colour[at + k] = .5f, after.colour[at + k] = float(all[k]);
    }
  }
  return {{"before.png", judged("before", "", before, before)},
          {"after.png", judged("after", "", after, after)}};
}

}  // namespace

Assignment a8_less_work() {
  return {.id = "A8",
          .title = "Less work",
          .folder = "A8_less_work",
          .file = "less_work.cpp",
          .header = "less_work.h",
          .words = words_of,
          .illustrations = illustrations,
          .parts = {{"A8.1", "The picture is right", test_right},
                    {"A8.2", "Only what is seen", test_visible},
                    {"A8.3", "Only lights that arrive", test_lit},
                    {"A8.4", "Only what could be noticed", test_bounded}}};
}

}  // namespace scanlit::assignments
