// An assignment, as the judge sees it.
//
// How to add one: a folder lessons/assignments/A4_shading with
//   page.md         the task, in the student's hands README.md; {{words}} are filled in by the seed
//   NAME.h          what the student's file includes: types, and the functions to write
//   NAME.cpp        the solution; strip.h says how the starter is made from it. A reflection model
//                   is a NAME.h alone: see answer/model.h
//   variant.h       the variant as constants, for who likes to write code that asks
//   questions.h     what the judge asks
//   main.cpp        serves these questions by calling those functions: see answer/serve.h
//   rubric.toml     points: see rubric.h
//   wrong.toml      typical wrong solutions, what they score and what is said about them
//   judge.cpp       `Assignment a4_shading()`: the variant, the parts
//   reference.cpp   what is right, for every variant; parts*.cpp: what is asked and said
// and one line in assignments.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "lessons/assignments/judge/respondent.h"
#include "lessons/assignments/judge/verdict.h"

namespace scanlit::assignments {

/// What a test found out.
struct Finding {
  double share = 1;     // of the points, 0..1
  std::string message;  // what is wrong; empty where share is 1

  static Finding wrong(std::string message) { return {0, std::move(message)}; }
};

/// A test while it runs.
struct Examination {
  Respondent& student;
  std::uint64_t variant;    // seed of the variant
  std::uint64_t questions;  // seed of what is asked
  std::vector<JudgedPicture>& pictures;
  // By number, what of the submission never ends whoever asks: not to be waited for again.
  std::set<std::int64_t>& endless;
};

struct Part {
  std::string id;    // "A1.2"
  std::string name;  // "Fill rule"
  std::function<Finding(Examination&)> run;
};

/// What {{places}} in the page and in variant.h stand for.
using Words = std::map<std::string, std::string>;

struct Assignment {
  std::string id;      // "A1"
  std::string title;   // "Scan conversion"
  std::string folder;  // "A1_scan_conversion", in lessons/assignments
  std::string file;    // what the student writes: "scan_conversion.cpp"
  std::string header;  // and includes: "scan_conversion.h"; none for a model
  std::function<Words(std::uint64_t seed)> words;
  // For the page: file names, and pictures of which `fresh` is shown.
  std::function<std::map<std::string, JudgedPicture>(std::uint64_t seed)> illustrations;
  std::vector<Part> parts;
  double cpu_seconds = 1e9;  // of a process, where that is less than the judge's own limit
  // For a leaderboard; nothing of a program that is not right.
  std::function<std::optional<Effort>(Examination&)> effort{};

  /// The student's file is a header, a formula over T, included by main.cpp: see answer/model.h.
  bool is_model() const { return header.empty(); }
};

/// All there are, in order.
const std::vector<Assignment>& assignments();

/// Throws Error where there is none of this id.
const Assignment& assignment(const std::string& id);

}  // namespace scanlit::assignments
