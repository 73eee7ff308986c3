#include "lessons/assignments/grade/score.h"

#include <algorithm>
#include <cmath>

namespace scanlit::assignments {

double late_factor(const LatePolicy& policy, int late_days) {
  if (late_days > policy.most_days) return 0;
  return std::clamp(1 - policy.share_per_day * std::max(0, late_days - policy.free_days), 0.0, 1.0);
}

Grade score(const Result& result, const Rubric& rubric, const Marks& marks, int late_days) {
  Grade grade{.submission = result.submission, .folder = safe_name(result.submission)};
  for (const TestScore& test : verdict_of(result, rubric).tests)
    grade.parts.push_back({.id = test.id,
                           .name = test.name,
                           .message = test.message,
                           .points = test.points,
                           .max_points = test.max_points,
                           .hidden = test.hidden});
  for (const ManualPart& part : rubric.manual)
    grade.parts.push_back({.id = part.id,
                           .name = part.name,
                           .message = "",
                           .max_points = part.points,
                           .manual = true});
  for (ScoredPart& part : grade.parts) {
    const auto mark = marks.points.find(part.id);
    if (mark != marks.points.end()) {
      part.points = mark->second;
      part.by_hand = true;
    }
    grade.points += part.points;
    grade.max_points += part.max_points;
  }
  grade.late_days = marks.late_days.value_or(late_days);
  constexpr double hundredth = 100;
  grade.points = std::round(grade.points * hundredth) / hundredth;
  grade.total =
      std::round(grade.points * late_factor(rubric.late, grade.late_days) * hundredth) / hundredth;
  grade.comment = marks.comment;
  grade.fault = result.fault;
  grade.built = result.built;
  if (!result.pictures.empty())
    grade.picture = grade.folder + "/" + result.pictures.back().name + ".fresh.png";
  return grade;
}

}  // namespace scanlit::assignments
