// The program as a person uses it: pictures appear where it says, options do what they say.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/cli/output_text.h"
#include "tests/cli/run_program.h"

namespace scanlit::test {
namespace {

void expect_narrow(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

TEST(Cli, EveryLevelOfHelpHasAnExampleAndFitsTheTerminal) {
  const Folder folder;
  for (const char* level : {"--help", "render --help", "frames --help", "explain --help",
                            "watch --help", "models --help", "shapes --help"}) {
    const Outcome help = folder.run(level);
    EXPECT_EQ(help.exit_code, 0) << level;
    EXPECT_TRUE(contains(help.out, "\n  scanlit ")) << level;
    expect_narrow(help.out);
  }
}

TEST(Cli, ListsModelsAndShapes) {
  const Folder folder;
  const Outcome models = folder.run("models"), shapes = folder.run("shapes");
  for (const char* model : {"lambert:", "phong:", "blinn-phong:", "0 to 1"})
    EXPECT_TRUE(contains(models.out, model)) << model;
  for (const char* shape :
       {"plane", "cube", "sphere", "icosphere", "cylinder", "cone", "torus", "trefoil", "teapot"})
    EXPECT_TRUE(contains(shapes.out, std::string("  ") + shape + "  ")) << shape;
  expect_narrow(models.out);
  expect_narrow(shapes.out);
}

TEST(Cli, VersionIsANumberAndNamesTheVectors) {
  const std::string version = Folder().run("--version").out;
  EXPECT_TRUE(version.starts_with("scanlit 0.")) << version;
#if defined(__AVX512F__)
  EXPECT_TRUE(contains(version, "\nvectors: AVX-512, 16 lanes\n")) << version;
#elif defined(__AVX2__)
  EXPECT_TRUE(contains(version, "\nvectors: AVX2, 8 lanes\n")) << version;
#else
  EXPECT_TRUE(contains(version, "\nvectors: SSE4, 4 lanes\n")) << version;
#endif
}

TEST(Cli, OpenImageIOIsLoadedOnlyForImages) {
  const Folder folder;
  const auto loads = [&](const char* arguments) {
    return contains(folder.run(arguments, "LD_DEBUG=files").err, "OpenImageIO");
  };
  EXPECT_FALSE(loads("--help"));
  EXPECT_FALSE(loads("reflect blinn-phong --terms"));
  EXPECT_TRUE(loads("render torus:8 --size 40x30"));
}

TEST(Cli, ThePictureIsNamedAfterTheInputAndSaidToBeThere) {
  const Folder folder;
  const Outcome outcome = folder.run("render torus:8 --size 40x30");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.out.starts_with("torus.png: 40 x 30 pixels")) << outcome.out;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(folder.files(), std::vector<std::string>{"torus.png"});
  EXPECT_TRUE(contains(folder.read("torus.png").substr(0, 8), "PNG"));
}

TEST(Cli, TheSuffixDecidesTheFormat) {
  const Folder folder;
  EXPECT_EQ(folder.run("render torus:8 --size 40x30 -o x.exr --aov parts.exr").exit_code, 0);
  EXPECT_EQ(folder.read("x.exr").substr(0, 4), "v/1\1");
  EXPECT_TRUE(contains(folder.read("parts.exr"), "glossy.R"));
  EXPECT_FALSE(contains(folder.read("x.exr"), "glossy.R"));
}

TEST(Cli, ThePictureDoesNotDependOnThreads) {
  const Folder folder;
  folder.run("render teapot:8 --size 200x150 --threads 1 -o 1.png");
  ASSERT_FALSE(folder.read("1.png").empty());
  for (const char* threads : {"2", "3", "8"}) {
    folder.run(std::string("render teapot:8 --size 200x150 -o n.png --threads ") + threads);
    EXPECT_EQ(folder.read("1.png"), folder.read("n.png")) << threads << " threads";
  }
}

TEST(Cli, EachOptionChangesThePicture) {
  const Folder folder;
  const std::string command = "render teapot:4 --size 120x90 -o ";
  folder.run(command + "plain.png");
  const std::string plain = folder.read("plain.png");
  ASSERT_FALSE(plain.empty());
  for (const char* option : {"--shading flat",
                             "--shading gouraud",
                             "--model lambert",
                             "--ka .9",
                             "--object-colour 1,0,0",
                             "--light 1,0,0",
                             "--ambient 3",
                             "--background .5",
                             "--azimuth 80",
                             "--elevation 60",
                             "--eye 3,3,3",
                             "--target 0,1,0",
                             "--up 1,0,0",
                             "--fov 60",
                             "--ortho",
                             "--ortho --height 9",
                             "--viewer-at-infinity",
                             "--samples 1",
                             "--exposure 1",
                             "--encoding linear"}) {
    const Outcome outcome = folder.run(command + "changed.png " + option);
    EXPECT_EQ(outcome.exit_code, 0) << option << ": " << outcome.err;
    EXPECT_NE(folder.read("changed.png"), plain) << option << " changes nothing";
  }
}

TEST(Cli, OptionsThatNeedTheRightPictureChangeIt) {
  const Folder folder;
  // A bent, open strip of unequal faces.
  folder.write("strip.obj",
               "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 2 1 0\nv 0 1 -1\nv 2 1 -1\nf 1 2 4\nf 1 4 3\n"
               "f 3 4 6 5\n");
  struct Pair {
    const char *command, *option;
  };
  for (const auto& [command, option] :
       {Pair{"strip.obj", "--crease 30"}, Pair{"strip.obj", "--normals area"},
        Pair{"strip.obj --azimuth 200", "--sides front"},
        Pair{"strip.obj --shading gouraud --light 0,0,1", "--interpolation screen-linear"},
        Pair{"sphere:4 --shading gouraud --ambient 9 --exposure -3", "--clamp-vertex-colours"}}) {
    const std::string render = std::string("render --size 90x70 ") + command;
    EXPECT_EQ(folder.run(render + " -o plain.png").err, "");
    EXPECT_EQ(folder.run(render + " -o changed.png " + option).exit_code, 0) << option;
    EXPECT_NE(folder.read("changed.png"), folder.read("plain.png")) << option;
  }
}

TEST(Cli, OptionsOverrideTheScene) {
  const Folder folder;
  folder.write("s.toml", "[picture]\nwidth = 50\nheight = 40\n[[object]]\nmesh = 'cube'\n");
  EXPECT_TRUE(contains(folder.run("render s.toml").out, "s.png: 50 x 40 pixels"));
  EXPECT_TRUE(contains(folder.run("render s.toml --size 9x7").out, "s.png: 9 x 7 pixels"));
}

TEST(Cli, AMeshFileIsFoundFromTheFolderOfItsScene) {
  const Folder folder;
  std::filesystem::create_directory(folder.path() / "in");
  folder.write("in/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("in/s.toml", "[[object]]\nmesh = 'a.obj'\n");
  const Outcome outcome = folder.run("render in/s.toml --size 20x20");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "1 triangle,")) << outcome.out;
}

TEST(Cli, ClippedPixelsAreReportedWithAnExposureThatMendsThem) {
  const Folder folder;
  const Outcome bright = folder.run("render sphere --size 60x60 --exposure 4");
  EXPECT_EQ(bright.exit_code, 0);
  const std::string advice = "--exposure ";
  const std::size_t at = bright.err.find(advice);
  ASSERT_NE(at, std::string::npos) << bright.err;
  const std::string exposure = bright.err.substr(at, bright.err.find(' ', at + advice.size()) - at);
  EXPECT_EQ(folder.run("render sphere --size 60x60 " + exposure).err, "");
}

TEST(Cli, AnEmptyViewIsSaidToBeOne) {
  const Folder folder;
  const Outcome outcome = folder.run("render cube --size 20x20 --eye 0,0,9 --target 0,0,99");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "warning: nothing of the scene is in view\n");
}

TEST(Cli, AMeshWithoutTexcoordsIsNamedWhereTangentsFollowThem) {
  const Folder folder;
  folder.write("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Outcome outcome = folder.run("render plain.obj --size 20x20 --tangents texcoord");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err,
            "warning: plain.obj: has no texture coordinates for tangents to follow; they go around "
            "y\n");
  EXPECT_EQ(folder.run("render sphere:4 --size 20x20 --tangents texcoord").err, "");
  EXPECT_EQ(folder.run("render plain.obj --size 20x20 --tangents 'along x'").err, "");
  const Outcome wrong = folder.run("render sphere:4 --tangents across");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(contains(wrong.err, "--tangents: unknown tangents 'across'; there are: around x"));
}

TEST(Cli, StatsShowStagesAndCounts) {
  const Folder folder;
  const Outcome outcome = folder.run("render cube:1 --size 40x30 --stats --threads 2");
  for (const char* part :
       {"scan conversion", "shading", "objects", "clusters", "outside the view", "facing away",
        "without a pixel", "drawn", "clipped", "hidden", "tiles kept", "covered", "fragments",
        "in the dark", "done", "mean span", "2 threads"})
    EXPECT_TRUE(contains(outcome.out, part)) << part << " in\n" << outcome.out;
  expect_narrow(outcome.out);
}

/// The figure of a row of --stats.
std::string figure(const std::string& stats, const std::string& row) {
  std::istringstream lines(stats);
  for (std::string line, value; std::getline(lines, line);)
    if (line.starts_with("  " + row + "  ")) {
      std::istringstream(line.substr(row.size() + 2)) >> value;
      return value;
    }
  return "none";
}

TEST(Cli, ASkipThatIsOffShowsInTheStatsAndNotInThePicture) {
  const Folder folder;
  const std::string render = "render sphere:8 --size 40x30 --stats -o ";
  const Outcome on = folder.run(render + "on.png");
  const Outcome off =
      folder.run(render + "off.png --skip-off unseen-triangles --skip-off dark-lights");
  EXPECT_EQ(off.exit_code, 0) << off.err;
  EXPECT_EQ(folder.read("on.png"), folder.read("off.png"));
  EXPECT_NE(figure(on.out, "in the dark"), "0") << on.out;
  EXPECT_EQ(figure(off.out, "in the dark"), "0") << off.out;
  EXPECT_EQ(figure(on.out, "covered"), figure(off.out, "covered"));
  EXPECT_FALSE(contains(on.out, "switched off"));
  EXPECT_TRUE(contains(off.out, "switched off: unseen-triangles\n"));
}

TEST(Cli, CostIsAPictureBesideThePicture) {
  const Folder folder;
  const Outcome outcome = folder.run("render torus:8 --size 60x40 -o a.exr --aov cost");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "\na-cost.png: what was done for each pixel\n"));
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"a-cost.png", "a.exr"}));
  EXPECT_EQ(folder.run("render torus:8 --size 60x40 --aov b.exr --aov cost").exit_code, 0);
  EXPECT_TRUE(contains(folder.read("b.exr"), "cost.evaluations"));
  EXPECT_EQ(folder.read("torus-cost.png"), folder.read("a-cost.png"));
}

TEST(Cli, ListsOneModel) {
  const Folder folder;
  for (const char* name : {"ward", "fresnel", "image", "copper"}) {
    const Outcome outcome = folder.run(std::string("models ") + name);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find(std::string("\n") + name + ": "), 0u) << outcome.out;
  }
  const Outcome outcome = folder.run("models wart");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "error: unknown model 'wart'; did you mean 'ward'?\n");
}

TEST(Cli, TheExampleScenesRender) {
  const Folder folder;
  const std::filesystem::path scenes = SCANLIT_SOURCE_DIR "/lessons/scenes";
  for (const auto& scene : std::filesystem::directory_iterator(scenes)) {
    if (scene.path().extension() != ".toml") continue;
    const Outcome outcome = folder.run("render '" + scene.path().string() + "' --size 80x60");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "") << scene;
  }
}

}  // namespace
}  // namespace scanlit::test
