// A lesson is short, says what it is about, and writes by hand only what no other lesson teaches.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>

#include "lessons/studio/pages/page.h"
#include "tests/lessons/lesson_files.h"

namespace scanlit::test {
namespace {

constexpr int most_lines = 90, most_idea_lines = 30, most_like_lines = 6;

// Lessons that are longer, and why.
const std::map<std::string, std::string> long_lessons = {
    {"16_local_global", "furnishes a room"},
    {"23_shadowing", "draws the groove with its rays, to count what the formula claims"},
    {"24_fresnel", "charts and teapots of two materials"},
    {"26_copper", "a spectrum wants a landscape, curves and colours"},
    {"34_spans_in_vectors", "draws the lanes beside the pictures, and measures"},
    {"35_shading_once", "its own balls and scan conversion, so that shading can be counted"},
    {"36_skipping", "furnishes a crowd, and charts what is counted of it"},
    {"38_numbers_break", "three places, each without care and with"},
    {"39_time_and_error", "draws, measures and charts 22 ways"}};
const std::map<std::string, std::string> long_ideas = {
    {"38_numbers_break", "three places, each an idea of its own"}};

class LessonSource : public testing::TestWithParam<std::string> {
 protected:
  std::string source() const { return studio::read_text(lessons_folder() / (GetParam() + ".cpp")); }
};

TEST_P(LessonSource, SaysInThreeLinesWhatItIsAbout) {
  const auto lines = lines_of(source());
  ASSERT_GE(lines.size(), 4u);
  EXPECT_TRUE(lines[0].starts_with("// New idea: ")) << lines[0];
  EXPECT_TRUE(lines[1].starts_with("// Builds on: ")) << lines[1];
  EXPECT_TRUE(lines[2].starts_with("// Try: ")) << lines[2];
  EXPECT_FALSE(lines[3].starts_with("//")) << lines[3];
}

TEST_P(LessonSource, IsShort) {
  const auto lines = lines_of(source());
  const auto idea = lines_of(studio::marked_code(GetParam(), source()));
  EXPECT_EQ(int(lines.size()) > most_lines, long_lessons.contains(GetParam())) << lines.size();
  EXPECT_EQ(int(idea.size()) > most_idea_lines, long_ideas.contains(GetParam())) << idea.size();
  for (const std::string& line : lines) EXPECT_LE(line.size(), 100u) << line;
}

// Without what all lessons begin and end with.
std::vector<std::string> own_lines(const std::string& name) {
  std::vector<std::string> result;
  for (std::string line : lines_of(studio::read_text(lessons_folder() / (name + ".cpp")))) {
    line.erase(0, line.find_first_not_of(' '));
    if (!line.empty() && line != "}" && line != "});" && !line.starts_with("#include") &&
        !line.starts_with("using namespace") && !line.starts_with("namespace"))
      result.push_back(line);
  }
  return result;
}

TEST_P(LessonSource, RepeatsNoOtherLesson) {
  const auto mine = own_lines(GetParam());
  for (const std::string& other : all_lessons()) {
    if (other >= GetParam()) continue;  // each pair once
    const auto theirs = own_lines(other);
    for (std::size_t i = 0; i < mine.size(); ++i)
      for (std::size_t j = 0; j < theirs.size(); ++j) {
        const auto end = std::mismatch(mine.begin() + std::ptrdiff_t(i), mine.end(),
                                       theirs.begin() + std::ptrdiff_t(j), theirs.end());
        ASSERT_LE(end.first - mine.begin() - std::ptrdiff_t(i), most_like_lines)
            << other << " has these lines, too, from: " << mine[i];
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Lessons, LessonSource, testing::ValuesIn(all_lessons()),
                         [](const auto& lesson) { return lesson.param; });

}  // namespace
}  // namespace scanlit::test
