// scanlit frames: a sequence, its folder, and the animation made of it.
#include <gtest/gtest.h>

#include <cmath>

#include "lessons/studio/progress_bar.h"
#include "rasterizer/image.h"
#include "tests/cli/output_text.h"
#include "tests/cli/refusal.h"

namespace scanlit::test {
namespace {

const std::string small_teapot = "frames teapot:3 --size 60x45 ";

double mean_difference(const Framebuffer& a, const Framebuffer& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.colour.size(); ++i) sum += std::abs(a.colour[i] - b.colour[i]);
  return sum / double(a.colour.size());
}

Framebuffer frame(const Folder& folder, const std::string& name) {
  return read_image(folder.path() / name, Encoding::linear);
}

TEST(Frames, AreNumberedFromZeroAndGoOnceAround) {
  const Folder folder;
  const Outcome outcome = folder.run(small_teapot + "--count 4 -o turn");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, "turn: 4 of 4 frames, 4 drawn, 0 kept\n");
  const Framebuffer first = frame(folder, "turn/frame_0000.png");
  EXPECT_EQ(first.width, 60);
  for (const char* other : {"turn/frame_0001.png", "turn/frame_0002.png", "turn/frame_0003.png"})
    EXPECT_GT(mean_difference(first, frame(folder, other)), 0.01) << other;
  EXPECT_TRUE(folder.read("turn/frame_0004.png").empty());
}

TEST(Frames, ACameraThatGoesOneWayAroundSeesAnObjectThatTurnsTheOther) {
  const Folder folder;
  folder.run(small_teapot + "--count 5 --orbit camera -o camera");
  folder.run(small_teapot + "--count 5 --orbit object -o object");
  for (int i = 0; i < 5; ++i) {
    const std::string of_camera = "camera/frame_000" + std::to_string(i) + ".png";
    const std::string of_object = "object/frame_000" + std::to_string((5 - i) % 5) + ".png";
    EXPECT_LT(mean_difference(frame(folder, of_camera), frame(folder, of_object)), 2e-3) << i;
  }
}

TEST(Frames, TheOrbitBeginsToTheRightOfTheViewer) {
  const Folder folder;
  folder.run(small_teapot + "--count 4 --eye 0,0,5 --target 0,0,0 --light 1,2,3 -o turn");
  folder.run("render teapot:3 --size 60x45 --eye 5,0,0 --target 0,0,0 --light 1,2,3 -o right.png");
  EXPECT_LT(mean_difference(frame(folder, "turn/frame_0001.png"), frame(folder, "right.png")),
            2e-3);
}

TEST(Frames, ALightGoesAroundTheScenesMiddle) {
  const Folder folder;
  folder.run("frames sphere:8 --size 60x45 --count 4 --orbit light --light 0,0,1 -o lit");
  folder.run("render sphere:8 --size 60x45 --light 1,0,0 -o right.png");
  EXPECT_LT(mean_difference(frame(folder, "lit/frame_0001.png"), frame(folder, "right.png")), 2e-3);
  folder.run(
      "frames sphere:8 --size 60x45 --count 4 --orbit light --axis 1,0,0 --light 0,0,1 "
      "-o over");
  folder.run("render sphere:8 --size 60x45 --light 0,-1,0 -o below.png");
  EXPECT_LT(mean_difference(frame(folder, "over/frame_0001.png"), frame(folder, "below.png")),
            2e-3);
}

TEST(Frames, FinishedOnesAreKeptAndDamagedOnesRedone) {
  const Folder folder;
  const std::string command = small_teapot + "--count 6 -o d";
  folder.run(command);
  const std::string second = folder.read("d/frame_0002.png");
  folder.write("d/frame_0002.png", second.substr(0, second.size() / 2));
  folder.write("d/frame_0003.png", "no picture");
  std::filesystem::remove(folder.path() / "d/frame_0004.png");
  folder.run("render cube --size 9x9 -o d/frame_0005.png");
  const auto kept = std::filesystem::last_write_time(folder.path() / "d/frame_0000.png");
  EXPECT_EQ(folder.run(command).out, "d: 6 of 6 frames, 4 drawn, 2 kept\n");
  EXPECT_EQ(folder.read("d/frame_0002.png"), second);
  EXPECT_EQ(std::filesystem::last_write_time(folder.path() / "d/frame_0000.png"), kept);
  EXPECT_EQ(folder.run(command + " --threads 1").out, "d: 6 of 6 frames, 0 drawn, 6 kept\n");
}

TEST(Frames, ThoseOfAnotherJobAreRefusedUnlessForced) {
  const Folder folder;
  folder.write("s.toml", "[[object]]\nmesh = 'cube'\n");
  const std::string command = "frames s.toml --size 20x15 --count 3 -o d ";
  folder.run(command);
  expect_refusal(folder.run(command + "--exposure 1"), "of another job: '--exposure' differs");
  expect_refusal(folder.run("frames cube --size 20x15 --count 3 -o d"), "of another job");
  folder.write("s.toml", "[[object]]\nmesh = 'sphere'\n");
  expect_refusal(folder.run(command), "'content of s.toml' differs");
  EXPECT_EQ(folder.run(command + "--count 2 --force").exit_code, 2) << "--count twice";
  EXPECT_EQ(folder.run("frames s.toml --size 20x15 --count 2 -o d --force").out,
            "d: 2 of 2 frames, 2 drawn, 0 kept\n");
  EXPECT_TRUE(folder.read("d/frame_0002.png").empty()) << "the other job's last frame";
  std::filesystem::remove(folder.path() / "d/frames.json");
  expect_refusal(folder.run("frames s.toml --size 20x15 --count 2 -o d"), "no frames.json");
}

TEST(Frames, AnImageOfAMaterialIsPartOfTheJob) {
  const Folder folder;
  folder.run("render cube --size 4x4 -o image.png");
  const std::string command =
      "frames sphere:4 --model 'lambert:kd=image(image.png)' --size 20x15 --count 2 -o d";
  EXPECT_EQ(folder.run(command).exit_code, 0);
  folder.run("render sphere --size 4x4 -o image.png");
  expect_refusal(folder.run(command), "'content of image.png' differs");
}

TEST(Frames, AnAnimationIsMadeOnceAllAreThere) {
  const Folder folder;
  const std::string command = small_teapot + "--count 4 -o d --gif d/turn.gif --fps 20 ";
  const Outcome half = folder.run(command + "--range 0:1");
  EXPECT_EQ(half.err,
            "note: d/turn.gif is made by whoever draws the last frame; frame_0002.png is "
            "not there yet\n");
  EXPECT_TRUE(folder.read("d/turn.gif").empty());
  const Outcome rest = folder.run(command + "--range 2:3");
  EXPECT_EQ(rest.err, "");
  EXPECT_TRUE(contains(rest.out, "d/turn.gif: 4 frames\n")) << rest.out;
  const std::string gif = folder.read("d/turn.gif");
  EXPECT_EQ(gif.substr(0, 6), "GIF89a");
  EXPECT_TRUE(contains(gif, "NETSCAPE2.0")) << "it repeats";
  const std::string five_hundredths{'\x21', '\xf9', '\x04', '\x05', '\x05', '\x00'};
  EXPECT_EQ(count_of(gif, five_hundredths), 4u);
  EXPECT_LT(mean_difference(frame(folder, "d/turn.gif"), frame(folder, "d/frame_0000.png")), 0.02);
}

TEST(Frames, AnAnimationOfExrLooksAsThatOfPng) {
  const Folder folder;
  folder.run("frames cube --size 40x30 --count 2 --gif png.gif -o png");
  folder.run("frames cube --size 40x30 --count 2 --gif exr.gif --format exr -o exr");
  EXPECT_EQ(folder.read("exr/frame_0001.exr").substr(0, 4), "v/1\1");
  EXPECT_FALSE(folder.read("png.gif").empty());
  EXPECT_EQ(folder.read("png.gif"), folder.read("exr.gif"));
}

TEST(Frames, BadInputIsOneLineAndLeavesNothing) {
  const Folder folder;
  struct Bad {
    const char *arguments, *message;
  };
  for (const auto& [arguments, message] :
       {Bad{"cube", "--output is required"}, Bad{"none.obj -o d", "none.obj"},
        Bad{"cube -o d --count 0", "--count: 0 is out of range"},
        Bad{"cube -o d --orbit moon", "--orbit: unknown orbit 'moon'; there are: none, camera"},
        Bad{"cube -o d --orbit light --axis 0,0,0", "--axis: the axis is the zero vector"},
        Bad{"cube -o d --exposure 0:1 --axis 0,1,0", "--axis: nothing goes around it"},
        Bad{"cube -o d --range 3:36", "--range: 36 is out of range; allowed is 0 to 35"},
        Bad{"cube -o d --range 5:3", "--range"}, Bad{"cube -o d --range 5", "FIRST:LAST"},
        Bad{"cube -o d --format bmp", "unknown format 'bmp'; there are: png, exr"},
        Bad{"cube -o d --gif a.png", "a.png: an animation is a .gif file"},
        Bad{"cube -o d --gif no/a.gif", "there is no folder 'no'"},
        Bad{"cube -o d --gif a.gif --size 4000x4000", "too many for a frame of a GIF"},
        Bad{"cube -o d --gif a.gif --size 1000x1000 --count 2000", "a file of gigabytes"},
        Bad{"cube -o d --fps 0", "--fps: 0 is out of range; allowed is 1 to 50"},
        Bad{"cube -o d --slurm", "--slurm: SLURM_ARRAY_TASK_ID"},
        Bad{"cube -o /proc/d", "/proc/d"}}) {
    expect_refusal(folder.run(std::string("frames ") + arguments), message);
    EXPECT_EQ(folder.files(), std::vector<std::string>{}) << arguments;
  }
}

TEST(ProgressBar, SaysTheTimeLeftAsAClockDoes) {
  EXPECT_EQ(studio::time_left(0.2), "1 s left");
  EXPECT_EQ(studio::time_left(59), "59 s left");
  EXPECT_EQ(studio::time_left(61), "1:01 left");
  EXPECT_EQ(studio::time_left(3723), "1:02:03 left");
}

}  // namespace
}  // namespace scanlit::test
