#include "lessons/assignments/judge/judge.h"

#include <algorithm>
#include <chrono>

#include "lessons/assignments/judge/program.h"
#include "rasterizer/error.h"

namespace scanlit::assignments {
namespace {

const Part& part_of(const Assignment& assignment, const RubricTest& test) {
  const auto found = std::ranges::find(assignment.parts, test.part, &Part::id);
  if (found == assignment.parts.end())
    throw Error(assignment.id + " has no part '" + test.part + "'");
  return *found;
}

/// One run in a process of its own. Counts how often time was up.
Finding examine(const Part& part, const Rubric& rubric, const RubricTest& test,
                sandbox::Sandbox& sandbox, std::vector<JudgedPicture>& pictures,
                std::string& printed, int& late) {
  ProgramRespondent student(sandbox);
  Examination examination{student, rubric.seed, test.questions, pictures};
  Finding finding;
  try {
    finding = part.run(examination);
  } catch (const Unanswered& error) {
    late += !error.answered_in_time;
    finding = Finding::wrong(error.what());
  }
  constexpr std::size_t most_printed = 2000;
  if (finding.share < 1) printed = student.printed().substr(0, most_printed);
  return finding;
}

/// Twice, unless nothing is left to lose: what differs from run to run is not right.
void run_test(const Assignment& assignment, const Rubric& rubric, const RubricTest& test,
              sandbox::Sandbox& sandbox, TestScore& score, std::vector<JudgedPicture>& pictures,
              int& late) {
  const auto start = std::chrono::steady_clock::now();
  const Part& part = part_of(assignment, test);
  std::vector<JudgedPicture> seen[2];
  Finding lower = examine(part, rubric, test, sandbox, seen[0], score.printed, late);
  Finding second =
      lower.share > 0 ? examine(part, rubric, test, sandbox, seen[1], score.printed, late) : lower;
  const int worse = second.share < lower.share;
  if (worse) {
    lower = std::move(second);
    lower.message =
        "The first time all was well, the second time it was not: something is not set "
        "before it is used.\n" +
        lower.message;
  }
  score.points = lower.share * test.points;
  score.message = lower.message;
  std::ranges::move(seen[worse], std::back_inserter(pictures));
  score.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Verdict judge(const Assignment& assignment, const std::filesystem::path& submission,
              const Rubric& rubric, const JudgeOptions& options) {
  Verdict verdict{.assignment = assignment.id, .seed = rubric.seed};
  for (const RubricTest& test : rubric.tests)
    verdict.tests.push_back(
        {.id = test.id, .name = test.name, .max_points = test.points, .hidden = test.hidden});
  sandbox::Sandbox sandbox(options.scratch, {}, options.build_limits, options.layers);
  const Build built = build(assignment, rubric.seed, submission, sandbox);
  verdict.built = built.good;
  verdict.build_log = built.log;
  sandbox.limits() = options.limits;
  // Who waits for ever in one test does so in most: a class would take hours.
  constexpr int patience = 3;
  int late = 0;
  for (std::size_t i = 0; i < verdict.tests.size(); ++i) {
    TestScore& score = verdict.tests[i];
    if (!built.good)
      score.message = built.message;
    else if (late < patience)
      run_test(assignment, rubric, rubric.tests[i], sandbox, score, verdict.pictures, late);
    else
      score.message = "not tried: your program ran out of time in three tests before";
    if (options.progress) options.progress(double(i + 1) / double(verdict.tests.size()));
  }
  return verdict;
}

}  // namespace scanlit::assignments
