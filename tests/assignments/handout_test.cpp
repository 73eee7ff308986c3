// What a student gets, and what is said to one who prints.
#include "lessons/assignments/judge/handout.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "lessons/assignments/judge/rubric.h"
#include "lessons/studio/pages/page.h"
#include "lessons/studio/tradeoff/temporary_folder.h"
#include "rasterizer/error.h"
#include "tests/assignments/submissions.h"

namespace scanlit::assignments::test {
namespace {

namespace fs = std::filesystem;

TEST(HandOut, FillsAFolderWithoutTheSolution) {
  const studio::TemporaryFolder there;
  for (const Assignment& assignment : assignments()) {
    SCOPED_TRACE(assignment.id);
    const fs::path folder = there.file(assignment.id.c_str());
    hand_out(assignment, 12345, folder);
    EXPECT_EQ(read_rubric(folder / "rubric.toml").seed, 12345u);
    const std::string given = studio::read_text(folder / assignment.file);
    EXPECT_EQ(given, starter_text(assignment));
    EXPECT_NE(given.find("TODO(" + assignment.id + '.'), given.npos);
    EXPECT_EQ(given.find("//<<"), given.npos);
    const std::string page = studio::read_text(folder / "README.md");
    EXPECT_NE(page.find("variant 12345"), page.npos);
    EXPECT_EQ(page.find("{{"), page.npos);
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file() || entry.path().extension() == ".png") continue;
      EXPECT_EQ(studio::read_text(entry.path()).find("//>>"), std::string::npos) << entry.path();
    }
  }
}

TEST(HandOut, RefusesAFolderThatHoldsSomething) {
  const studio::TemporaryFolder there;
  std::ofstream(there.file("mine.txt")) << "work of days";
  EXPECT_THROW(hand_out(assignment("A1"), 1, there.file("")), Error);
  EXPECT_EQ(studio::read_text(there.file("mine.txt")), "work of days");
}

TEST(HandOut, VariantsDiffer) {
  for (const Assignment& assignment : assignments()) {
    std::set<Words> variants;
    for (std::uint64_t seed = 0; seed < 50; ++seed) variants.insert(assignment.words(seed));
    EXPECT_GE(variants.size(), 5u) << assignment.id;
  }
}

TEST(Judging, KeepsWhatTheProgramPrints) {
  std::string text = starter_text(assignment("A1"));
  text.insert(text.find("return {0, 0, 1};"), "__builtin_printf(\"corner %d\\n\", 42); ");
  const Verdict verdict = judge_text(assignment("A1"), text);
  EXPECT_NE(verdict.tests[0].printed.find("corner 42\n"), std::string::npos);
  EXPECT_EQ(verdict.tests[1].printed, "");
}

}  // namespace
}  // namespace scanlit::assignments::test
