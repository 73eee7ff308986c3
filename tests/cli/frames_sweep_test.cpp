// scanlit frames: FROM:TO in options, and --sweep of what a scene file says.
#include <gtest/gtest.h>

#include "rasterizer/image.h"
#include "tests/cli/output_text.h"
#include "tests/cli/refusal.h"

namespace scanlit::test {
namespace {

TEST(FramesSweep, OptionsGoFromOneNumberToTheOther) {
  const Folder folder;
  struct Case {
    const char *swept, *from, *middle, *to;
  };
  for (const auto& [swept, from, middle, to] :
       {Case{"--exposure -1:1", "--exposure -1", "--exposure 0", "--exposure 1"},
        Case{"--light 0,1,1:1,1,0", "--light 0,1,1", "--light .5,1,.5", "--light 1,1,0"},
        Case{"--background .5,0,0:0,0,1", "--background .5,0,0", "--background .25,0,.5",
             "--background 0,0,1"},
        Case{"--model blinn-phong:kd=1/0/0:0/0/1,n=10:30,ks=.2",
             "--model blinn-phong:kd=1/0/0,n=10,ks=.2", "--model blinn-phong:kd=.5/0/.5,n=20,ks=.2",
             "--model blinn-phong:kd=0/0/1,n=30,ks=.2"},
        Case{"--model 'clear-coat:base=(lambert:kd=.2:.6)'",
             "--model 'clear-coat:base=(lambert:kd=.2)'",
             "--model 'clear-coat:base=(lambert:kd=.4)'",
             "--model 'clear-coat:base=(lambert:kd=.6)'"}}) {
    const std::string sphere = " sphere:6 --size 40x30 ";
    const Outcome outcome = folder.run("frames" + sphere + swept + " --count 3 --force -o d");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const auto& [number, fixed] : {std::pair{"0", from}, {"1", middle}, {"2", to}}) {
      folder.run("render" + sphere + fixed + " -o one.png");
      EXPECT_EQ(folder.read(std::string("d/frame_000") + number + ".png"), folder.read("one.png"))
          << swept << ", frame " << number;
    }
  }
}

TEST(FramesSweep, ASceneIsChangedByItsOwnPaths) {
  const Folder folder;
  const std::string scene =
      "[picture]\nwidth = 40\nheight = 30\n"
      "[[light]]\ndirection = [1, 1, 1]\n[[light]]\nkind = 'point'\nposition = [0, 3, 3]\n"
      "[material.text]\nmodel = 'blinn-phong:kd=.6,n=20,ks=.3'\n"
      "[material.coat]\nmodel = 'clear-coat:base=(lambert:kd=.5)'\n"
      "[material.sum]\nmodel = 'sum:(lambert:kd=.1),(phong:kd=0,ks=.4,n=5)'\n"
      "[material.table]\nmodel = { name = 'phong', n = 20, ks = 0.3 }\n"
      "[[object]]\nmesh = 'sphere:6'\nmaterial = 'MATERIAL'\n"
      "rotate = [0, 0, 0]\n";
  struct Case {
    std::string material, sweep, from, to;  // replaced text; what it is in the last frame
  };
  for (const auto& [material, sweep, from, to] :
       {Case{"text", "light.0.intensity=1:.25", "direction", "intensity = 0.25\ndirection"},
        Case{"text", "light.1.position=0,3,3:1,2,3", "[0, 3, 3]", "[1, 2, 3]"},
        Case{"text", "light.1.position.0=0:1", "[0, 3, 3]", "[1, 3, 3]"},
        Case{"text", "background.colour=.03,.034,.042:.1,.2,.3", "[[light]]\ndirection",
             "[background]\ncolour = [0.1, 0.2, 0.3]\n[[light]]\ndirection"},
        Case{"text", "picture.exposure=0:-2", "height = 30", "height = 30\nexposure = -2"},
        Case{"text", "camera.fov=30:60", "[[light]]\ndirection",
             "[camera]\nfov = 60\n[[light]]\ndirection"},
        Case{"text", "material.text.model.n=20:80", "n=20", "n=80"},
        Case{"text", "material.text.model.kd=.6,.6,.6:.1,.2,.3", "kd=.6", "kd=.1/.2/.3"},
        Case{"coat", "material.coat.model.base.kd=.5:.1", "kd=.5", "kd=.1"},
        Case{"sum", "material.sum.model.1.n=5:50", "n=5)", "n=50)"},
        Case{"table", "material.table.model.n=20:80", "n = 20", "n = 80"}}) {
    std::string start = scene;
    start.replace(start.find("MATERIAL"), 8, material);
    std::string end = start;
    end.replace(end.find(from), from.size(), to);
    folder.write("start.toml", start);
    folder.write("end.toml", end);
    const Outcome outcome = folder.run("frames start.toml --count 3 --force -o d --sweep " + sweep);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(folder.run("render start.toml -o start.png").exit_code, 0) << sweep;
    EXPECT_EQ(folder.run("render end.toml -o end.png").exit_code, 0) << sweep;
    EXPECT_EQ(folder.read("d/frame_0000.png"), folder.read("start.png")) << sweep;
    EXPECT_EQ(folder.read("d/frame_0002.png"), folder.read("end.png")) << sweep;
    EXPECT_NE(folder.read("start.png"), folder.read("end.png")) << sweep;
  }
}

TEST(FramesSweep, SweepsGoTogetherAndWithAnOrbit) {
  const Folder folder;
  folder.write("s.toml", "[picture]\nwidth = 40\nheight = 30\n[[object]]\nmesh = 'cube'\n");
  const std::string frames = "frames s.toml --count 3 --sweep ambient.intensity=1:0 ";
  folder.run(frames + "-o one");
  folder.run(frames + "--sweep picture.exposure=0:1 -o two");
  folder.run(frames + "--sweep picture.exposure=0:1 --orbit object --axis 1,1,0 -o three");
  EXPECT_EQ(folder.read("one/frame_0000.png"), folder.read("two/frame_0000.png"));
  EXPECT_NE(folder.read("one/frame_0001.png"), folder.read("two/frame_0001.png"));
  EXPECT_NE(folder.read("two/frame_0001.png"), folder.read("three/frame_0001.png"));
}

TEST(FramesSweep, AnObjectThatMovesIsSeenToMoveAndStaysInThePicture) {
  const Folder folder;
  folder.write("s.toml",
               "[picture]\nwidth = 60\nheight = 40\n[camera]\nelevation = 0\nazimuth = 0\n"
               "[[object]]\nmesh = 'sphere:6'\n");
  folder.run("frames s.toml --count 3 --format exr --sweep object.0.translate=-5,0,0:5,0,0 -o d");
  const auto middle_of = [&](const char* name) {
    const Framebuffer picture = read_image(folder.path() / name);
    double x_sum = 0, covered = 0;
    for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
      x_sum += picture.colour[4 * i + 3] * double(i % 60);
      covered += picture.colour[4 * i + 3];
    }
    return x_sum / covered;
  };
  EXPECT_NEAR(middle_of("d/frame_0000.exr"), 60 - 1 - middle_of("d/frame_0002.exr"), 0.5);
  EXPECT_NEAR(middle_of("d/frame_0001.exr"), 29.5, 0.5);
  EXPECT_GT(middle_of("d/frame_0000.exr"), 3);
  EXPECT_LT(middle_of("d/frame_0000.exr"), 12);
}

TEST(FramesSweep, WhatIsNotThereIsNamedWithWhatIs) {
  const Folder folder;
  folder.write("s.toml",
               "[[light]]\nintensity = 1\n[material.copper]\nmodel = 'phong'\n"
               "[[object]]\nmesh = 'cube'\nmaterial = 'copper'\n");
  struct Bad {
    std::string sweep, message;
  };
  for (const auto& [sweep, message] :
       {Bad{"light.0.intensty=0:1", "unknown key 'intensty' in [[light]]; did you mean 'intens"},
        Bad{"light.1.intensity=0:1", "light has no '1'; there are 0 to 0"},
        Bad{"light.x.intensity=0:1", "light has no 'x'"},
        Bad{"lights.0.intensity=0:1", "the scene has no 'lights'; did you mean 'light'?"},
        Bad{"material.coper.model.n=1:2", "material has no 'coper'; did you mean 'copper'?"},
        Bad{"material.copper.model.q=1:2", "unknown parameter 'q'"},
        Bad{"material.copper.model.n=1:-7", "not -7"},
        Bad{"material.copper.model.base.n=1:2", "'phong' says no 'base'"},
        Bad{"material.copper=1:2", "copper must be a table"},
        Bad{"light.0.intensity=0:-1", "-1 is out of range; allowed is 0 to"},
        Bad{"light.0.intensity.x=0:1", "intensity has nothing below it"},
        Bad{"light.0.direction=1,0,0:-1,0,0", "direction is the zero vector"},
        Bad{"light.0.direction=1,0:0,1", "a list of 3 numbers"},
        Bad{"picture.width=1:9", "whole number"},
        Bad{"camera.fov=10:20:30", "no PATH=FROM:TO"},
        Bad{"camera.fov=10", "no PATH=FROM:TO"},
        Bad{"camera.fov=nan:20", "not a finite number"},
        Bad{"=1:2", "no PATH=FROM:TO"},
        Bad{"camera.target=1,2,3:1,2", "goes from 3 to 2 numbers"},
        Bad{".=1:2", "the scene has no ''"}}) {
    const Outcome outcome = folder.run("frames s.toml --count 3 -o d --sweep '" + sweep + "'");
    expect_refusal(outcome, message);
    EXPECT_TRUE(outcome.err.starts_with("error: --sweep: ")) << outcome.err;
    EXPECT_EQ(folder.files(), std::vector<std::string>{"s.toml"}) << sweep;
  }
  expect_refusal(folder.run("frames cube -o d --sweep camera.fov=1:2"), "names a place in a scene");
  expect_refusal(folder.run("frames cube -o d --model phong:n=5:-1"), "not -1");
  expect_refusal(folder.run("frames cube -o d --exposure 0:x"), "'0:x' is not a number");
  expect_refusal(folder.run("frames cube -o d --light 0,0,1:1"), "goes from 3 to 1 numbers");
}

}  // namespace
}  // namespace scanlit::test
