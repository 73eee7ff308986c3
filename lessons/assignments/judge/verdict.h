// What judging a submission gives: points, the judge's words, pictures. Plain data, so that
// grading, tables and pages need nothing of the machinery that judges.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scanlit::assignments {

/// One test of the rubric.
struct TestScore {
  std::string id{};    // "A1.2"
  std::string name{};  // "Fill rule"
  double points = 0, max_points = 0;
  bool hidden = false;    // a student sees name and points only
  std::string message{};  // UTF-8, several lines, the judge's own words; empty with full points
  std::string printed{};  // by the program, for the student's own eyes: text of any kind, cut short
  double seconds = 0;     // wall time; never compared
};

/// A picture that the judge drew, 8-bit sRGB codes, rgb, row 0 on top. All three are of one size.
struct JudgedPicture {
  std::string name{};   // "A1.6-teapot": letters, digits, '.', '-'
  std::string title{};  // "The teapot, by your fragments"
  int width = 0, height = 0;
  std::vector<std::uint8_t> fresh{};      // by the student's stage
  std::vector<std::uint8_t> reference{};  // as it should be
  std::vector<std::uint8_t> difference{};
};

/// What a right program has done, for a leaderboard: never for points.
struct Effort {
  std::int64_t evaluations = 0;   // of the model, counted by the judge
  std::int64_t fragments = 0;     // that were evaluated at all
  std::int64_t instructions = 0;  // counted by callgrind; 0 where it cannot be had
  double seconds = 0;             // wall time, on fresh questions; never compared
};

struct Verdict {
  std::string assignment{};  // "A1"
  std::uint64_t seed = 0;    // of the variant
  std::vector<TestScore> tests{};
  std::string build_log{};  // the compiler's words: text that students can shape, of limited length
  bool built = false;
  std::vector<JudgedPicture> pictures{};
  std::optional<Effort> effort{};
};

double points(const Verdict& verdict);
double max_points(const Verdict& verdict);

}  // namespace scanlit::assignments
