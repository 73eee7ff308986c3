// scanlit reflect --plot polar, cartesian, albedo: curves in SVG files.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/cli/output_text.h"
#include "tests/cli/run_program.h"

namespace scanlit::test {
namespace {

/// Whether elements are closed in order and attributes quoted, and nothing is unescaped.
bool is_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  std::size_t at = xml.find("?>") + 2;
  if (!xml.starts_with("<?xml")) return false;
  while (at < xml.size()) {
    if (xml[at] == '&') {
      const std::size_t end = xml.find(';', at);
      if (end == xml.npos || end > at + 6) return false;
    }
    if (xml[at] == '>') return false;
    if (xml[at++] != '<') continue;
    const bool closes = xml[at] == '/';
    const std::string name =
        xml.substr(at + closes, xml.find_first_of(" />\n", at + closes) - at - closes);
    bool quoted = false;
    for (; at < xml.size() && (quoted || xml[at] != '>'); ++at) {
      if (xml[at] == '"') quoted = !quoted;
      if (xml[at] == '<') return false;
    }
    if (closes && (open.empty() || open.back() != name)) return false;
    if (closes) open.pop_back();
    if (!closes && xml[at - 1] != '/') open.push_back(name);
    ++at;
  }
  return open.empty();
}

TEST(ReflectPlot, IsXmlWithACurveForEachModelAndAngle) {
  const Folder folder;
  struct Plot {
    const char* arguments;
    std::size_t curves;
  };
  for (const auto& [arguments, curves] :
       {Plot{"phong --plot polar", 2}, Plot{"phong --plot polar --angles 10,20,89.9,0", 4},
        Plot{"lambert phong:n=9 blinn-phong --plot polar --angles 45", 3},
        Plot{"lambert phong:n=9 blinn-phong --plot polar", 6},
        Plot{"phong:kd=1/.5/.1 --plot polar --angles 45", 3},
        Plot{"phong:kd=1/.5/.1 --plot polar --angles 45,60", 2},
        Plot{"phong --plot polar --quantity brdf --azimuth 30 --angles 70", 1},
        Plot{"phong --plot cartesian", 2}, Plot{"phong --plot cartesian --log", 4},
        Plot{"phong:kd=1/.5/.1,n=100000 --plot cartesian --log --angles 45", 6},
        Plot{"lambert:kd=0 --plot cartesian --log --angles 45", 2},
        Plot{"lambert phong:n=9 blinn-phong --plot albedo", 3},
        Plot{"lambert:kd=1/.5/.1 --plot albedo", 3},
        Plot{"distribution:D=ggx distribution --plot cartesian --log", 8}}) {
    const Outcome outcome = folder.run(std::string("reflect ") + arguments + " -o plot.svg");
    ASSERT_EQ(outcome.exit_code, 0) << arguments << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("plot.svg: ")) << outcome.out;
    const std::string svg = folder.read("plot.svg");
    EXPECT_TRUE(is_well_formed(svg)) << arguments;
    EXPECT_EQ(count_of(svg, "class=\"curve\""), curves) << arguments;
    EXPECT_FALSE(contains(svg, ",nan")) << arguments;
    EXPECT_FALSE(contains(svg, ",inf")) << arguments;
  }
}

TEST(ReflectPlot, NamesTheModelsAndTheQuantity) {
  const Folder folder;
  folder.run("reflect phong:n=9 blinn-phong:n=36 --plot polar -o plot.svg");
  const std::string svg = folder.read("plot.svg");
  for (const char* part : {"phong:n=9", "blinn-phong:n=36", "= 30°", "= 60°", "I = π f"})
    EXPECT_TRUE(contains(svg, part)) << part;
  folder.run("reflect phong:n=9 --plot polar --quantity brdf -o plot.svg");
  EXPECT_TRUE(contains(folder.read("plot.svg"), "[1/sr]"));
}

TEST(ReflectPlot, ALobeReachesItsPeakHoweverSharp) {
  const Folder folder;
  folder.run("reflect phong:kd=0,ks=1,n=100000 --plot cartesian --angles 47.3 -o plot.svg");
  const std::string svg = folder.read("plot.svg");
  const std::size_t at = svg.find("class=\"curve\"");
  const std::string path = svg.substr(at, svg.find("/>", at) - at);
  double top = 1e9, bottom = 0;  // y goes down
  for (std::size_t comma = path.find(','); comma != path.npos; comma = path.find(',', comma + 1)) {
    const double y = std::stod(path.substr(comma + 1));
    top = std::min(top, y), bottom = std::max(bottom, y);
  }
  EXPECT_NEAR(bottom - top, 400, 1) << "the axis goes from 0 to 1 over 400 pixels";
}

}  // namespace
}  // namespace scanlit::test
