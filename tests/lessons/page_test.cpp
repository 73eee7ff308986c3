// What makes the lessons' pages, and what all pages have in common.
#include "lessons/studio/pages/page.h"

#include <gtest/gtest.h>

#include <regex>

#include "lessons/studio/drawing/canvas.h"
#include "rasterizer/error.h"
#include "tests/lessons/lesson_files.h"

namespace scanlit::test {
namespace {

namespace fs = std::filesystem;

TEST(MarkedCode, IsWhatStandsBetweenTheMarksMovedToTheLeft) {
  EXPECT_EQ(studio::marked_code("x",
                                "a\n  // new idea\n  b\n\n    c\n  // end of new idea\nd\n"
                                "// new idea\ne\n// end of new idea\n"),
            "b\n\n  c\n\ne\n");
}

TEST(MarkedCode, RefusesMarksThatDoNotMatch) {
  EXPECT_THROW(studio::marked_code("x", "a\n"), Error);
  EXPECT_THROW(studio::marked_code("x", "// new idea\na\n"), Error);
  EXPECT_THROW(studio::marked_code("x", "// end of new idea\n"), Error);
  EXPECT_THROW(studio::marked_code("x", "// new idea\n// new idea\n"), Error);
}

TEST(Page, EveryPartIsMadeAnew) {
  const auto part = [](const std::string& name, const std::string& text) {
    return "<!-- made: " + name + " -->\n" + text + "<!-- end -->\n";
  };
  const std::string before = "# 1\n" + part("code", "old\n") + "a" + part("prints", "") +
                             part("way", "old\n"),
                    after = "# 1\n" + part("code", "c\n") + "a" + part("prints", "p\n") +
                            part("way", "w\n");
  EXPECT_EQ(studio::remade("x.md", before, {"c\n", "p\n", "w\n"}), after);
  EXPECT_THROW(studio::remade("x.md", part("code", ""), {}), Error) << "the others are missing";
  EXPECT_THROW(studio::remade("x.md", before + part("cod", ""), {}), Error);
  EXPECT_THROW(studio::remade("x.md", "<!-- made: code -->\n", {}), Error);
}

TEST(LastingFigures, AreNoTimesAndNotTheLastLine) {
  EXPECT_EQ(studio::lasting_figures("a: 1\nb: 2.5 ms\nc: 3\nx.png: 4 x 5 pixels\n"),
            "a: 1\nc: 3\n");
}

TEST(DifferingShare, CountsPixelsThatAScreenShowsToDiffer) {
  Framebuffer a(10, 1), b(10, 1);
  b.colour[0] = 0.001f;  // 3 codes of 255
  b.colour[4] = 0.5f;
  EXPECT_DOUBLE_EQ(studio::differing_share(a, b, 0.02), 0.1);
  EXPECT_DOUBLE_EQ(studio::differing_share(a, b, 0.01), 0.2);
  EXPECT_EQ(studio::differing_share(a, Framebuffer(9, 1), 1), 1);
}

TEST(WordSizes, CanBeReadFromTheBackOfARoom) {
  for (int height = 400; height < 2000; ++height) {
    EXPECT_GE(40 * studio::word_sizes(height).smallest, height);
    EXPECT_GE(studio::word_sizes(height).largest, studio::word_sizes(height).smallest);
  }
}

TEST(Pages, EveryLessonHasItsParts) {
  for (const std::string& name : all_lessons()) {
    const std::string page = studio::read_text(lessons_folder() / (name + ".md"));
    for (const std::string& part : {"](" + name + ".png)", std::string("\n## Try"),
                                    std::string("\n## Question"), std::string("<details>")})
      EXPECT_NE(page.find(part), std::string::npos) << name << ".md has no " << part;
    const std::string number = std::to_string(std::stoi(name)) + ". ";
    EXPECT_TRUE(studio::page_title(lessons_folder(), name).starts_with(number)) << name;
  }
}

TEST(Pages, TheSyllabusHasEveryLesson) {
  const std::string syllabus = studio::read_text(lessons_folder() / "README.md");
  for (const std::string& name : all_lessons())
    EXPECT_NE(syllabus.find("](" + name + ".md)"), std::string::npos) << name;
}

TEST(Pages, LinksLeadSomewhere) {
  std::vector<fs::path> pages = {lessons_folder() / "README.md",
                                 lessons_folder().parent_path() / "README.md"};
  for (const std::string& name : all_lessons()) pages.push_back(lessons_folder() / (name + ".md"));
  const std::regex link(R"(\]\(([^)# ]+)[^) ]*\))");
  for (const fs::path& page : pages) {
    // Not in code, where [&](int i) is none.
    const std::string text =
        std::regex_replace(studio::read_text(page), std::regex("```[^`]*```"), "");
    for (std::sregex_token_iterator at(text.begin(), text.end(), link, 1), end; at != end; ++at)
      EXPECT_TRUE(at->str().starts_with("http") || fs::exists(page.parent_path() / at->str()))
          << page << " links to " << *at;
  }
}

}  // namespace
}  // namespace scanlit::test
