#include "lessons/assignments/grade/roster.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "lessons/assignments/grade/csv.h"
#include "lessons/studio/pages/page.h"
#include "lessons/studio/text.h"
#include "rasterizer/error.h"

namespace scanlit::assignments {
namespace {

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

/// Canvas's second row says what the most is: "    Points Possible".
bool is_a_student(const std::string& name) {
  return lower_case(name).find("points possible") == name.npos;
}

std::string first_of(std::initializer_list<std::string> texts) {
  for (const std::string& text : texts)
    if (!text.empty()) return text;
  return {};
}

}  // namespace

std::vector<Student> read_roster(const std::filesystem::path& file) {
  const std::vector<CsvRow> rows = read_csv(file.string(), studio::read_text(file));
  std::map<std::string, std::size_t> columns;
  if (!rows.empty())
    for (std::size_t i = 0; i < rows[0].size(); ++i) columns.try_emplace(lower_case(rows[0][i]), i);
  if (!columns.contains("student"))
    throw Error(file.string(), "the first row names the columns, one of which is Student");
  std::vector<Student> students;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const std::string where = file.string() + ": row " + std::to_string(r + 1);
    const auto cell = [&](const char* column) -> std::string {
      const auto place = columns.find(column);
      return place != columns.end() && place->second < rows[r].size() ? rows[r][place->second] : "";
    };
    Student student{cell("student"),      cell("id"),      cell("sis user id"),
                    cell("sis login id"), cell("section"), {}};
    if (student.name.empty()) throw Error(where, "a student without a name");
    if (!is_a_student(student.name)) continue;
    student.folder = first_of({cell("folder"), cell("group"), student.sis_login_id,
                               student.sis_user_id, student.id, student.name});
    const std::string days = cell("late days");
    if (!days.empty()) student.late_days = studio::parse_integer(where, days, {0, 365});
    students.push_back(std::move(student));
  }
  return students;
}

}  // namespace scanlit::assignments
