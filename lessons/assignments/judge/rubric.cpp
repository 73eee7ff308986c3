#include "lessons/assignments/judge/rubric.h"

#include <algorithm>
#include <fstream>

#include "lessons/assignments/judge/assignment.h"
#include "lessons/studio/toml_table.h"
#include "rasterizer/error.h"

namespace scanlit::assignments {
namespace {

toml::table parse(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) throw Error(file.string(), "there is no such file");
  try {
    return toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    throw Error(file.string() + ":" + std::to_string(error.source().begin.line),
                std::string(error.description()));
  }
}

std::uint64_t seed_of(studio::TomlTable& table, const char* key, std::uint64_t otherwise = 1) {
  constexpr studio::Range seeds{0, 999999};
  return std::uint64_t(table.integer(key, seeds).value_or(int(otherwise)));
}

RubricTest read_test(studio::TomlTable& table, const Assignment& assignment,
                     std::uint64_t questions) {
  RubricTest test;
  const auto id = table.text("id");
  if (!id) throw Error(table.where(), "a test wants an id, such as \"" + assignment.id + ".1\"");
  test.id = *id;
  test.part = table.text("part").value_or(test.id);
  const auto part = std::ranges::find(assignment.parts, test.part, &Part::id);
  if (part == assignment.parts.end()) {
    std::vector<std::string> ids;
    for (const Part& each : assignment.parts) ids.push_back(each.id);
    throw Error(table.where("part"), "unknown part '" + test.part + "' of " + assignment.id +
                                         did_you_mean(test.part, ids));
  }
  test.name = table.text("name").value_or(part->name);
  const auto points = table.number("points", {0, 1000});
  if (!points) throw Error(table.where(), "a test wants points");
  test.points = *points;
  test.questions = seed_of(table, "questions", questions);
  table.refuse_unknown_keys();
  return test;
}

ManualPart read_manual(studio::TomlTable& table) {
  const auto id = table.text("id");
  const auto points = table.number("points", {0, 1000});
  if (!id || !points) throw Error(table.where(), "what is marked by hand wants an id and points");
  ManualPart part{*id, table.text("name").value_or(*id), *points};
  table.refuse_unknown_keys();
  return part;
}

LatePolicy read_late_policy(studio::TomlTable& table) {
  constexpr studio::Range days{0, 365};
  LatePolicy late;
  late.free_days = table.integer("free_days", days).value_or(late.free_days);
  late.share_per_day = table.number("share_per_day", {0, 1}).value_or(late.share_per_day);
  late.most_days = table.integer("most_days", days).value_or(late.most_days);
  table.refuse_unknown_keys();
  return late;
}

bool has_id(const Rubric& rubric, const std::string& id) {
  return std::ranges::find(rubric.tests, id, &RubricTest::id) != rubric.tests.end() ||
         std::ranges::find(rubric.manual, id, &ManualPart::id) != rubric.manual.end();
}

}  // namespace

Rubric read_rubric(const std::filesystem::path& file) {
  const toml::table parsed = parse(file);
  studio::TomlTable table(parsed, file.string(), "the rubric");
  Rubric rubric;
  const auto id = table.text("assignment");
  if (!id) throw Error(file.string(), "it does not say which assignment it is for");
  rubric.assignment = *id;
  const Assignment& of = assignment(*id);
  rubric.seed = seed_of(table, "seed");
  const std::uint64_t questions = seed_of(table, "questions");
  for (studio::TomlTable& each : table.tables("test")) {
    RubricTest test = read_test(each, of, questions);
    if (has_id(rubric, test.id))
      throw Error(each.where("id"), "there is a test '" + test.id + "' already");
    rubric.tests.push_back(std::move(test));
  }
  for (studio::TomlTable& each : table.tables("manual")) {
    ManualPart part = read_manual(each);
    if (has_id(rubric, part.id))
      throw Error(each.where("id"), "there is a part '" + part.id + "' already");
    rubric.manual.push_back(std::move(part));
  }
  if (auto late = table.table("late", "[late]")) rubric.late = read_late_policy(*late);
  table.refuse_unknown_keys();
  return rubric;
}

void add_hidden_tests(const std::filesystem::path& folder, Rubric& rubric) {
  const std::filesystem::path file = folder / (rubric.assignment + ".toml");
  if (!std::filesystem::exists(file)) return;
  const Rubric hidden = read_rubric(file);
  if (hidden.assignment != rubric.assignment)
    throw Error(file.string(), "it is for " + hidden.assignment + ", not " + rubric.assignment);
  for (RubricTest test : hidden.tests) {
    if (has_id(rubric, test.id))
      throw Error(file.string(), "there is a test '" + test.id + "' already");
    test.hidden = true;
    rubric.tests.push_back(std::move(test));
  }
}

}  // namespace scanlit::assignments
