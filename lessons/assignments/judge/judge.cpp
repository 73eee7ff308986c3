#include "lessons/assignments/judge/judge.h"

#include <algorithm>
#include <chrono>

#include "lessons/assignments/judge/effort.h"
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

/// What has cost time already.
struct Patience {
  int late = 0;  // tests in which time was up
  std::set<std::int64_t> endless{};
};

/// One run in a process of its own.
Finding examine(const Part& part, const Rubric& rubric, const RubricTest& test,
                sandbox::Sandbox& sandbox, std::vector<JudgedPicture>& pictures,
                std::string& printed, Patience& patience) {
  ProgramRespondent student(sandbox);
  Examination examination{student, rubric.seed, test.questions, pictures, patience.endless};
  Finding finding;
  try {
    finding = part.run(examination);
  } catch (const Unanswered& error) {
    patience.late += !error.answered_in_time;
    finding = Finding::wrong(error.what());
  }
  constexpr std::size_t most_printed = 2000;
  if (finding.share < 1) printed = student.printed().substr(0, most_printed);
  return finding;
}

/// Twice, unless nothing is left to lose: what differs from run to run is not right.
void run_test(const Assignment& assignment, const Rubric& rubric, const RubricTest& test,
              sandbox::Sandbox& sandbox, TestScore& score, std::vector<JudgedPicture>& pictures,
              Patience& patience) {
  const auto start = std::chrono::steady_clock::now();
  const Part& part = part_of(assignment, test);
  std::vector<JudgedPicture> seen[2];
  Finding lower = examine(part, rubric, test, sandbox, seen[0], score.printed, patience);
  Finding second = lower.share > 0
                       ? examine(part, rubric, test, sandbox, seen[1], score.printed, patience)
                       : lower;
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
  sandbox.limits().cpu_seconds = std::min(options.limits.cpu_seconds, assignment.cpu_seconds);
  constexpr double idle = 3;  // times the processor time that a program may have, and no longer
  sandbox.limits().wall_seconds =
      std::min(options.limits.wall_seconds, idle * assignment.cpu_seconds);
  // Who waits for ever in one test does so in most: a class would take hours.
  constexpr int most_late = 3;
  Patience patience;
  for (std::size_t i = 0; i < verdict.tests.size(); ++i) {
    TestScore& score = verdict.tests[i];
    if (!built.good)
      score.message = built.message;
    else if (patience.late < most_late)
      run_test(assignment, rubric, rubric.tests[i], sandbox, score, verdict.pictures, patience);
    else
      score.message = "not tried: your program ran out of time in three tests before";
    if (options.progress) options.progress(double(i + 1) / double(verdict.tests.size()));
  }
  if (built.good && assignment.effort)
    verdict.effort = measured_effort(assignment, rubric, sandbox);
  return verdict;
}

}  // namespace scanlit::assignments
