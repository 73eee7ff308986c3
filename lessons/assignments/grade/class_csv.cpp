#include <algorithm>

#include "lessons/assignments/grade/csv.h"
#include "lessons/assignments/grade/json_text.h"
#include "lessons/assignments/grade/writers.h"

namespace scanlit::assignments {

std::string class_csv(const std::string& assignment, const std::vector<Grade>& grades) {
  std::string text = csv_line({"Student", "ID", csv_text("SIS User ID"), csv_text("SIS Login ID"),
                               "Section", csv_text(plain_text(assignment))});
  if (!grades.empty())
    text += csv_line(
        {csv_text("    Points Possible"), "", "", "", "", csv_number(grades[0].max_points)});
  for (const Grade& grade : grades)
    for (const Student& student : grade.students) {
      CsvRow row;
      for (const std::string* cell : {&student.name, &student.id, &student.sis_user_id,
                                      &student.sis_login_id, &student.section})
        row.push_back(csv_text(plain_text(*cell)));
      row.push_back(csv_number(grade.total));
      text += csv_line(row);
    }
  return text;
}

std::string parts_csv(const std::vector<Grade>& grades) {
  CsvRow head{"Submission"};
  if (!grades.empty())
    for (const ScoredPart& part : grades[0].parts) head.push_back(csv_text(part.id));
  for (const char* name : {"Points", "Late days", "Total", "Comment"})
    head.push_back(csv_text(name));
  std::string text = csv_line(head);
  for (const Grade& grade : grades) {
    CsvRow row{csv_text(plain_text(grade.submission))};
    for (const ScoredPart& part : grade.parts) row.push_back(csv_number(part.points));
    row.push_back(csv_number(grade.points));
    row.push_back(csv_number(grade.late_days));
    row.push_back(csv_number(grade.total));
    row.push_back(csv_text(plain_text(grade.comment)));
    text += csv_line(row);
  }
  return text;
}

}  // namespace scanlit::assignments
