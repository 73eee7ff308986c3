// scanlit reflect: what it refuses, and its help.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/output_text.h"
#include "tests/cli/refusal.h"

namespace scanlit::test {
namespace {

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
