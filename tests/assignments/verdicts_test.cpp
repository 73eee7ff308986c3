// What starters, solutions and typical wrong solutions score, for every assignment there is. One
// wrong solution each; with SCANLIT_LONG set, all of them, and several variants.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/assignments/submissions.h"

namespace scanlit::assignments::test {
namespace {

bool with_all() { return std::getenv("SCANLIT_LONG") != nullptr; }

class Verdicts : public testing::TestWithParam<std::string> {
 protected:
  const Assignment& assignment_ = assignment(GetParam());
};

void expect_points(const Verdict& verdict, const std::map<std::string, double>& not_all) {
  EXPECT_TRUE(verdict.built) << verdict.build_log;
  for (const TestScore& test : verdict.tests) {
    const auto found = not_all.find(test.id);
    EXPECT_DOUBLE_EQ(test.points, found == not_all.end() ? test.max_points : found->second)
        << test.id << ": " << test.message;
    EXPECT_EQ(test.message.empty(), test.points == test.max_points) << test.id << test.message;
  }
}

TEST_P(Verdicts, TheStarterBuildsWithoutAWarningAndScoresNothing) {
  const Verdict verdict = judge_text(assignment_, starter_text(assignment_));
  EXPECT_TRUE(verdict.built);
  EXPECT_EQ(verdict.build_log, "");
  std::map<std::string, double> nothing;
  for (const TestScore& test : verdict.tests) nothing[test.id] = 0;
  expect_points(verdict, nothing);
  EXPECT_EQ(max_points(verdict), 100);
}

TEST_P(Verdicts, TheSolutionScoresAll) {
  for (std::uint64_t seed = 1; seed <= (with_all() ? 12 : 1); ++seed) {
    SCOPED_TRACE("variant " + std::to_string(seed));
    const Verdict verdict = judge_text(assignment_, solution_text(assignment_), seed);
    expect_points(verdict, {});
    EXPECT_EQ(verdict.effort.has_value(), bool(assignment_.effort));
    if (verdict.effort) {
      EXPECT_GT(verdict.effort->evaluations, 0);
      EXPECT_GT(verdict.effort->seconds, 0);
    }
  }
}

TEST_P(Verdicts, WrongSolutionsScoreWhatTheyDeserve) {
  std::vector<WrongSolution> all = wrong_solutions(assignment_);
  EXPECT_GE(all.size(), 5u);
  if (!with_all()) all.resize(1);
  for (const WrongSolution& wrong : all) {
    SCOPED_TRACE(wrong.name);
    const Verdict verdict = judge_text(assignment_, wrong.text, wrong.variant);
    expect_points(verdict, wrong.points);
    for (const auto& [id, words] : wrong.says) {
      const auto test = std::ranges::find(verdict.tests, id, &TestScore::id);
      ASSERT_NE(test, verdict.tests.end()) << id;
      EXPECT_NE(test->message.find(words), std::string::npos) << id << ": " << test->message;
    }
  }
}

std::vector<std::string> ids() {
  std::vector<std::string> all;
  for (const Assignment& each : assignments()) all.push_back(each.id);
  return all;
}
INSTANTIATE_TEST_SUITE_P(All, Verdicts, testing::ValuesIn(ids()),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace scanlit::assignments::test
