// scanlit reflect --furnace, --reciprocity, --terms, --tabulate: numbers about a model.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "tests/cli/output_text.h"
#include "tests/cli/run_program.h"

namespace scanlit::test {
namespace {

TEST(ReflectReport, FurnaceOfADiffuser) {
  const Outcome outcome = Folder().run("reflect lambert:kd=.8/.5/.2 --furnace --angles 0,60,89");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(count_of(outcome.out, "0.800000  0.500000  0.200000"), 3u) << outcome.out;
  EXPECT_FALSE(contains(outcome.out, "Above 1")) << outcome.out;
  const Outcome bright = Folder().run("reflect blinn-phong:kd=1,ks=1,n=5 --furnace");
  EXPECT_TRUE(contains(bright.out, "Above 1")) << bright.out;
}

double violation(const std::string& specification) {
  const std::string out = Folder().run("reflect " + specification + " --reciprocity").out;
  const std::string name = "largest violation";
  return std::stod(out.substr(out.find(name) + name.size()));
}

TEST(ReflectReport, ReciprocityIsKeptByADiffuserAndBrokenByALobeWithoutNL) {
  EXPECT_LT(violation("lambert"), 1e-14);
  EXPECT_GT(violation("blinn-phong:kd=0"), 0.99);
  EXPECT_GT(violation("phong:kd=0,n=100000"), 0.9);
}

TEST(ReflectReport, TheTermsMultiplyToTheModel) {
  for (const std::string model :
       {"cook-torrance:D=ggx,a=.4,G=smith-correlated,F=dielectric,eta=1.7", "torrance-sparrow"}) {
    const Outcome outcome = Folder().run("reflect " + model + " --terms --angles 50");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    int rows = 0;
    for (const std::string& line : lines_of(outcome.out)) {
      std::istringstream words(line);
      double view_deg, half_deg, D, G, F, value;
      if (!(words >> view_deg >> half_deg >> D >> G >> F >> value)) continue;
      ++rows;
      EXPECT_DOUBLE_EQ(half_deg, (view_deg - 50) / 2);
      const double n_v = std::cos(view_deg * std::numbers::pi / 180);
      EXPECT_NEAR(value, std::numbers::pi / 4 * D * G * F / n_v, 2e-4 * value) << line;
    }
    EXPECT_EQ(rows, 13);
  }
}

TEST(ReflectReport, ATableCanBeAskedForItsModelAgain) {
  const Folder folder;
  EXPECT_EQ(folder.run("reflect lambert:kd=.8 --tabulate merl -o l.binary").exit_code, 0);
  folder.write("rows", "0 0 1 0 0 1\n");
  const Outcome value = folder.run("reflect merl:file=l.binary --values rows");
  EXPECT_NEAR(numbers_of(value.out)[0], 0.8, 1e-6) << value.err;
}

}  // namespace
}  // namespace scanlit::test
