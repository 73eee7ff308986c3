// image(FILE): what a file's pixels become on a surface.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <numbers>
#include <thread>
#include <vector>

#include "models/inputs/image.h"
#include "rasterizer/image/image_encoding.h"
#include "tests/unit/image_files.h"

namespace scanlit {
namespace {

using test::error_of;

class ImageInput : public test::ImageTest {
 protected:
  /// Writes a picture of the given linear colours, row 0 on top.
  void write(const std::string& name, int width, int height,
             const std::vector<std::array<float, 3>>& colours,
             Encoding encoding = Encoding::srgb) const {
    Framebuffer framebuffer(width, height, {});
    for (std::size_t i = 0; i < colours.size(); ++i) {
      const float rgba[4] = {colours[i][0], colours[i][1], colours[i][2], 1};
      std::memcpy(&framebuffer.colour[4 * i], rgba, sizeof rgba);
    }
    write_image(in_folder(name), framebuffer, {.encoding = encoding});
  }
  /// Black and white pixels by turns.
  void write_checks(const std::string& name, int size) const {
    std::vector<std::array<float, 3>> pixels;
    for (int i = 0; i < size * size; ++i) pixels.push_back(std::array<float, 3>{});
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        if ((x + y) % 2) pixels[std::size_t(y * size + x)] = {1, 1, 1};
    write(name, size, size, pixels);
  }
  std::shared_ptr<const models::Input> open(const std::string& arguments) const {
    return models::make_input("image(" + arguments + ")", {"test", in_folder(""), 0});
  }
};

struct Texcoord {
  float u, v;
};

/// The input's channels at texture coordinates; a pixel is `footprint` wide there, if at all.
std::vector<std::array<float, 3>> look_up(const models::Input& input,
                                          const std::vector<Texcoord>& at, std::size_t channels = 3,
                                          Texcoord dx = {}, Texcoord dy = {}) {
  const std::size_t padded = at.size() + max_lanes;
  std::vector<float> u(padded), v(padded), dux(padded, dx.u), dvx(padded, dx.v), duy(padded, dy.u),
      dvy(padded, dy.v), out[3];
  for (std::size_t i = 0; i < at.size(); ++i) u[i] = at[i].u, v[i] = at[i].v;
  for (auto& array : out) array.assign(padded, -1);
  PointSpan points{.size = at.size(), .texcoord = {u.data(), v.data()}};
  if (dx.u != 0 || dx.v != 0 || dy.u != 0 || dy.v != 0) {
    points.texcoord_dx[0] = dux.data(), points.texcoord_dx[1] = dvx.data();
    points.texcoord_dy[0] = duy.data(), points.texcoord_dy[1] = dvy.data();
  }
  float* const arrays[3] = {out[0].data(), out[1].data(), out[2].data()};
  input.evaluate(points, channels, arrays);
  std::vector<std::array<float, 3>> result;
  for (std::size_t i = 0; i < at.size(); ++i) result.push_back({out[0][i], out[1][i], out[2][i]});
  return result;
}

const std::vector<std::array<float, 3>> six = {{0.1f, 0.2f, 0.3f}, {0.9f, 0.5f, 0.0f},
                                               {0.0f, 0.0f, 1.0f}, {0.4f, 0.4f, 0.4f},
                                               {1.0f, 1.0f, 1.0f}, {0.02f, 0.6f, 0.7f}};
/// The centres of the six pixels of a 3 x 2 image, in its order: row 0 is on top, where v = 1.
std::vector<Texcoord> centres() {
  std::vector<Texcoord> result;
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x)
      result.push_back({(float(x) + 0.5f) / 3, 1 - (float(y) + 0.5f) / 2});
  return result;
}

TEST_F(ImageInput, PixelCentresShowTheFilesColours) {
  for (const char* name : {"a.exr", "a.png", "a.tif"}) {
    write(name, 3, 2, six);
    // 8 bits: half a code, where the curve is steepest.
    const double tolerance = std::string(name) == "a.exr" ? 1e-6 : 0.5 / 255 * 2.3;
    const auto shown = look_up(*open(name), centres());
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(shown[i][c], six[i][c], tolerance) << name << ' ' << i << ' ' << c;
  }
}

TEST_F(ImageInput, IntegersAreSrgbForColoursAndTheirValueForNumbers) {
  write("half.png", 1, 1, {{0.5f, 0.2f, 0.1f}}, Encoding::linear);  // code 128
  const double code = 128.0 / 255;
  const auto value = [&](const std::string& arguments, std::size_t channels) {
    return look_up(*open(arguments), {{0.5f, 0.5f}}, channels)[0][0];
  };
  EXPECT_NEAR(value("half.png", 3), linear_from_srgb(code), 1e-6);
  EXPECT_NEAR(value("half.png", 1), code, 1e-6);
  for (const std::size_t channels : {1, 3}) {
    EXPECT_NEAR(value("half.png,space=srgb", channels), linear_from_srgb(code), 1e-6);
    EXPECT_NEAR(value("half.png,space=linear", channels), code, 1e-6);
  }
  write("half.exr", 1, 1, {{0.5f, 0.2f, 0.1f}});
  for (const std::size_t channels : {1, 3})
    EXPECT_NEAR(value("half.exr,space=srgb", channels), 0.5, 1e-6) << "float formats are linear";
}

TEST_F(ImageInput, BetweenPixelsIsTheMixtureOfTheirLight) {
  write("two.png", 2, 1, {{0, 0, 0}, {1, 1, 1}});
  const auto shown = look_up(*open("two.png,wrap=clamp"), {{0.5f, 0.5f}, {0.375f, 0.5f}, {0, 0}});
  EXPECT_NEAR(shown[0][0], 0.5, 1e-6) << "of light, not of codes";
  EXPECT_NEAR(shown[1][0], 0.25, 1e-6);
  EXPECT_NEAR(shown[2][0], 0, 1e-6);
}

TEST_F(ImageInput, WrapSaysWhatThereIsBeyond) {
  write("six.exr", 3, 2, six);
  const Texcoord right{1 + 0.5f / 3, 0.75f};  // one pixel beyond the upper right one
  const auto red = [&](const std::string& arguments) {
    return look_up(*open("six.exr" + arguments), {right})[0][0];
  };
  EXPECT_NEAR(red(""), 0.1, 1e-6);
  EXPECT_NEAR(red(",wrap=periodic"), 0.1, 1e-6);
  EXPECT_NEAR(red(",wrap=clamp"), 0.0, 1e-6);
  EXPECT_NEAR(red(",wrap=mirror"), 0.0, 1e-6);
  EXPECT_NEAR(red(",wrap=black"), 0.0, 1e-6);
  EXPECT_NEAR(look_up(*open("six.exr,wrap=mirror"), {{-0.5f / 3, 0.75f}})[0][0], 0.1, 1e-6);
  EXPECT_NEAR(look_up(*open("six.exr,wrap=black"), {{-0.5f / 3, 0.75f}})[0][0], 0.0, 1e-6);
}

TEST_F(ImageInput, APixelThatHoldsManyIsTheirMean) {
  write_checks("checks.png", 64);
  const auto input = open("checks.png");
  for (const float size : {4 / 64.0f, 16 / 64.0f, 1.0f, 7.0f})
    for (const auto& shown :
         look_up(*input, {{0.3f, 0.7f}, {0.51f, 0.5f}, {0.9f, 0.02f}}, 3, {size, 0}, {0, size}))
      EXPECT_NEAR(shown[0], 0.5, 0.01) << size << ": the mean of light is not that of codes";
}

TEST_F(ImageInput, TheFootprintMayBeLongAndThin) {
  // Vertical stripes, seen at a grazing angle along them: many pixels long, less than one wide. An
  // isotropic filter would turn them to grey.
  std::vector<std::array<float, 3>> stripes;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      stripes.push_back(x % 8 < 4 ? std::array<float, 3>{1, 1, 1} : std::array<float, 3>{0, 0, 0});
  write("stripes.exr", 64, 64, stripes);
  const auto input = open("stripes.exr");
  const auto along =
      look_up(*input, {{2.0f / 64, 0.5f}, {6.0f / 64, 0.5f}}, 3, {0.5f / 64, 0}, {0, 12.0f / 64});
  EXPECT_GT(along[0][0], 0.9);
  EXPECT_LT(along[1][0], 0.1);
  const auto across =
      look_up(*input, {{2.0f / 64, 0.5f}, {6.0f / 64, 0.5f}}, 3, {0, 0.5f / 64}, {32.0f / 64, 0});
  EXPECT_NEAR(across[0][0], 0.5, 0.05);
  EXPECT_NEAR(across[1][0], 0.5, 0.05);
}

TEST_F(ImageInput, AnyTexcoordAndFootprintIsFinite) {
  write("six.png", 3, 2, six);
  const float inf = std::numeric_limits<float>::infinity(), nan = std::nanf("");
  const std::vector<Texcoord> at = {{0, 0},     {1, 1},        {-1e30f, 1e30f}, {inf, -inf},
                                    {nan, nan}, {1e9f, 1e-9f}, {-0.0f, 4e4f}};
  for (const char* wrap : {"periodic", "clamp", "mirror", "black"}) {
    const auto input = open(std::string("six.png,wrap=") + wrap);
    for (const float size : {0.0f, 1e-30f, 1e-6f, 0.1f, 3.0f, 1e6f, 1e30f, inf, nan})
      for (const auto& shown : look_up(*input, at, 3, {size, -size}, {size, 2 * size}))
        for (const float value : shown)
          EXPECT_TRUE(value >= 0 && value <= 1) << wrap << ' ' << size;
  }
}

TEST_F(ImageInput, ThreadsSeeTheSame) {
  write_checks("checks.png", 256);
  std::vector<Texcoord> at;
  for (int i = 0; i < 250; ++i) at.push_back({float(i) * 0.618034f, float(i) * 0.41421f});
  const Texcoord dx{0.011f, 0.002f}, dy{0.001f, 0.04f};
  const auto alone = look_up(*open("checks.png"), at, 3, dx, dy);
  const auto input = open("checks.png");  // whose first look-ups all threads make at once
  std::vector<std::thread> threads;
  std::vector<std::vector<std::array<float, 3>>> shown(8);
  for (auto& mine : shown) threads.emplace_back([&] { mine = look_up(*input, at, 3, dx, dy); });
  for (auto& thread : threads) thread.join();
  for (const auto& mine : shown) EXPECT_EQ(mine, alone);
}

TEST_F(ImageInput, TheFileIsReadOnce) {
  write("gone.png", 3, 2, six);
  const auto input = open("gone.png");
  std::filesystem::remove(in_folder("gone.png"));
  EXPECT_GT(look_up(*input, {{0.8f, 0.75f}})[0][2], 0.9);
}

TEST_F(ImageInput, GreyImagesServeAsColours) {
  std::ofstream(in_folder("grey.pgm"), std::ios::binary) << "P5 1 1 255\n\xff";
  const auto shown = look_up(*open("grey.pgm"), {{0.5f, 0.5f}});
  EXPECT_EQ(shown[0], (std::array<float, 3>{1, 1, 1}));
}

TEST_F(ImageInput, FilesThatAreNoneAreRefusedWhereTheyAreNamed) {
  const auto refusal = [&](const std::string& arguments) {
    return error_of([&] { open(arguments); });
  };
  EXPECT_EQ(refusal("file=missing.png").find(in_folder("missing.png").string()), 0u)
      << refusal("file=missing.png");
  std::ofstream(in_folder("text.png")) << "no image";
  EXPECT_NE(refusal("text.png").find("text.png: cannot read the image: "), std::string::npos)
      << refusal("text.png");
  write_checks("cut.png", 64);
  std::filesystem::resize_file(in_folder("cut.png"), 100);
  EXPECT_NE(refusal("cut.png").find("cut.png: cannot read the image: "), std::string::npos)
      << refusal("cut.png");
  for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
    auto pixels = six;
    pixels[4][1] = bad;
    write("bad.exr", 3, 2, pixels);
    EXPECT_EQ(refusal("bad.exr"),
              in_folder("bad.exr").string() + ": pixel (1, 1) is not a finite number");
  }
  for (const char* arguments : {"missing.png", "text.png", "cut.png", "bad.exr"})
    EXPECT_EQ(refusal(arguments).find('\n'), std::string::npos) << "one line";
}

TEST_F(ImageInput, PipesAndFoldersAreRefusedAndNotWaitedFor) {
  ASSERT_EQ(mkfifo(in_folder("pipe.png").c_str(), 0600), 0);
  std::filesystem::create_directory(in_folder("folder.png"));
  EXPECT_EQ(error_of([&] { open("pipe.png"); }),
            in_folder("pipe.png").string() + ": is not a regular file");
  EXPECT_EQ(error_of([&] { open("folder.png"); }),
            in_folder("folder.png").string() + ": is a folder, not an image");
}

TEST_F(ImageInput, LibrariesOfFormatsDoNotWriteToStandardError) {
  write_checks("cut.png", 64);
  std::filesystem::resize_file(in_folder("cut.png"), 100);
  testing::internal::CaptureStderr();
  error_of([&] { open("cut.png"); });
  std::fputs("and after", stderr);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "and after");
}

TEST_F(ImageInput, BadArguments) {
  write("six.png", 3, 2, six);
  const auto refusal = [&](const std::string& arguments) {
    return error_of([&] { open(arguments); });
  };
  EXPECT_EQ(refusal(""), "test, image: 'file' must be given: image file, relative to the scene's");
  EXPECT_EQ(refusal("six.png,space=gamma"),
            "test, image: 'space' cannot be 'gamma'; there are: automatic, srgb, linear");
  EXPECT_EQ(refusal("six.png,wrap=repeat"),
            "test, image: 'wrap' cannot be 'repeat'; there are: periodic, clamp, mirror, black");
  EXPECT_EQ(refusal("six.png,six.png"), "test, image: expected key=value, not 'six.png'");
  EXPECT_EQ(refusal("six.png,file=six.png"), "test, image: 'file' is given twice");
  write("a (1),b.png", 3, 2, six);
  EXPECT_EQ(refusal("(a (1),b.png)"), "no error") << "parentheses hold any name";
}

}  // namespace
}  // namespace scanlit
