// scanlit reflect --values: the values of a model, row by row.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/output_text.h"
#include "tests/cli/refusal.h"

namespace scanlit::test {
namespace {

/// Rows of tests/unit/reflection_values.csv, by specification, as they stand there.
std::map<std::string, std::vector<std::string>> reference_rows() {
  std::ifstream file(SCANLIT_SOURCE_DIR "/tests/unit/reflection_values.csv");
  std::map<std::string, std::vector<std::string>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    const bool quoted = line.starts_with('"');
    const std::string specification =
        line.substr(quoted, line.find(quoted ? "\"," : ",", 1) - quoted);
    rows[specification].push_back(line);
  }
  return rows;
}

TEST(ReflectValues, AgreeWithTheReferenceInAllPrecisions) {
  const Folder folder;
  std::size_t compared = 0;
  for (const auto& [specification, rows] : reference_rows()) {
    // The unit tests know how far the float values of each other model may be off.
    const std::string name = specification.substr(0, specification.find(':'));
    if (name != "lambert" && name != "phong" && name != "blinn-phong") continue;
    std::string text = "case,lx,ly,lz,vx,vy,vz,r,g,b\n";
    std::vector<std::vector<double>> expected;
    double peak = 0;
    for (const std::string& row : rows) {
      text += row + "\n";
      std::vector<double> rgb;
      std::istringstream stream(row);
      for (std::string field; std::getline(stream, field, ',');)
        rgb.push_back(std::strtod(field.c_str(), nullptr));
      expected.emplace_back(rgb.end() - 3, rgb.end());
      for (const double value : expected.back()) peak = std::max(peak, value);
    }
    folder.write("rows.csv", text);
    for (const auto& [precision, share] :
         {std::pair{"double", 1e-9}, {"float", 2e-5}, {"batch", 2e-5}}) {
      const Outcome outcome =
          folder.run("reflect '" + specification + "' --values rows.csv --precision " + precision);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      const auto lines = lines_of(outcome.out);
      ASSERT_EQ(lines.size(), rows.size()) << specification;
      for (std::size_t i = 0; i < lines.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c, ++compared)
          EXPECT_NEAR(numbers_of(lines[i])[c], expected[i][c], share * peak)
              << specification << " " << precision << " row " << i;
    }
  }
  EXPECT_GE(compared, 3u * 3 * 36);
}

TEST(ReflectValues, SpansLongerThanOneCallKeepTheirOrder) {
  const Folder folder;
  std::string text;
  for (int i = 0; i < 600; ++i) {
    const double angle = 0.0026 * i;
    text += std::to_string(std::sin(angle)) + " 0 " + std::to_string(std::cos(angle)) + " 0 0 1\n";
  }
  folder.write("rows", text);
  const auto exact = lines_of(folder.run("reflect phong --values rows").out);
  const auto batch = lines_of(folder.run("reflect phong --values rows --precision batch").out);
  ASSERT_EQ(exact.size(), 600u);
  ASSERT_EQ(batch.size(), 600u);
  for (std::size_t i = 0; i < 600; ++i)
    EXPECT_NEAR(numbers_of(exact[i])[0], numbers_of(batch[i])[0], 2e-5) << i;
}

TEST(ReflectValues, ReadsCommasOrBlanksHeadersAndStandardInput) {
  const Folder folder;
  folder.write("plain", "0,0,1,0,0,1\n");
  const std::string expected = "0.80000000000000004,0.80000000000000004,0.80000000000000004\n";
  const std::string command = "reflect lambert:kd=.8 --values ";
  EXPECT_EQ(folder.run(command + "plain").out, expected);
  for (const char* text :
       {"0 0 1 0 0 1", "  0\t0 ,1 , 0, 0 1\r\n\r\n", "lx,ly,lz,vx,vy,vz\n0,0,1,0,0,1\n",
        "\n vz vy vx name lz ly lx\n1 0 0 \"a, b\" 1 0 0\n", "a b c d e f\n0 0 1 0 0 1"}) {
    folder.write("other", text);
    EXPECT_EQ(folder.run(command + "other").out, expected) << text;
    EXPECT_EQ(folder.run("reflect lambert:kd=.8 --values < other").out, expected) << text;
    EXPECT_EQ(folder.run(command + "- < other").out, expected) << text;
  }
  EXPECT_EQ(folder.run(command + "plain -o out.csv").out, "");
  EXPECT_EQ(folder.read("out.csv"), expected);
}

TEST(ReflectValues, BelowTheHorizonIsZeroInAllPrecisions) {
  const Folder folder;
  folder.write("rows", "0 0 1 0 .6 -.8\n0 0 -1 0 0 1\n0 0 1 1 0 0\n0 0 -1 0 0 -1\n");
  for (const char* precision : {"double", "float", "batch"})
    EXPECT_EQ(
        folder.run(std::string("reflect blinn-phong --values rows --precision ") + precision).out,
        "0,0,0\n0,0,0\n0,0,0\n0,0,0\n")
        << precision;
}

TEST(ReflectValues, BadRowsAreNamedByTheirLine) {
  const Folder folder;
  struct Bad {
    const char *text, *message;
  };
  for (const auto& [text, message] :
       {Bad{"0 0 1 0 0\n", "rows:1: 5 columns, not 6"},
        Bad{"0 0 1 0 0 1\n0 0 1 0 0 1 7\n", "rows:2: 7 columns"},
        Bad{"0,0,1,0,0,\n", "rows:1: vz: '' is not a number"},
        Bad{"0 0 1 0 0 x\n", "rows:1: vz: 'x' is not a number"},
        Bad{"0 0 1 0 0 1e\n", "rows:1: vz: '1e' is not a number"},
        Bad{"\n0 0 1 0 nan 1\n", "rows:2: vy: nan is not a finite number"},
        Bad{"inf 0 1 0 0 1\n", "rows:1: lx: inf"},
        Bad{"0 0 1 0 0 1\n0 0 1 0 .1 1\n", "rows:2: v has length 1.004"},
        Bad{"0 0 1.00002 0 0 1\n", "rows:1: l has length 1.00002"},
        Bad{"0 0 0 0 0 1\n", "rows:1: l has length 0"},
        Bad{"lx ly lz vx vy\n0 0 1 0 0\n", "rows:1: these columns are not lx,ly,lz,vx,vy,vz"},
        Bad{",,,,,\n", "rows:1: these columns are not lx,ly,lz,vx,vy,vz"},
        Bad{"lx ly lz vx vy vz\n0 0 1 0 0 1 0\n", "rows:2: 7 columns"},
        Bad{"lx ly lz vx vy vz\nlx ly lz vx vy vz\n", "rows:2: lx: 'lx' is not a number"}}) {
    folder.write("rows", text);
    expect_refusal(folder.run("reflect lambert --values rows -o out"), message);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"rows"}) << text;
  }
  folder.write("rows", "");
  EXPECT_EQ(folder.run("reflect lambert --values rows").exit_code, 0) << "no rows, no answers";
  expect_refusal(folder.run("reflect lambert --values nowhere.csv"), "nowhere.csv");
  expect_refusal(folder.run("reflect lambert --values ."), ".: is a folder");
}

}  // namespace
}  // namespace scanlit::test
