// What a submission may answer: nothing it prints, returns or repeats is taken for an answer, and
// it loses the test it did so in.
#include <gtest/gtest.h>

#include "lessons/assignments/A1_scan_conversion/questions.h"
#include "lessons/assignments/A1_scan_conversion/reference.h"
#include "tests/assignments/submissions.h"

namespace scanlit::assignments::test {
namespace {

/// A1's solution that does this before main(), or when it is asked for an edge.
Verdict judged(const std::string& before_main, const std::string& in_edge = "") {
  const Assignment& a1 = assignment("A1");
  std::string text =
      "#include <fcntl.h>\n#include <stdlib.h>\n#include <string.h>\n#include <unistd.h>\n" +
      solution_text(a1) + "\nstruct Attack { Attack() { " + before_main + " } } attack;\n";
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

/// Answers rightly, and writes down what it was asked and answered, as an array's elements.
class Recorder final : public Respondent {
 public:
  Numbers ask(int, const Numbers& question, const AnswerSize&, const Counsel&) override {
    const auto& n = question.integers;
    Numbers answer;
    a1::put(scan::right_edge({n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}), answer);
    written += "{";
    for (const Numbers* numbers : {&question, static_cast<const Numbers*>(&answer)})
      for (const std::int64_t number : numbers->integers) written += std::to_string(number) + ", ";
    written += "},\n";
    return answer;
  }
  void start_anew() override {}

  std::string written;
};

TEST(HostileAnswers, RecordedAnswersAreWorthNothingWhereQuestionsAreFresh) {
  const Assignment& a1 = assignment("A1");
  Recorder recorder;
  std::vector<JudgedPicture> pictures;
  std::set<std::int64_t> endless;
  Examination recorded{recorder, /*variant=*/1, /*questions=*/1, pictures, endless};
  ASSERT_EQ(a1.parts[0].run(recorded).share, 1);
  std::string text = starter_text(a1);
  const std::string nothing = "return {0, 0, 1};";
  ASSERT_NE(text.find(nothing), text.npos);
  text.insert(text.find(nothing),
              "static const std::int64_t known[][10] = {" + recorder.written +
                  "};\n  for (const auto& k : known)\n    if (k[0] == from.x && k[1] == from.y && "
                  "k[2] == to.x && k[3] == to.y && k[4] == third.x && k[5] == third.y) return "
                  "{k[6], k[7], k[8], k[9] != 0};\n  ");
  EXPECT_EQ(points(judge_part(a1, text, "A1.1")), 1);
  EXPECT_EQ(points(judge_part(a1, text, "A1.1", 77)), 0);
}

TEST(HostileAnswers, WhatDiffersFromRunToRunScoresTheLower) {
  // Without a user of its own a program may write beside itself.
  const Verdict verdict = judged("",
                                 " static const bool again = access(\"seen\", F_OK) == 0; "
                                 "close(creat(\"seen\", 0600)); if (again) return {}; ");
  const TestScore& edge = verdict.tests[0];
  EXPECT_EQ(edge.points, 0);
  EXPECT_EQ(edge.message.find("The first time all was well"), 0u) << edge.message;
}

TEST(HostileAnswers, TheJudgeDoesNotAnswerItsOwnQuestion) {
  const Assignment& a2 = assignment("A2");
  std::string text = "#include \"answer/serve.h\"\n" + starter_text(a2);
  const std::string distance = "double distance(const Vertex& vertex, Plane plane) {";
  ASSERT_NE(text.find(distance), text.npos);
  text.insert(text.find(distance) + distance.size(),
              "const auto& a = vertex.attribute; return scanlit::answer::ask_judge(1, "
              "{{int(plane)}, {vertex.x, vertex.y, vertex.z, vertex.w, a[0], a[1], "
              "a[2]}}).real();");
  const Verdict verdict = judge_part(a2, text, "A2.1");
  EXPECT_TRUE(verdict.built) << verdict.build_log;
  EXPECT_EQ(points(verdict), 0);
  EXPECT_NE(verdict.tests[0].message.find("asks back what it is asked itself"), std::string::npos)
      << verdict.tests[0].message;
}

TEST(HostileAnswers, TestsThatCountTheirRunsOrThrowDiceFindNoFault) {
  const Assignment& a9 = assignment("A9");
  std::string text = "#include <sys/random.h>\n" + starter_text(a9);
  const auto replace = [&text](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), text.npos);
    text.replace(text.find(from), from.size(), to);
  };
  replace("void covers_something()",
          "void counts() { static int runs = 0; check(++runs != 1); }\n"
          "void throws_dice() { unsigned char die; getrandom(&die, 1, 0); check(die >= 64); }\n"
          "void covers_something()");
  std::string dice;
  for (int i = 0; i < 20; ++i) dice += "{\"dice\", throws_dice}, ";
  replace("{\"covers something\", covers_something},", "{\"counts\", counts}, " + dice);
  const Verdict verdict = judge_text(a9, text);
  EXPECT_TRUE(verdict.built) << verdict.build_log;
  EXPECT_EQ(points(verdict), 0);
}

}  // namespace
}  // namespace scanlit::assignments::test
