// What a submission may answer: nothing it prints, returns or repeats is taken for an answer, and
// it loses the test it did so in.
#include <gtest/gtest.h>

#include "tests/assignments/submissions.h"

namespace scanlit::assignments::test {
namespace {

/// A1's solution that does this before main(), or when it is asked for an edge.
Verdict judged(const std::string& before_main, const std::string& in_edge = "") {
  const Assignment& a1 = assignment("A1");
  std::string text = "#include <stdlib.h>\n#include <string.h>\n#include <unistd.h>\n" +
                     solution_text(a1) + "\nstruct Attack { Attack() { " + before_main +
                     " } } attack;\n";
  const std::string edge = "Edge edge(Point from, Point to, Point third) {";
  const std::size_t place = text.find(edge);
  EXPECT_NE(place, text.npos);
  text.insert(place + edge.size(), in_edge);
  return judge_text(a1, text);
}

void expect_nothing(const Verdict& verdict) {
  EXPECT_TRUE(verdict.built) << verdict.build_log;
  for (const TestScore& test : verdict.tests) {
    EXPECT_EQ(test.points, 0) << test.id;
    EXPECT_NE(test.message, "") << test.id;
  }
}

TEST(HostileAnswers, EndingWellIsNoAnswer) { expect_nothing(judged("_exit(0);")); }

TEST(HostileAnswers, PrintingIsNoAnswer) {
  expect_nothing(
      judged("static const char all[4096] = \"PASSED 100 of 100\"; write(1, all, sizeof all);"));
}

TEST(HostileAnswers, HangingUpIsNoAnswer) { expect_nothing(judged("close(0); close(1);")); }

TEST(HostileAnswers, TheCompilersWordsAreTheSameEachTime) {
  const Assignment& a1 = assignment("A1");
  for (const char* text : {"", "asm(\".incbin \\\"/no/such/file\\\"\");"}) {
    const std::string log = judge_text(a1, text).build_log;
    EXPECT_NE(log, "");
    EXPECT_EQ(log, judge_text(a1, text).build_log);
  }
}

TEST(HostileAnswers, ACrashCostsTheTestItIsInAlone) {
  const Verdict verdict = judged("", " if (from.x != to.x || from.y != to.y) abort(); ");
  EXPECT_EQ(verdict.tests[0].points, 0);
  EXPECT_NE(verdict.tests[0].message.find("SIGABRT"), std::string::npos)
      << verdict.tests[0].message;
  EXPECT_EQ(verdict.tests[1].points, verdict.tests[1].max_points);
}

}  // namespace
}  // namespace scanlit::assignments::test
