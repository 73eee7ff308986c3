#include "tests/assignments/submissions.h"

#include <toml++/toml.h>

#include <fstream>

#include "lessons/assignments/judge/files.h"
#include "lessons/studio/tradeoff/temporary_folder.h"
#include "rasterizer/error.h"

namespace scanlit::assignments::test {

namespace fs = std::filesystem;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to,
                     const std::string& name) {
  const std::size_t at = text.find(from);
  if (at == text.npos || text.find(from, at + 1) != text.npos)
    throw Error("wrong.toml, " + name, "'" + from + "' does not stand in the solution once");
  return text.replace(at, from.size(), to);
}

}  // namespace

std::string solution_text(const Assignment& assignment) { return solution(assignment).text; }

std::string starter_text(const Assignment& assignment) { return starter(assignment).text; }

std::vector<WrongSolution> wrong_solutions(const Assignment& assignment) {
  const toml::table file =
      toml::parse_file((data_folder() / assignment.folder / "wrong.toml").string());
  std::vector<WrongSolution> all;
  for (const toml::node& node : *file["wrong"].as_array()) {
    const toml::table& entry = *node.as_table();
    WrongSolution wrong{.name = entry["name"].value_or(""),
                        .what = entry["what"].value_or(""),
                        .text = solution_text(assignment),
                        .variant = std::uint64_t(entry["variant"].value_or(1)),
                        .points = {},
                        .says = {}};
    for (const toml::node& pair : *entry["replace"].as_array())
      wrong.text = replaced(wrong.text, pair.as_array()->at(0).value_or(""),
                            pair.as_array()->at(1).value_or(""), wrong.name);
    for (const auto& [id, points] : *entry["points"].as_table())
      wrong.points[std::string(id.str())] = *points.value<double>();
    if (const toml::table* says = entry["says"].as_table())
      for (const auto& [id, words] : *says) wrong.says[std::string(id.str())] = words.value_or("");
    all.push_back(std::move(wrong));
  }
  return all;
}

namespace {

Verdict judge_by(const Rubric& rubric, const Assignment& assignment, const std::string& text) {
  const studio::TemporaryFolder folder;
  const fs::path submission = folder.file("submission"), scratch = folder.file("scratch");
  fs::create_directories(submission), fs::create_directories(scratch);
  std::ofstream(submission / assignment.file) << text;
  // An endless loop is found out sooner.
  return judge(assignment, submission, rubric, {.scratch = scratch, .limits = {.cpu_seconds = 2}});
}

}  // namespace

Verdict judge_text(const Assignment& assignment, const std::string& text, std::uint64_t seed) {
  Rubric rubric = read_rubric(data_folder() / assignment.folder / "rubric.toml");
  rubric.seed = seed;
  return judge_by(rubric, assignment, text);
}

Verdict judge_part(const Assignment& assignment, const std::string& text, const std::string& part,
                   std::uint64_t questions) {
  const RubricTest test{
      .id = part, .part = part, .name = part, .points = 1, .questions = questions};
  return judge_by({.assignment = assignment.id, .tests = {test}}, assignment, text);
}

}  // namespace scanlit::assignments::test
