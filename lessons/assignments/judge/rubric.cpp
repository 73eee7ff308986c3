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

std::uint64_t seed_of(studio::TomlTable& table, const char* key) {
  constexpr studio::Range seeds{0, 2147483647};
  return std::uint64_t(table.integer(key, seeds).value_or(1));
}

RubricTest read_test(studio::TomlTable& table, const Assignment& assignment) {
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
  test.questions = seed_of(table, "questions");
  table.refuse_unknown_keys();
  return test;
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
  for (studio::TomlTable& each : table.tables("test")) {
    RubricTest test = read_test(each, of);
    if (std::ranges::find(rubric.tests, test.id, &RubricTest::id) != rubric.tests.end())
      throw Error(each.where("id"), "there is a test '" + test.id + "' already");
    rubric.tests.push_back(std::move(test));
  }
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
    if (std::ranges::find(rubric.tests, test.id, &RubricTest::id) != rubric.tests.end())
      throw Error(file.string(), "there is a test '" + test.id + "' already");
    test.hidden = true;
    rubric.tests.push_back(std::move(test));
  }
}

}  // namespace scanlit::assignments
