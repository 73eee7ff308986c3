// scanlit tradeoff: the page, its figures, and what is refused before anything is measured.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/output_text.h"
#include "tests/cli/refusal.h"

namespace scanlit::test {
namespace {

TEST(Tradeoff, MakesOnePageWithAPictureBehindEachPoint) {
  const Folder folder;
  const Outcome outcome = folder.run("tradeoff --axis perspective -o p.html --json p.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("p.html: 6 points, ")) << outcome.out;
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"p.html", "p.json"}));
  const std::string page = folder.read("p.html");
  EXPECT_EQ(count_of(page, "<a href=\"#perspective-"), 6u);
  EXPECT_EQ(count_of(page, "<figure id=\"perspective-"), 6u);
  EXPECT_EQ(count_of(page, "src=\"data:image/png;base64,iVBOR"), 6u);
  EXPECT_EQ(count_of(page, "src=\""), 6u) << "the page needs another file";
  EXPECT_EQ(count_of(page, "<svg"), 1u);
  EXPECT_EQ(count_of(page, "</html>"), 1u);
}

// What the lecture tells of perspective, whatever the machine: errors, not times.
TEST(Tradeoff, FiguresTellTheStory) {
  const Folder folder;
  ASSERT_EQ(folder.run("tradeoff --axis perspective --json p.json").exit_code, 0);
  const auto json = nlohmann::json::parse(folder.read("p.json"));
  EXPECT_EQ(json["threads"], 1);
  EXPECT_FALSE(json["machine"].get<std::string>().empty());
  const auto& points = json["axes"][0]["points"];
  ASSERT_EQ(points.size(), 6u);
  std::vector<double> steps;
  for (const auto& point : points) {
    steps.push_back(point["interior"]["rms_steps"]);
    EXPECT_GT(point["ms"], 0);
    EXPECT_GT(point["interior"]["pixels"], 50000);
  }
  EXPECT_LT(steps[0], 1e-3);               // at every pixel: rounding alone
  EXPECT_LT(10 * steps[0], steps[1]);      // every 8
  EXPECT_NEAR(steps[2] / steps[1], 4, 1);  // twice as far apart, four times the error
  EXPECT_LT(100 * steps[2], steps[3]);     // affine
  EXPECT_LT(steps[4], 1e-3);               // the engine
  EXPECT_NEAR(steps[5], steps[3], 0.01 * steps[3]);
}

TEST(Tradeoff, RefusesWhatItCannotDo) {
  const Folder folder;
  struct Bad {
    const char *arguments, *message;
  };
  for (const auto& [arguments, message] : {
           Bad{"--axis perspectiv",
               "--axis: unknown axis 'perspectiv'; did you mean 'perspective'?"},
           {"--axis perspective -o page.txt", "--output: 'page.txt' is not a .html file"},
           {"--axis perspective --json figures.html", "--json: 'figures.html' is not a .json file"},
           {"--axis perspective --json \"\"", "--json: '' is not a .json file"},
           {"--axis perspective -o nowhere/page.html", "nowhere/page.html"},
           {"teapot", "unexpected argument 'teapot'"},
           {"--axes all", "unknown option '--axes'; did you mean '--axis'?"},
       }) {
    expect_refusal(folder.run(std::string("tradeoff ") + arguments), message);
    EXPECT_EQ(folder.files(), std::vector<std::string>{}) << arguments;
  }
}

}  // namespace
}  // namespace scanlit::test
