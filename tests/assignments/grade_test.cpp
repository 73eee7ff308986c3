// Grading: what is judged again and what is kept, late days, marks by hand, and verdicts that are
// the same to the byte.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lessons/assignments/grade/json_text.h"
#include "lessons/assignments/grade/leaderboard.h"
#include "lessons/assignments/grade/run.h"
#include "lessons/assignments/grade/writers.h"
#include "lessons/studio/pages/page.h"
#include "lessons/studio/tradeoff/temporary_folder.h"
#include "tests/assignments/submissions.h"

namespace scanlit::assignments::test {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

/// A class of A1, graded by two small tests.
class Grading : public testing::Test {
 protected:
  Grading() {
    job_.rubric.assignment = "A1";
    for (const char* id : {"A1.1", "A1.2"})
      job_.rubric.tests.push_back({.id = id, .part = id, .name = id, .points = 10});
    job_.rubric.manual = {{"style", "Style", 5}};
    job_.results = path("results");
    job_.jobs = 2;
  }
  fs::path path(const char* name) const { return folder_.file(name); }
  void submit(const std::string& name, const std::string& text) {
    const fs::path submission = path("submissions") / name;
    write(submission / a1_.file, text);
    if (std::ranges::find(job_.submissions, submission) == job_.submissions.end())
      job_.submissions.push_back(submission);
  }
  std::string result(const std::string& name) const {
    return studio::read_text(job_.results / safe_name(name) / "result.json");
  }

  studio::TemporaryFolder folder_;
  const Assignment& a1_ = assignment("A1");
  GradeJob job_;
};

TEST_F(Grading, JudgesWhatHasChangedAlone) {
  submit("alice", solution_text(a1_));
  submit("bob", starter_text(a1_));
  const GradeRun first = run_grading(job_);
  EXPECT_EQ(first.judged, 2);
  ASSERT_EQ(first.grades.size(), 2u);
  EXPECT_EQ(first.grades[0].total, 20);
  EXPECT_EQ(first.grades[1].total, 0);
  const std::string alice = result("alice"), bob = result("bob");

  job_.rubric.tests[0].points = 30;  // scored anew, not judged anew
  const GradeRun second = run_grading(job_);
  EXPECT_EQ(second.judged, 0);
  EXPECT_EQ(second.grades[0].total, 40);
  EXPECT_EQ(result("alice"), alice);

  submit("bob", solution_text(a1_));
  const GradeRun third = run_grading(job_);
  EXPECT_EQ(third.judged, 1);
  EXPECT_EQ(third.grades[1].total, 40);
  EXPECT_NE(result("bob"), bob);

  fs::remove_all(job_.results);  // from nothing: the same bytes
  job_.rubric.tests[0].points = 10;
  job_.jobs = 1;
  run_grading(job_);
  EXPECT_EQ(result("alice"), alice);
}

TEST_F(Grading, JudgesOnlyTheTestThatIsNew) {
  submit("alice", solution_text(a1_));
  run_grading(job_);
  const Result before = *read_result(job_.results / "alice");
  job_.rubric.tests[1].questions = 7;
  std::vector<RubricTest> missing;
  const std::string key = before.tests[0].key;
  const GradeRun run = run_grading(job_);
  EXPECT_EQ(run.judged, 1);
  const Result after = *read_result(job_.results / "alice");
  EXPECT_EQ(after.tests[0].key, key);
  EXPECT_NE(after.tests[1].key, before.tests[1].key);
}

TEST_F(Grading, DamagedResultsAreJudgedAgain) {
  submit("alice", solution_text(a1_));
  run_grading(job_);
  const std::string whole = result("alice");
  write(job_.results / "alice" / "result.json", whole.substr(0, whole.size() / 2));
  EXPECT_EQ(run_grading(job_).judged, 1);
  EXPECT_EQ(result("alice"), whole);
}

TEST_F(Grading, OddSubmissionsScoreNothingAndStopNobody) {
  submit("new\nline \"quote\" \xf0\x9f\x98\x80 <b>", solution_text(a1_));
  submit("nothing to see", "");
  for (const char* name : {"empty", "link", "pipe", "folder"}) {
    fs::create_directories(path("submissions") / name);
    job_.submissions.push_back(path("submissions") / name);
  }
  fs::create_symlink("/etc/passwd", path("submissions") / "link" / a1_.file);
  fs::create_directory_symlink(job_.submissions[0], path("submissions") / "another's");
  job_.submissions.push_back(path("submissions") / "another's");
  mkfifo((path("submissions") / "pipe" / a1_.file).c_str(), 0600);
  fs::create_directories(path("submissions") / "folder" / a1_.file);
  submit("large", std::string(2 << 20, ' '));
  const GradeRun run = run_grading(job_);
  ASSERT_EQ(run.grades.size(), 8u);
  for (const Grade& grade : run.grades) {
    EXPECT_EQ(grade.fault, "") << grade.submission;
    EXPECT_EQ(grade.total, grade.submission.starts_with("new") ? 20 : 0) << grade.submission;
  }
}

TEST_F(Grading, RosterMarksAndLateDays) {
  submit("team", solution_text(a1_));
  write(path("roster.csv"),
        "Student,ID,SIS Login ID,Group,Late days\n    Points Possible,,,,\n"
        "\"Lovelace, Ada\",1,ada,team,3\nBabbage,2,charles,team,\nTuring,3,alan,,\n");
  job_.roster = read_roster(path("roster.csv"));
  ASSERT_EQ(job_.roster.size(), 3u);
  job_.rubric.late = {.free_days = 1, .share_per_day = 0.1, .most_days = 5};
  write_empty_marks(path("marks.toml"), job_.rubric);
  EXPECT_TRUE(read_marks(path("marks.toml"), job_.rubric).empty());
  GradeRun run = run_grading(job_);
  ASSERT_EQ(run.grades.size(), 2u);
  EXPECT_EQ(run.grades[0].students.size(), 2u);
  EXPECT_EQ(run.grades[0].total, 16);  // 20, two days late
  EXPECT_FALSE(run.grades[1].handed_in);
  EXPECT_EQ(run.grades[1].students[0].name, "Turing");

  write(path("marks.toml"),
        "[team]\nstyle = 4\n\"A1.2\" = 6\nlate_days = 0\ncomment = \"on paper\"\n");
  job_.marks = read_marks(path("marks.toml"), job_.rubric);
  run = run_grading(job_);
  EXPECT_EQ(run.judged, 0);
  EXPECT_EQ(run.grades[0].total, 20);  // 10 + 6 + 4
  EXPECT_EQ(run.grades[0].comment, "on paper");
  write(path("marks.toml"), "[team]\nstile = 4\n");
  EXPECT_THROW(read_marks(path("marks.toml"), job_.rubric), Error);
}

TEST_F(Grading, WhatCountsNowhereIsSaid) {
  submit("team", starter_text(a1_));
  submit("stranger", starter_text(a1_));
  write(path("submissions") / "empty" / "notes.txt", "");
  job_.submissions.push_back(path("submissions") / "empty");
  job_.rubric.tests.clear();
  write(path("roster.csv"), "Student,ID,Folder\nAnn,1,team\nBob,2,empty\n");
  job_.roster = read_roster(path("roster.csv"));
  job_.marks = {{"team", {}}, {"taem", {}}};
  EXPECT_EQ(
      oddities(job_, run_grading(job_)),
      (std::vector<std::string>{"empty has no " + a1_.file,
                                "stranger is in no row of the roster, and so not in grades.csv",
                                "the marks of 'taem' are nobody's: there is no such submission"}));
}

TEST(Leaderboard, HasTheLeastWorkFirst) {
  const studio::TemporaryFolder folder;
  std::vector<Grade> grades;
  const auto hand_in = [&](const std::string& name, const std::string& times) {
    grades.push_back({.submission = name, .folder = safe_name(name)});
    write(fs::path(folder.file("")) / safe_name(name) / "times.json", times);
  };
  hand_in("more", "{\"A8.1\": 1, \"effort\": " + json_text(effort_json({3000, 7, 5, 0.5})) + "}");
  hand_in("=less", "{\"effort\": " + json_text(effort_json({2000, 7, 0, 0.25})) + "}");
  hand_in("wrong", "{\"A8.1\": 1}");
  hand_in("damaged", "{\"effort\": ");
  EXPECT_EQ(leaderboard_csv(folder.file(""), grades),
            "Submission,Evaluations,Fragments,Instructions,Seconds\r\n"
            "\"'=less\",2000,7,,0.25\r\nmore,3000,7,5,0.5\r\n");
}

TEST(LateFactor, LosesAShareADayAndThenAll) {
  const LatePolicy policy{.free_days = 1, .share_per_day = 0.25, .most_days = 4};
  for (const auto& [days, factor] : {std::pair{0, 1.0}, {1, 1.0}, {2, 0.75}, {4, 0.25}, {5, 0.0}})
    EXPECT_EQ(late_factor(policy, days), factor) << days;
}

}  // namespace
}  // namespace scanlit::assignments::test
