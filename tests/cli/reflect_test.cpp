// scanlit reflect: values, plots, pictures and reports of reflection models.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "rasterizer/image.h"
#include "tests/cli/refusal.h"

namespace scanlit::test {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  std::istringstream stream(line);
  for (std::string number; std::getline(stream, number, ',');)
    numbers.push_back(std::strtod(number.c_str(), nullptr));
  return numbers;
}

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

TEST(ReflectPicture, SpheresAndSlicesHoldTheModelsValues) {
  const Folder folder;
  const std::string tail = " --cell 100 -o picture.exr";
  EXPECT_EQ(folder.run("reflect lambert:kd=.8/.5/.2 --plot sphere --angles 0,60" + tail).err, "");
  const Framebuffer spheres = read_image(folder.path() / "picture.exr");
  const auto red = [](const Framebuffer& f, int x, int y) {
    return f.colour[4 * (std::size_t(y) * std::size_t(f.width) + std::size_t(x))];
  };
  float brightest[2] = {};
  for (int y = 30; y < spheres.height - 40; ++y)
    for (int x = 0; x < spheres.width; ++x)
      brightest[x > spheres.width / 2] =
          std::max(brightest[x > spheres.width / 2], red(spheres, x, y));
  EXPECT_NEAR(brightest[0], 0.8, 1e-3);
  EXPECT_NEAR(brightest[1], 0.8, 1e-3);

  EXPECT_EQ(folder.run("reflect lambert:kd=.8/.5/.2 --plot slice" + tail).err, "");
  const Framebuffer slice = read_image(folder.path() / "picture.exr");
  EXPECT_NEAR(red(slice, slice.width / 2, slice.height / 2), 0.8, 1e-3);
}

TEST(ReflectPicture, WithoutAFontThereAreNoLabelsAndAWarning) {
  const Folder folder;
  const Outcome outcome = folder.run("reflect lambert --plot slice --cell 60 -o picture.png",
                                     "SCANLIT_FONT=/nowhere.ttf");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.err.starts_with("warning: no font was found")) << outcome.err;
  EXPECT_EQ(folder.files(), std::vector<std::string>{"picture.png"});
}

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

TEST(Reflect, RefusesWhatItCannotDo) {
  const Folder folder;
  struct Bad {
    const char *arguments, *message;
  };
  for (const auto& [arguments, message] :
       {Bad{"", "MODEL is required"},
        Bad{"lambert", "one of --values, --plot"},
        Bad{"lambert --furnace --reciprocity",
            "--reciprocity: does not go together with --furnace"},
        Bad{"lambrt --furnace", "did you mean 'lambert'?"},
        Bad{"lambert:kd=2 --furnace", "kd"},
        Bad{"lambert phong --furnace", "--furnace: wants one model, not 2"},
        Bad{"lambert --furnace --log", "--log: has no meaning to --furnace"},
        Bad{"lambert --furnace --precision float", "--precision: has no meaning to --furnace"},
        Bad{"lambert --plot polar --cell 64 -o a.svg",
            "--cell: has no meaning to the plot 'polar'"},
        Bad{"lambert --plot slice --angles 3 -o a.png",
            "--angles: has no meaning to the plot 'slice'"},
        Bad{"lambert --values /dev/null", "/dev/null: is a device"},
        Bad{"lambert --furnace --angles 0,,3", "--angles: '' is not a number"},
        Bad{"lambert --furnace --angles 0,90", "--angles: 90 is out of range"},
        Bad{"lambert --furnace --angles nan", "--angles: nan"},
        Bad{"lambert --furnace --azimuth x", "--azimuth: 'x'"},
        Bad{"lambert --furnace -o no/where", "no/where: there is no folder"},
        Bad{"lambert --values --precision half", "--precision: unknown precision 'half'"},
        Bad{"lambert --terms", "--terms: 'lambert' is not made of D, G and F"},
        Bad{"distribution --furnace", "--furnace: 'distribution' is a part of models"},
        Bad{"lambert --plot polr -o x.svg", "did you mean 'polar'?"},
        Bad{"lambert --plot polar", "--plot: wants the name of a file"},
        Bad{"lambert --plot polar -o x.png", "x.png: a polar plot is an .svg file"},
        Bad{"lambert --plot polar -o no/x.svg", "no/x.svg: there is no folder"},
        Bad{"lambert --plot sphere -o x.svg", "x.svg: unknown image format"},
        Bad{"lambert --plot sphere --cell 9 -o x.png", "--cell: 9 is out of range"},
        Bad{"lambert --plot slice --cell 4096 --exposure 99 -o x.png", "exposure"},
        Bad{"lambert --plot polar --quantity x -o x.svg", "--quantity: unknown quantity 'x'"},
        Bad{"lambert --tabulate merl", "--tabulate: wants the name of a file"},
        Bad{"lambert --tabulate mrl -o x", "did you mean 'merl'?"}}) {
    expect_refusal(folder.run(std::string("reflect ") + arguments), message);
    EXPECT_EQ(folder.files(), std::vector<std::string>{}) << arguments;
  }
}

TEST(Reflect, HelpHasExamplesAndFitsTheTerminal) {
  const std::string help = Folder().run("reflect --help").out;
  EXPECT_TRUE(contains(help, "\n  scanlit reflect "));
  for (const std::string& line : lines_of(help)) EXPECT_LE(line.size(), 100u) << line;
}

}  // namespace
}  // namespace scanlit::test
