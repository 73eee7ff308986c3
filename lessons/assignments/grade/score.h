// From what the judge found and what a person decided to points.
#pragma once

#include <string>
#include <vector>

#include "lessons/assignments/grade/marks.h"
#include "lessons/assignments/grade/result.h"
#include "lessons/assignments/grade/roster.h"

namespace scanlit::assignments {

struct ScoredPart {
  std::string id, name, message{};
  double points = 0, max_points = 0;
  bool hidden = false, manual = false;
  bool by_hand = false;  // points are a person's
};

/// A submission with all that is written about it.
struct Grade {
  std::string submission;
  std::string folder;  // of its result, below the results
  std::vector<ScoredPart> parts{};
  double points = 0, max_points = 0;  // before lateness
  int late_days = 0;
  double total = 0;  // after it
  std::string comment{};
  std::string fault{};
  bool built = false, handed_in = true;
  std::string picture{};  // file below the results, of what the student drew; empty: none
  std::vector<Student> students{};
};

/// Points of parts marked by hand that nobody has marked yet are 0.
Grade score(const Result& result, const Rubric& rubric, const Marks& marks, int late_days);

/// The share of the points that is left after so many days, 0..1.
double late_factor(const LatePolicy& policy, int late_days);

}  // namespace scanlit::assignments
