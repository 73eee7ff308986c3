// What a person decides, beside what the judge finds: marks.toml, which no regrade touches.
//
//   [alice]                  # a submission's folder
//   "A1.style" = 8           # points of a part that the rubric has under [[manual]]
//   "A1.2" = 20              # in place of the judge's points
//   late_days = 0            # in place of the roster's
//   comment = "handed in on paper"
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "lessons/assignments/judge/rubric.h"

namespace scanlit::assignments {

struct Marks {
  std::map<std::string, double> points;  // by id
  std::optional<int> late_days;
  std::string comment;
};

/// By the submission's folder. Throws Error, with file and line: not TOML, an id that the rubric
/// does not have, points that are not 0..1000.
std::map<std::string, Marks> read_marks(const std::filesystem::path& file, const Rubric& rubric);

/// A file that says how it is filled in, where there is none.
void write_empty_marks(const std::filesystem::path& file, const Rubric& rubric);

}  // namespace scanlit::assignments
