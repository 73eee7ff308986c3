// Rubrics that are wrong are refused with file and line.
#include "lessons/assignments/judge/rubric.h"

#include <gtest/gtest.h>

#include <fstream>

#include "lessons/studio/tradeoff/temporary_folder.h"
#include "rasterizer/error.h"

namespace scanlit::assignments {
namespace {

class RubricFile : public testing::Test {
 protected:
  std::string write(const std::string& text, const char* name = "rubric.toml") {
    std::ofstream(folder_.file(name)) << text;
    return folder_.file(name);
  }
  std::string refusal(const std::string& text) {
    try {
      read_rubric(write(text));
      return "";
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find(folder_.file("rubric.toml")), 0u) << message;
      return message;
    }
  }
  static bool holds(const std::string& text, const char* part) {
    return text.find(part) != text.npos;
  }

  studio::TemporaryFolder folder_;
  const std::string one = "assignment = \"A1\"\n[[test]]\nid = \"A1.1\"\npoints = 5\n";
};

TEST_F(RubricFile, IsRead) {
  const Rubric rubric = read_rubric(write(
      "assignment = \"A1\"\nseed = 7\nquestions = 4\n[[test]]\nid = \"A1.2\"\npoints = 5\n"
      "[[test]]\nid = \"more\"\npart = \"A1.2\"\nname = \"More\"\npoints = 2.5\nquestions = 9"));
  EXPECT_EQ(rubric.seed, 7u);
  ASSERT_EQ(rubric.tests.size(), 2u);
  EXPECT_EQ(rubric.tests[0].name, "Fill rule");
  EXPECT_EQ(rubric.tests[1].part, "A1.2");
  EXPECT_EQ(rubric.tests[1].points, 2.5);
  EXPECT_EQ(rubric.tests[0].questions, 4u);
  EXPECT_EQ(rubric.tests[1].questions, 9u);
}

TEST_F(RubricFile, IsRefused) {
  EXPECT_TRUE(holds(refusal("assignment = "), ":1"));
  EXPECT_TRUE(holds(refusal("seed = 1"), "which assignment"));
  EXPECT_THROW(read_rubric(write("assignment = \"A99\"")), Error);
  EXPECT_TRUE(holds(refusal(one + "[[test]]\nid = \"A1.1\"\npoints = 1"), "already"));
  EXPECT_TRUE(holds(refusal(one + "[[test]]\nid = \"A1.77\"\npoints = 1"), "unknown part"));
  EXPECT_TRUE(holds(refusal(one + "[[test]]\npoints = 1"), "wants an id"));
  EXPECT_TRUE(holds(refusal(one + "[[test]]\nid = \"A1.2\""), "wants points"));
  EXPECT_TRUE(holds(refusal(one + "[[test]]\nid = \"A1.2\"\npoints = -1"), "-1"));
  EXPECT_TRUE(holds(refusal(one + "[[test]]\nid = \"A1.2\"\npoint = 1"), "points"));
  EXPECT_TRUE(holds(refusal("sead = 1\n" + one), "sead"));
  EXPECT_THROW(read_rubric(folder_.file("none.toml")), Error);
}

TEST_F(RubricFile, HiddenTestsAreAdded) {
  Rubric rubric = read_rubric(write(one));
  add_hidden_tests(folder_.file(""), rubric);  // there are none
  EXPECT_EQ(rubric.tests.size(), 1u);
  write("assignment = \"A1\"\n[[test]]\nid = \"A1.1h\"\npart = \"A1.1\"\npoints = 3", "A1.toml");
  add_hidden_tests(folder_.file(""), rubric);
  ASSERT_EQ(rubric.tests.size(), 2u);
  EXPECT_TRUE(rubric.tests[1].hidden);
  EXPECT_THROW(add_hidden_tests(folder_.file(""), rubric), Error);  // a second time
}

}  // namespace
}  // namespace scanlit::assignments
