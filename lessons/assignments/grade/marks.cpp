#include "lessons/assignments/grade/marks.h"

#include "lessons/assignments/grade/write_file.h"
#include "lessons/studio/toml_table.h"
#include "rasterizer/error.h"

namespace scanlit::assignments {

std::map<std::string, Marks> read_marks(const std::filesystem::path& file, const Rubric& rubric) {
  std::map<std::string, Marks> all;
  toml::table parsed;
  try {
    parsed = toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    throw Error(file.string() + ":" + std::to_string(error.source().begin.line),
                std::string(error.description()));
  }
  studio::TomlTable table(parsed, file.string(), "the marks");
  for (const std::string& folder : table.keys()) {
    auto entry = *table.table(folder.c_str(), "[" + folder + "]");
    Marks marks;
    const auto read = [&](const std::string& id) {
      if (const auto points = entry.number(id.c_str(), {0, 1000})) marks.points[id] = *points;
    };
    for (const RubricTest& test : rubric.tests) read(test.id);
    for (const ManualPart& part : rubric.manual) read(part.id);
    marks.late_days = entry.integer("late_days", {0, 365});
    marks.comment = entry.text("comment").value_or("");
    entry.refuse_unknown_keys();
    all[folder] = std::move(marks);
  }
  return all;
}

void write_empty_marks(const std::filesystem::path& file, const Rubric& rubric) {
  if (std::filesystem::exists(file)) return;
  std::string text =
      "# Points by hand and in place of the judge's; grading again keeps this file.\n"
      "#\n"
      "#   [alice]                 # a submission's folder\n";
  const std::string id = !rubric.manual.empty()  ? rubric.manual[0].id
                         : !rubric.tests.empty() ? rubric.tests[0].id
                                                 : "A1.1";
  text += "#   \"" + id + "\" = 8\n";
  text +=
      "#   late_days = 0           # in place of the roster's\n"
      "#   comment = \"handed in on paper\"\n";
  write_file(file, text);
}

}  // namespace scanlit::assignments
