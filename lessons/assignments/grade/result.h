// What judging one submission gave, kept in a folder of its own, so that grading again judges only
// what has changed. Points are shares here: what a test is worth is the rubric's to change.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lessons/assignments/judge/judge.h"

namespace scanlit::assignments {

/// Of a test, with what it stood on when it was judged: submission, package, variant, questions.
struct TestResult {
  std::string id, part, key, message;
  double share = 0;  // 0..1, the judge's
};

struct Result {
  std::string submission;  // its folder's name, whatever that is
  std::string fault;       // the judge's own, in which case there is nothing else
  bool built = false;
  std::string build_log;
  std::string layers;  // in force while it was judged
  std::vector<TestResult> tests;
  std::vector<JudgedPicture> pictures;
};

/// result.json and the pictures, there last, at once. No times: two runs write the same bytes.
void write_result(const std::filesystem::path& folder, const Result& result);

/// Nothing where there is none, or no whole one.
std::optional<Result> read_result(const std::filesystem::path& folder);

/// A folder's name for a submission's, whatever the latter is: letters, digits, '-', '_', '.'
/// and the rest as %XX; long ones end in a fingerprint.
std::string safe_name(const std::string& submission);

/// As a verdict of this rubric.
Verdict verdict_of(const Result& result, const Rubric& rubric);

}  // namespace scanlit::assignments
