#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "lessons/assignments/A8_less_work/parts.h"
#include "lessons/assignments/A8_less_work/questions.h"
#include "lessons/assignments/judge/worded.h"

namespace scanlit::assignments::less_work {

namespace {

using a8::ask_evaluate, a8::ask_shade;
using Clock = std::chrono::steady_clock;

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

/// A row while it is shaded: evaluates the model, and counts.
class Counted {
 public:
  Counted(const Variant& variant, const JudgedRow& row) : variant_(variant), row_(row) {}

  std::vector<double> shade(Respondent& student) {
    const std::size_t reals = 3 * std::size_t(row_.width);
    const auto start = Clock::now();
    const Numbers answer =
        student.ask(ask_shade, question_of(row_), AnswerSize::reals(reals),
                    [this](int, const Numbers& question) { return evaluate(question); });
    seconds_ += std::chrono::duration<double>(Clock::now() - start).count();
    return answer.reals;
  }

  void add_to(Shaded& all) const {
    all.evaluations += evaluations_;
    all.fragments += int(fragments_.size());
    all.seconds += seconds_;
  }

 private:
  Numbers evaluate(const Numbers& question) {
    const auto start = Clock::now();
    Numbers answer;
    const auto& n = question.integers;
    if (n.size() % 2 != 0) throw Unanswered("evaluate() was asked for half a pair");
    for (std::size_t i = 0; i < n.size(); i += 2) {
      if (n[i] < 0 || n[i] >= std::int64_t(row_.fragments.size()) || n[i + 1] < 0 ||
          n[i + 1] >= std::int64_t(row_.lights.size()))
        throw Unanswered("evaluate() was asked for a fragment or a light that the row has not");
      const a8::Colour c = added(variant_, row_, {int(n[i]), int(n[i + 1])});
      answer.reals.insert(answer.reals.end(), {c.r, c.g, c.b});
      fragments_.insert(n[i]);
      if (++evaluations_ > 1000000) throw Unanswered("evaluate() was asked a million times");
    }
    seconds_ -= std::chrono::duration<double>(Clock::now() - start).count();
    return answer;
  }

  const Variant& variant_;
  const JudgedRow& row_;
  int evaluations_ = 0;
  std::set<std::int64_t> fragments_;
  double seconds_ = 0;
};

}  // namespace

Shaded shade_rows(Examination& e) {
  const Variant variant(e.variant);
  Shaded all;
  for (int i = 0; i < rows; ++i) {
    const JudgedRow row = drawn_row(variant, e.questions * 100 + std::uint64_t(i));
    Counted counted(variant, row);
    const std::vector<double> got = counted.shade(e.student);
    counted.add_to(all);
    const std::vector<a8::Colour> right = right_pixels(variant, row);
    const Work needed = work(variant, row);
    all.work.visible += needed.visible, all.work.lit += needed.lit;
    all.work.bounded += needed.bounded;
    all.right.insert(all.right.end(), right.begin(), right.end());
    for (std::size_t x = 0; x < right.size(); ++x) {
      all.pixels.push_back({got[3 * x], got[3 * x + 1], got[3 * x + 2]});
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

}  // namespace scanlit::assignments::less_work
