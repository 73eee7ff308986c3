// Every bad input: one line on stderr that begins with "error: ", exit code 2, no file left behind.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "tests/cli/refusal.h"

namespace scanlit::test {
namespace {

struct BadInput {
  std::string arguments;
  std::string message;  // a part of what is to be said
  std::string file = "", text = "";
};

void PrintTo(const BadInput& bad, std::ostream* out) { *out << bad.arguments; }

class Refusal : public testing::TestWithParam<BadInput> {};

TEST_P(Refusal, IsOneLineAndLeavesNothing) {
  const auto& [arguments, message, file, text] = GetParam();
  const Folder folder;
  if (!file.empty()) folder.write(file, text);
  const auto before = folder.files();
  expect_refusal(folder.run(arguments), message);
  EXPECT_EQ(folder.files(), before);
}

INSTANTIATE_TEST_SUITE_P(
    CommandLine, Refusal,
    testing::Values(
        BadInput{"", "no command"}, BadInput{"rendr teapot", "did you mean 'render'?"},
        BadInput{"render", "INPUT is required"}, BadInput{"render ''", "INPUT"},
        BadInput{"render teapot --szie 3x3", "unknown option '--szie'; did you mean '--size'?"},
        BadInput{"render teapot other", "unexpected argument 'other'"},
        BadInput{"render teepot", "did you mean 'teapot'?"}, BadInput{"render teapot:x", "teapot"},
        BadInput{"render teapot:0", "teapot"},
        BadInput{"render teapot:99999999999999999999", "teapot"},
        BadInput{"render \"$(printf 'te\\npot')\"", "neither a file nor"},
        BadInput{"render teapot --shading gourad", "did you mean 'gouraud'?"},
        BadInput{"render teapot --model blin-phong", "did you mean 'blinn-phong'?"},
        BadInput{"render teapot --model blinn-phong:n=-1", "n"},
        BadInput{"render teapot --model blinn-phong:n=nan", "n"},
        BadInput{"render teapot --size 0x10", "--size: 0 is out of range"},
        BadInput{"render teapot --size 10x99999", "--size: 99999 is out of range"},
        BadInput{"render teapot --size -5x5", "--size: -5 is out of range"},
        BadInput{"render teapot --size 10", "--size: '10' is not a size"},
        BadInput{"render teapot --size 9x9 --size 9x9", "--size"},
        BadInput{"render teapot --size", "--size"},
        BadInput{"render teapot --samples 5", "--samples: 5 samples"},
        BadInput{"render teapot --threads 0", "--threads: 0 is out of range"},
        BadInput{"render teapot --exposure inf", "--exposure: inf is not a finite number"},
        BadInput{"render teapot --exposure x", "--exposure: 'x' is not a number"},
        BadInput{"render teapot --eye 1,2", "--eye: '1,2' is not a vector"},
        BadInput{"render teapot --eye 0,0,5 --target 0,0,5", "eye and target"},
        BadInput{"render teapot --up 0,0,0", "up"},
        BadInput{"render teapot --fov 180", "--fov: 180 is out of range"},
        BadInput{"render teapot --light 0,0,0", "--light: the direction is the zero vector"},
        BadInput{"render teapot --ka 2", "--ka: 2 is out of range"}));

INSTANTIATE_TEST_SUITE_P(
    Output, Refusal,
    testing::Values(BadInput{"render teapot -o nowhere/x.png", "nowhere"},
                    BadInput{"render teapot -o /proc/x.png", "/proc/x.png"},
                    BadInput{"render teapot -o .", "."},
                    BadInput{"render teapot -o x.docx", "unknown image format '.docx'"},
                    BadInput{"render teapot --aov x.png", "--aov: 'x.png' is not an .exr file"},
                    BadInput{"render teapot -o x.exr --aov x.exr", "the picture's own file"},
                    BadInput{"render teapot -o x.exr --aov \"$PWD\"/x.exr",
                             "the picture's own file"},
                    BadInput{"render teapot --aov nowhere/x.exr", "nowhere"},
                    BadInput{"render teapot --aov costs", "--aov: 'costs' is not an .exr file"},
                    BadInput{"render teapot --aov cost --size 9000x90", "18"},
                    BadInput{"render teapot --aov cost -o nowhere/x.exr", "nowhere"},
                    BadInput{"render teapot --skip-off hidden",
                             "--skip-off: no switch 'hidden'; there are: outside-objects, "}));

INSTANTIATE_TEST_SUITE_P(
    Files, Refusal,
    testing::Values(
        BadInput{"render none.obj", "none.obj"}, BadInput{"render none.toml", "none.toml"},
        BadInput{"render empty.obj", "empty.obj", "empty.obj", ""},
        BadInput{"render a.xyz", "a.xyz", "a.xyz", "0 0 0"},
        BadInput{"render a.obj", "a.obj", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"},
        BadInput{"render a.obj", "a.obj", "a.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        BadInput{"render a.obj", "the scene reaches", "a.obj",
                 "v 0 0 0\nv 1e38 0 0\nv 0 1 0\nf 1 2 3\n"},
        BadInput{"render a.off", "a.off", "a.off", "OFF\n1000000000 1000000000 0\n0 0 0\n"},
        BadInput{"render empty.toml", "empty.toml:1:1: no [[object]]", "empty.toml", ""},
        BadInput{"render s.toml", "s.toml:2:8: none.obj: there is no such file", "s.toml",
                 "[[object]]\nmesh = 'none.obj'\n"},
        BadInput{"render s.toml", "s.toml:2:8: 'teepot' is neither", "s.toml",
                 "[[object]]\nmesh = 'teepot'\n"},
        BadInput{"render s.toml", "s.toml:1:8: ", "s.toml", "[camera"},
        BadInput{"render s.toml", "s.toml", "s.toml", std::string("\xff\xfe\0\1", 4)},
        BadInput{"render s.toml", "s.toml", "s.toml", "x = " + std::string(100000, '[')}));

TEST(BadInput, AKeyTooDeepForTheStack) {
  const Folder folder;
  std::string key = "a";
  for (int i = 0; i < 200'000; ++i) key += ".a";
  for (const std::string& text : {"\n" + key + " = 1\n", "\n[" + key + "]"}) {
    folder.write("s.toml", text);
    expect_refusal(folder.run("render s.toml"), "s.toml:2: more than 20000 dots in one line");
  }
}

TEST(BadInput, AWordAsLongAsAFileIsNotRepeatedWhole) {
  const Folder folder;
  folder.write("s.toml", "[[object]]\nmesh = '" + std::string(1'000'000, 'x') + "'");
  const Outcome outcome = folder.run("render s.toml");
  expect_refusal(outcome, "xxx ... xxx");
  EXPECT_LT(outcome.err.size(), 1000u);
}

TEST(BadInput, AFolderOrPipeIsNoScene) {
  const Folder folder;
  std::filesystem::create_directory(folder.path() / "folder.toml");
  expect_refusal(folder.run("render folder.toml"), "folder.toml: is not a regular file");
  expect_refusal(folder.run("render pipe.toml", "mkfifo pipe.toml;"),
                 "pipe.toml: is not a regular file");
}

TEST(BadInput, WhatTheSystemRefusesIsOneLine) {
  const Folder folder;
  expect_refusal(folder.run("render loop.obj", "ln -s loop.obj loop.obj;"), "symbolic links");
  expect_refusal(folder.run("render cube", "ulimit -f 1;"),
                 "cube.png: cannot write: File too large");
  EXPECT_EQ(folder.files(), std::vector<std::string>{"loop.obj"});
  expect_refusal(folder.run("render mem.toml", "ln -s /proc/self/mem mem.toml;"), "mem.toml:");
}

TEST(BadInput, APipeIsNoPlaceForAPicture) {
  const Folder folder;
  expect_refusal(folder.run("render cube -o pipe.png", "mkfifo pipe.png;"), "not a regular file");
  EXPECT_TRUE(std::filesystem::is_fifo(folder.path() / "pipe.png"));
}

TEST(BadInput, ALinkToTheInputIsNoPlaceForAPicture) {
  const Folder folder;
  folder.write("a.toml", "[[object]]\nmesh = 'cube'\n");
  expect_refusal(folder.run("render a.toml", "ln -s a.toml a.png;"), "the input's own file");
  EXPECT_TRUE(folder.read("a.toml").starts_with("[[object]]"));
}

TEST(BadInput, AFullStandardOutputIsNoticed) {
  const Folder folder;
  const Outcome outcome = folder.run("models >/dev/full");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "error: cannot write to standard output\n");
}

#if !defined(__SANITIZE_ADDRESS__)  // whose shadow memory does not fit any limit
TEST(BadInput, TooLittleMemoryIsOneLine) {
  const Folder folder;
  expect_refusal(folder.run("render cube --size 16384x16384 --threads 1", "ulimit -v 2000000;"),
                 "not enough memory");
  EXPECT_TRUE(folder.files().empty());
}
#endif

}  // namespace
}  // namespace scanlit::test
