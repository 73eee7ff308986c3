// Grades many submissions: what has changed is judged, each in a process of its own, so that
// neither a submission nor a fault of the judge's on one of them ends the run.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "lessons/assignments/grade/score.h"

namespace scanlit::assignments {

struct GradeJob {
  std::vector<std::filesystem::path> submissions;  // folders, each of another name
  Rubric rubric;                                   // with hidden tests
  std::filesystem::path results;                   // folder
  std::vector<Student> roster;                     // empty: every submission is a student
  std::map<std::string, Marks> marks;
  sandbox::Layers layers;
  int jobs = 1;
  std::function<void(double)> progress;  // called with 0..1
};

struct GradeRun {
  std::vector<Grade> grades;  // sorted by name; those who handed nothing in, last
  int judged = 0, kept = 0;   // submissions: judged now, at least in part, or as before
};

/// Judges what is to be judged, and writes each submission's result.json, report.html and
/// results.json when it is known. Safe to kill and to repeat: whole results are kept.
GradeRun run_grading(const GradeJob& job);

/// What an instructor would want to be told before grades are handed on: submissions without the
/// file that is judged, submissions whose points no row of the roster takes, marks for nobody.
std::vector<std::string> oddities(const GradeJob& job, const GradeRun& run);

/// What of an earlier result still stands: tests whose submission, package, variant and questions
/// are what they were. The rest is in `missing`.
Result standing(const Result& earlier, const Rubric& rubric, const std::string& submission_key,
                std::vector<RubricTest>& missing);

/// Tells apart versions of the submission's file, and of everything that judges it.
std::string submission_key(const std::filesystem::path& submission, const Assignment& assignment);
std::string package_key(const Assignment& assignment, std::uint64_t seed);

}  // namespace scanlit::assignments
