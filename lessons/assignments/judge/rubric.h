// Which tests a submission is put to, and what they are worth: rubric.toml.
//
//   assignment = "A1"
//   seed = 7                   # draws the variant
//   questions = 2              # seed of what all tests ask that name no other (1)
//   [[test]]
//   id = "A1.2"                # of this test; unique
//   part = "A1.2"              # of the assignment: what is tested (the id)
//   name = "Fill rule"         # (the part's)
//   points = 15
//   questions = 3              # seed of what the student's code is asked here
//   [[manual]]                 # what a person gives points for: see grade/marks.h
//   id = "A1.style"
//   name = "Readable code"
//   points = 10
//   [late]
//   free_days = 1              # so late costs nothing (0)
//   share_per_day = 0.1        # of all points is lost for each day more (0)
//   most_days = 5              # later than that is 0 points (365)
//
// A folder of hidden tests holds a file of the same form for each assignment, A1.toml, whose tests
// are added.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scanlit::assignments {

struct RubricTest {
  std::string id, part, name;
  double points = 0;
  std::uint64_t questions = 1;
  bool hidden = false;
};

struct ManualPart {
  std::string id, name;
  double points = 0;
};

struct LatePolicy {
  int free_days = 0;
  double share_per_day = 0;
  int most_days = 365;
};

struct Rubric {
  std::string assignment;
  std::uint64_t seed = 1;
  std::vector<RubricTest> tests;
  std::vector<ManualPart> manual{};
  LatePolicy late{};
};

/// Throws Error, with file and line: not TOML, unknown assignment or part, an id given twice,
/// points that are not 0..1000, unknown keys.
Rubric read_rubric(const std::filesystem::path& file);

/// Adds the tests of folder/A1.toml, hidden, if that file is there. Throws as read_rubric().
void add_hidden_tests(const std::filesystem::path& folder, Rubric& rubric);

}  // namespace scanlit::assignments
