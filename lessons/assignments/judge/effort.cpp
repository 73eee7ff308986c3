#include "lessons/assignments/judge/effort.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "lessons/assignments/judge/program.h"

namespace scanlit::assignments {
namespace {

constexpr const char* valgrind = "/usr/bin/valgrind";

std::optional<Effort> effort_on(const Assignment& assignment, const Rubric& rubric,
                                std::uint64_t questions, Respondent& student) {
  std::vector<JudgedPicture> none;
  std::set<std::int64_t> endless;
  Examination examination{student, rubric.seed, questions, none, endless};
  try {
    return assignment.effort(examination);
  } catch (const Unanswered&) {
    return std::nullopt;
  }
}

/// What callgrind says last: "Collected : 710431".
std::int64_t collected(const std::string& printed) {
  const std::string word = "Collected : ";
  const std::size_t at = printed.rfind(word);
  return at == printed.npos ? 0 : std::atoll(printed.c_str() + at + word.size());
}

std::int64_t instructions(const Assignment& assignment, const Rubric& rubric,
                          sandbox::Sandbox& sandbox) {
  if (access(valgrind, X_OK) != 0) return 0;
  const sandbox::Limits before = sandbox.limits();
  constexpr std::uint64_t reserved = 4ULL << 30;  // addresses that valgrind takes for itself
  sandbox.limits().cpu_seconds = 20;              // it is some fifty times slower
  sandbox.limits().memory_bytes += reserved;
  sandbox.allow_valgrind();
  ProgramRespondent student(
      sandbox, {valgrind, "--tool=callgrind", "--vgdb=no", "--callgrind-out-file=/dev/null"});
  const auto effort = effort_on(assignment, rubric, rubric.tests[0].questions, student);
  const std::int64_t count = effort ? collected(student.hang_up()) : 0;
  sandbox.limits() = before;
  return count;
}

}  // namespace

std::optional<Effort> measured_effort(const Assignment& assignment, const Rubric& rubric,
                                      sandbox::Sandbox& sandbox) {
  if (rubric.tests.empty()) return std::nullopt;
  ProgramRespondent student(sandbox);
  std::optional<Effort> effort = effort_on(assignment, rubric, rubric.tests[0].questions, student);
  if (!effort) return std::nullopt;
  constexpr int laps = 9;
  std::random_device random;
  std::vector<double> seconds;
  for (int i = 0; i < laps; ++i) {
    const auto lap = effort_on(assignment, rubric, random(), student);
    if (!lap) return std::nullopt;
    seconds.push_back(lap->seconds);
  }
  std::ranges::sort(seconds);
  effort->seconds = seconds[laps / 2];
  student.start_anew();  // one program at a time
  effort->instructions = instructions(assignment, rubric, sandbox);
  return effort;
}

}  // namespace scanlit::assignments
