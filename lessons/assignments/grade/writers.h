// Grades for those who read them: course systems, and people. Whatever text a submission brought
// along (names, the compiler's words) is made harmless for each reader.
#pragma once

#include <string>
#include <vector>

#include "lessons/assignments/grade/score.h"

namespace scanlit::assignments {

/// Gradescope's results.json of one submission, scores per test only; of a hidden test a student
/// sees name and points. The format is in gradescope_results.schema.json.
std::string gradescope_results(const Grade& grade, const std::string& build_log);

/// JUnit's XML: a suite for each submission, a case for each part, a failure where points are
/// missing.
std::string junit_xml(const std::string& assignment, const std::vector<Grade>& grades);

/// One row for each student, in the columns that Canvas imports; in Moodle, map SIS User ID to the
/// ID number or SIS Login ID to the user name. Students of a group have the same points.
std::string class_csv(const std::string& assignment, const std::vector<Grade>& grades);

/// One row for each submission with the points of each part.
std::string parts_csv(const std::vector<Grade>& grades);

/// Every submission with its picture and points, and which layers were in force.
std::string overview_page(const std::string& title, const std::vector<Grade>& grades,
                          const std::vector<std::string>& about);

}  // namespace scanlit::assignments
