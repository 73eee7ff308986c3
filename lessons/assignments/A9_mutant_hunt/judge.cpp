// A9: the student's tests are run on right stages and on faults.
#include <algorithm>
#include <functional>
#include <random>
#include <string>

#include "lessons/assignments/A9_mutant_hunt/questions.h"
#include "lessons/assignments/A9_mutant_hunt/reference.h"
#include "lessons/assignments/judge/registry.h"
#include "lessons/assignments/judge/worded.h"

namespace scanlit::assignments {
namespace {

using namespace mutants;
using a9::ask_count, a9::ask_run, a9::ask_stage;

constexpr std::int64_t most_tests = 64;
constexpr int most_calls = 5000;        // of the stage, by one test
constexpr int most_pixels = 4'000'000;  // of their pictures

using Stage = std::function<Fragments(const Request&)>;

/// What a test asks the stage for, if that makes sense.
Request read_request(const Numbers& question) {
  constexpr std::int64_t furthest = 1 << 24;
  const auto& n = question.integers;
  if (n.size() != 8) throw Unanswered("it asks the stage for what there is not");
  for (std::size_t i = 0; i < 6; ++i)
    if (n[i] <= -furthest || n[i] >= furthest)
      throw Unanswered("it asks for a triangle that is 2^24 or more units away");
  if (n[6] < 1 || n[6] > 64 || n[7] < 1 || n[7] > 64)
    throw Unanswered("it asks for a picture that is not of 1 to 64 columns and rows");
  return {{{{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}}}, int(n[6]), int(n[7])};
}

std::int64_t count_tests(Examination& e) {
  const std::int64_t count = e.student.ask(ask_count, {}, AnswerSize::integers(1)).integers[0];
  if (count < 0 || count > most_tests) throw Unanswered("tests() holds more than 64 tests");
  return count;
}

/// Whether a test passes on a stage; if not, by its own check(). Throws Unanswered where neither.
/// In a process of its own: a test that counted its runs would know which stage it is asked about.
bool passes(Examination& e, std::int64_t test, const Stage& stage) {
  int calls = 0, pixels = 0;
  const Counsel counsel = [&](int kind, const Numbers& question) {
    if (kind != ask_stage || ++calls > most_calls)
      throw Unanswered(worded("it calls scan_convert() more than %d times", most_calls));
    const Request request = read_request(question);
    pixels += request.width * request.height;
    if (pixels > most_pixels)
      throw Unanswered(worded("it asks for more than %d pixels altogether", most_pixels));
    Numbers answer;
    for (const a1::Fragment& f : stage(request))
      answer.integers.insert(answer.integers.end(), {f.column, f.row});
    return answer;
  };
  e.student.start_anew();
  const Numbers question{.integers = {test}, .reals = {}};
  return e.student.ask(ask_run, question, AnswerSize::integers(1), counsel).integers[0] == 1;
}

/// The first right design that a test fails on; -1 where it passes on all.
int refused_design(Examination& e, std::int64_t test) {
  const scan::ScanVariant variant = scan::scan_variant(e.variant);
  for (int design = 0; design < right_designs; ++design)
    if (!passes(e, test, [&](const Request& r) { return right(design, variant, r); }))
      return design;
  return -1;
}

/// All tests, one after the other: one that crashes or never ends costs itself alone.
class Trial {
 public:
  explicit Trial(Examination& e) : e_(e), count_(count_tests(e)) {}

  /// Until `run(test)` is true.
  template <class Run>
  bool any(const Run& run) {
    for (std::int64_t test = 0; test < count_; ++test) {
      if (e_.endless.contains(test)) {
        broken_ += said(test, "it never ends");
        continue;
      }
      try {
        if (run(test)) return true;
      } catch (const Unanswered& error) {
        broken_ += said(test, error.what());
        if (!error.answered_in_time) note_late(test);
      }
    }
    return false;
  }

  /// What there is to say of tests that were ended by something else than check().
  const std::string& broken() const { return broken_; }

 private:
  static std::string said(std::int64_t test, const std::string& what) {
    return worded("Test %d: ", int(test) + 1) + what + ".\n";
  }

  void note_late(std::int64_t test) {
    // A program full of such tests would take minutes for each part.
    constexpr int most_late = 1;
    if (++late_ > most_late)
      throw Unanswered(broken() + "No more tests are waited for", /*in_time=*/false);
    try {
      refused_design(e_, test);
    } catch (const Unanswered& error) {
      if (!error.answered_in_time) e_.endless.insert(test);
    }
  }

  Examination& e_;
  std::int64_t count_;
  int late_ = 0;
  std::string broken_;
};

/// All tests pass where the stage is right, and some fails where there is none.
Finding test_right(Examination& e) {
  std::string refused;
  bool some = false;
  Trial trial(e);
  trial.any([&](std::int64_t test) {
    const int design = refused_design(e, test);
    if (design >= 0)
      refused += worded("Test %d fails on a stage that is right%s.\n", int(test) + 1,
                        design == 0 ? "" : " and draws in another order");
    some |= design < 0 && !passes(e, test, [](const Request&) { return Fragments{}; });
    return false;
  });
  if (const std::string broken = trial.broken(); !broken.empty() || !refused.empty())
    return Finding::wrong(broken + refused +
                          (refused.empty() ? "It never counts: only check() may end a test."
                                           : "It never counts: what does it take for granted?"));
  if (!some)
    return Finding::wrong(
        "None of your tests fails on a stage that draws nothing at all. What must a triangle "
        "cover?");
  return {};
}

/// Whether a test still tells the fault from right stages when nobody knows which it is asked
/// about. One that throws dice, or looks at the clock, is right by luck once, and there may be 64
/// of them.
bool tells_again(Examination& e, std::int64_t test, const std::function<bool()>& passes_on_fault) {
  const scan::ScanVariant variant = scan::scan_variant(e.variant);
  constexpr int fault = -1;
  std::vector<int> stages{fault, fault, fault, fault, fault, 0, 0, 1, 1, 2, 2};
  std::ranges::shuffle(stages, std::mt19937(std::random_device()()));
  return std::ranges::all_of(stages, [&](int stage) {
    if (stage == fault) return !passes_on_fault();
    return passes(e, test, [&](const Request& r) { return right(stage, variant, r); });
  });
}

Finding test_fault(Examination& e, int fault) {
  std::string invalid;
  Trial trial(e);
  const bool found = trial.any([&](std::int64_t test) {
    const auto passes_on_fault = [&] {
      Mutant mutant(fault, e.variant);
      return passes(e, test, [&](const Request& r) { return mutant(r); });
    };
    if (passes_on_fault()) return false;
    const bool valid = refused_design(e, test) < 0;
    if (valid && tells_again(e, test, passes_on_fault)) return true;
    invalid = valid ? " A test that fails on it does not each time, and does not count."
                    : " A test that fails on it fails on right stages, too, and does not count.";
    return false;
  });
  if (found) return {};
  const std::string broken =
      trial.broken().empty() ? "" : trial.broken() + "Only check() may end a test.\n";
  return Finding::wrong(broken + "The fault survives. It has to do with " + hint(fault) + "." +
                        invalid);
}

}  // namespace

Assignment a9_mutant_hunt() {
  Assignment a9{
      .id = "A9",
      .title = "A mutant hunt",
      .folder = "A9_mutant_hunt",
      .file = "mutant_hunt.cpp",
      .header = "mutant_hunt.h",
      .words = [](std::uint64_t seed) { return a1_scan_conversion().words(seed); },
      .illustrations = [](std::uint64_t) { return std::map<std::string, JudgedPicture>(); },
      .parts = {{"A9.1", "Right stages pass", test_right}},
      .cpu_seconds = 2};
  for (int fault = 0; fault < faults; ++fault)
    a9.parts.push_back({"A9." + std::to_string(fault + 2), "Fault " + std::to_string(fault + 1),
                        [fault](Examination& e) { return test_fault(e, fault); }});
  return a9;
}

}  // namespace scanlit::assignments
