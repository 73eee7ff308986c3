#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lessons/assignments/grade/json_text.h"
#include "lessons/assignments/grade/writers.h"

namespace scanlit::assignments {
namespace {

double finite(double number) { return std::isfinite(number) ? number : 0; }

}  // namespace

std::string gradescope_results(const Grade& grade, const std::string& build_log) {
  using nlohmann::json;
  json tests = json::array();
  for (const ScoredPart& part : grade.parts) {
    if (part.manual && !part.by_hand) continue;  // Gradescope has a rubric of its own for these
    json test{{"number", part.id},
              {"name", plain_text(part.name)},
              {"score", finite(part.points)},
              {"max_score", finite(part.max_points)},
              {"status", part.points >= part.max_points ? "passed" : "failed"},
              {"visibility", "visible"}};
    if (!part.hidden && !part.message.empty()) {
      test["output"] = plain_text(part.message);
      test["output_format"] = "text";
    }
    tests.push_back(std::move(test));
  }
  json results{{"tests", std::move(tests)}, {"stdout_visibility", "hidden"}};
  std::string output;
  if (!grade.fault.empty()) output = "The judge failed; ask your instructor.";
  if (grade.fault.empty() && !grade.built) output = plain_text(build_log);
  if (!output.empty()) {
    results["output"] = output;
    results["output_format"] = "text";
  }
  return json_text(results);
}

}  // namespace scanlit::assignments
