// Every lesson is run as a reader runs it; its page shows what it draws and prints, and its picture
// fits a slide.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "rasterizer/image.h"
#include "tests/lessons/lesson_files.h"

namespace scanlit::test {
namespace {

using studio::LessonRun;

class LessonProgram : public testing::TestWithParam<std::string> {
 protected:
#ifdef SCANLIT_WITHOUT_RAYS
  void SetUp() override {
    if (GetParam() == "16_local_global") GTEST_SKIP() << "lesson 16 wants Embree: libembree-dev";
  }
#endif

  LessonRun run(const std::string& options = "") const {
    return studio::run_lesson(std::filesystem::path(SCANLIT_LESSONS) / GetParam(),
                              std::filesystem::path(SCANLIT_LESSONS) / "run", options);
  }
};

/// Every number of a text: "1,024" and "0.5" are one each.
std::vector<std::string> numbers_in(const std::string& text) {
  static const std::regex number(R"([0-9]+([.,][0-9]+)*)");
  return {std::sregex_token_iterator(text.begin(), text.end(), number), {}};
}

std::vector<std::string> bold_in(const std::string& page) {
  static const std::regex bold(R"(\*\*([^*]+)\*\*)");
  return {std::sregex_token_iterator(page.begin(), page.end(), bold, 1), {}};
}

void expect_page_states_what_is_printed(const std::string& name, const LessonRun& run) {
  const std::string file = name + ".md", page = studio::read_text(lessons_folder() / file);
  const auto names = all_lessons();
  const auto index = std::ranges::find(names, name) - names.begin();
  studio::PageParts parts = studio::parts_of(lessons_folder(), names, std::size_t(index));
  parts.prints = "```\n" + studio::lasting_figures(run.printed) + "```\n";
  EXPECT_EQ(page, studio::remade(file, page, parts)) << "run lessons/pages";

  const auto printed = numbers_in(run.printed);
  for (const std::string& figure : bold_in(page))
    for (const std::string& number : numbers_in(figure))
      EXPECT_TRUE(std::ranges::count(printed, number))
          << file << " states **" << figure << "**, which is not printed";
}

/// The share of the picture's width and of its height that something fills which is not as the
/// corner.
std::pair<double, double> filled(const Framebuffer& picture) {
  int left = picture.width, right = 0, top = picture.height, bottom = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const float* pixel = &picture.colour[4 * (std::size_t(y) * picture.width + x)];
      float difference = 0;
      for (int c = 0; c < 3; ++c) difference += std::abs(pixel[c] - picture.colour[c]);
      if (difference < 0.02f) continue;
      left = std::min(left, x), right = std::max(right, x + 1);
      top = std::min(top, y), bottom = std::max(bottom, y + 1);
    }
  return {double(right - left) / picture.width, double(bottom - top) / picture.height};
}

// The size of words is the canvas' business; that none is left out, the lack of warnings says.
void expect_fit_for_a_slide(const Framebuffer& picture) {
  const auto [across, down] = filled(picture);
  EXPECT_GT(across, 0.85) << "of the width is used";
  EXPECT_GT(down, 0.7) << "of the height is used";
  std::size_t clipped = 0;
  for (std::size_t i = 0; i < picture.colour.size(); i += 4)
    clipped += *std::max_element(&picture.colour[i], &picture.colour[i] + 3) > 1.0001f;
  EXPECT_LT(double(clipped), 0.005 * double(picture.pixel_count())) << "clipped pixels";
}

TEST_P(LessonProgram, DrawsAndPrintsWhatItsPageShows) {
  const LessonRun lesson = run();
  ASSERT_EQ(lesson.exit_code, 0) << lesson.complaints;
  EXPECT_EQ(lesson.complaints, "");
  expect_page_states_what_is_printed(GetParam(), lesson);
  expect_fit_for_a_slide(lesson.picture);
  // Letters may be drawn otherwise where the font or its library is another one.
  const auto picture = lessons_folder() / (GetParam() + ".png");
  ASSERT_TRUE(std::filesystem::exists(picture)) << "run lessons/pages";
  EXPECT_LT(studio::differing_share(read_image(picture), lesson.picture, 0.02), 0.003)
      << "run lessons/pages";
}

TEST_P(LessonProgram, DrawsSmallToo) {
  const LessonRun lesson = run("--size 40x30");
  ASSERT_EQ(lesson.exit_code, 0) << lesson.complaints;
  EXPECT_EQ(lesson.picture.width, 40);
  EXPECT_EQ(lesson.picture.height, 30);
}

TEST_P(LessonProgram, ExplainsItselfAndRefusesWhatItCannotDo) {
  const LessonRun help = run("--help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.printed.find("\nUsage: " + GetParam()), std::string::npos) << help.printed;
  const LessonRun lesson = run("--size 0x1");
  EXPECT_EQ(lesson.exit_code, 2);
  EXPECT_TRUE(lesson.complaints.starts_with("error: --size")) << lesson.complaints;
}

INSTANTIATE_TEST_SUITE_P(Lessons, LessonProgram, testing::ValuesIn(all_lessons()),
                         [](const auto& lesson) { return lesson.param; });

}  // namespace
}  // namespace scanlit::test
