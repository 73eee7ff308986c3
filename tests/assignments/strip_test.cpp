#include "lessons/assignments/judge/strip.h"

#include <gtest/gtest.h>

#include "lessons/assignments/judge/dice.h"
#include "rasterizer/error.h"

namespace scanlit::assignments {
namespace {

TEST(Strip, LeavesTheTaskAndTheStartersLines) {
  const std::string solution =
      "#include <a>\n"
      "//<<\n"
      "int helper();\n"
      "\n"
      "//>>\n"
      "int f() {\n"
      "  //<< TODO(A1.2) What f does,\n"
      "  //<< in two lines.\n"
      "  return helper();\n"
      "  //== if (true)\n"
      "  //==   return 0;\n"
      "  //==\n"
      "  //>>\n"
      "}\n";
  EXPECT_EQ(strip(solution, "f.cpp"),
            "#include <a>\n"
            "int f() {\n"
            "  // TODO(A1.2) What f does,\n"
            "  // in two lines.\n"
            "  if (true)\n"
            "    return 0;\n"
            "\n"
            "}\n");
}

TEST(Strip, RefusesRegionsThatDoNotEnd) {
  EXPECT_THROW(strip("//<< a\nx\n", "f.cpp"), Error);
  EXPECT_THROW(strip("//<< a\nx\n//<< b\n//>>\n", "f.cpp"), Error);
  EXPECT_THROW(strip("//>>\n", "f.cpp"), Error);
  EXPECT_THROW(strip("//== x\n", "f.cpp"), Error);
}

TEST(FillIn, PutsWordsInTheirPlaces) {
  EXPECT_EQ(fill_in("y is {{y}}, {{y}}", {{"y", "up"}}, "page.md"), "y is up, up");
  EXPECT_THROW(fill_in("{{z}}", {{"y", "up"}}, "page.md"), Error);
  EXPECT_THROW(fill_in("{{z", {{"z", "up"}}, "page.md"), Error);
}

TEST(Dice, AreTheSameOnEveryMachine) {
  Dice dice(7, "A1");
  EXPECT_EQ(dice.next(), 14658930891709472435u);
  Dice other(7, "A2");
  EXPECT_NE(Dice(7, "A1").next(), other.next());
  for (int i = 0; i < 1000; ++i) {
    const int n = dice.between(-2, 3);
    EXPECT_TRUE(n >= -2 && n <= 3);
    const double x = dice.unit();
    EXPECT_TRUE(x >= 0 && x < 1);
  }
}

}  // namespace
}  // namespace scanlit::assignments
