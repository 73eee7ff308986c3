#include "rasterizer/image.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <regex>

#include "rasterizer/image/image_encoding.h"
#include "tests/unit/image_files.h"
#include "tests/unit/same_picture.h"

namespace scanlit {
namespace {

using namespace test;

Framebuffer one_pixel(float red, float green, float blue, float alpha) {
  Framebuffer framebuffer(1, 1);
  framebuffer.colour = {red, green, blue, alpha};
  return framebuffer;
}

// Bytes after the header of a binary PPM of one pixel.
std::vector<int> ppm_codes(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  std::vector<int> codes;
  for (std::size_t i = bytes.size() - 3; i < bytes.size(); ++i)
    codes.push_back(static_cast<unsigned char>(bytes[i]));
  return codes;
}

TEST_F(ImageTest, LosslessFormatsComeBackWithinHalfACode) {
  const Framebuffer original = gradient(37, 150);  // more than two blocks of rows
  const EightBitEncoder encode(Encoding::srgb);
  for (const char* suffix : {".png", ".bmp", ".tga", ".tif", ".tiff", ".ppm", ".PNG"}) {
    const fs::path file = in_folder(std::string("a") + suffix);
    write_image(file, original);
    const Framebuffer back = read_image(file);
    ASSERT_EQ(back.width, 37) << suffix;
    ASSERT_EQ(back.height, 150) << suffix;
    for (std::size_t i = 0; i < original.colour.size(); ++i)
      if (i % 4 == 3)
        ASSERT_EQ(back.colour[i], 1) << suffix;
      else
        ASSERT_EQ(encode(back.colour[i]), encode(original.colour[i])) << suffix << " at " << i;
  }
}

TEST_F(ImageTest, JpegComesBackNearly) {
  Framebuffer grey(64, 64);
  for (float& value : grey.colour) value = 0.5f;
  for (const char* name : {"a.jpg", "a.jpeg"}) {
    write_image(in_folder(name), grey);
    EXPECT_NEAR(read_image(in_folder(name)).colour[0], 0.5, 0.01);
  }
}

TEST_F(ImageTest, FloatFormatsStayLinear) {
  Framebuffer original = gradient(20, 70);
  original.colour[0] = 1000;
  ImageOptions options;
  options.exposure_ev = 1;
  write_image(in_folder("a.exr"), original, options);
  write_image(in_folder("a.hdr"), original, options);
  const Framebuffer exr = read_image(in_folder("a.exr")), hdr = read_image(in_folder("a.hdr"));
  for (std::size_t i = 0; i < original.colour.size(); i += 4) {
    float largest = 0;
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(exr.colour[i + c], 2 * original.colour[i + c]);
      largest = std::max(largest, exr.colour[i + c]);
    }
    EXPECT_EQ(exr.colour[i + 3], original.colour[i + 3]);
    // One exponent for three channels of 8 bits.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(hdr.colour[i + c], exr.colour[i + c], largest / 128);
  }
}

TEST_F(ImageTest, LinearEncodingAndExposure) {
  ImageOptions options;
  options.encoding = Encoding::linear;
  options.exposure_ev = -1;
  const fs::path file = in_folder("a.ppm");
  write_image(file, one_pixel(1.0f, 0.5f, 0.25f, 1), options);
  EXPECT_EQ(ppm_codes(file), (std::vector{128, 64, 32}));
  EXPECT_NEAR(read_image(file, Encoding::linear).colour[0], 128 / 255.0, 1e-6);
}

TEST_F(ImageTest, IntegerFormatsShowColourOverTheBackgroundItHas) {
  const fs::path file = in_folder("a.ppm");
  write_image(file, one_pixel(0.5f, 0.5f, 0.5f, 0.5f));  // not divided by alpha
  EXPECT_EQ(ppm_codes(file), (std::vector{188, 188, 188}));
}

TEST_F(ImageTest, PngSaysHowItIsEncoded) {
  const auto contains = [](const fs::path& file, const char* chunk) {
    std::ifstream in(file, std::ios::binary);
    return std::string((std::istreambuf_iterator<char>(in)), {}).find(chunk) != std::string::npos;
  };
  write_image(in_folder("srgb.png"), gradient(4, 4));
  EXPECT_TRUE(contains(in_folder("srgb.png"), "sRGB"));
  ImageOptions options;
  options.encoding = Encoding::linear;
  write_image(in_folder("linear.png"), gradient(4, 4), options);
  EXPECT_FALSE(contains(in_folder("linear.png"), "sRGB"));
  EXPECT_TRUE(contains(in_folder("linear.png"), "gAMA"));
}

TEST_F(ImageTest, CountsClippedPixelsWhereSomethingIsCovered) {
  Framebuffer framebuffer(2, 2);
  framebuffer.colour = {2, 2, 2, 1, 0, 1.5f, 0, 0.5f, 3, 3, 3, 0, 1, 1, 1, 1};
  EXPECT_EQ(write_image(in_folder("a.png"), framebuffer).clipped_pixels, 2);
  EXPECT_EQ(write_image(in_folder("a.exr"), framebuffer).clipped_pixels, 0);
  ImageOptions options;
  options.exposure_ev = -1;
  EXPECT_EQ(write_image(in_folder("a.png"), framebuffer, options).clipped_pixels, 0);
}

TEST_F(ImageTest, AovsComeBackToTheBit) {
  Framebuffer original =
      gradient(33, 70, {.depth = true, .normal = true, .ids = true, .parts = true, .cost = true});
  for (std::size_t i = 0; i < original.pixel_count(); ++i) {
    original.depth[i] = 1 / float(i + 3);
    original.object_id[i] = i % 7 == 0 ? no_id : std::uint32_t(i % 5);
    original.triangle_id[i] = (1u << 24) + std::uint32_t(i);  // not every one is a float
    for (std::size_t c = 0; c < 2; ++c) original.cost[2 * i + c] = float(7 * c + i);
    for (int c = 0; c < 3; ++c) {
      original.normal[3 * i + c] = float(c) - float(i);
      original.ambient[3 * i + c] = 0.1f * float(i + c);
      original.diffuse[3 * i + c] = 0.2f * float(i + c);
      original.glossy[3 * i + c] = 0.3f * float(i + c);
    }
  }
  write_aovs(in_folder("a.exr"), original);
  const Framebuffer back = read_image(in_folder("a.exr"));
  EXPECT_EQ(back.planes(), original.planes());
  EXPECT_EQ(planes_that_differ(back, original), "");
}

TEST_F(ImageTest, AovsHoldOnlyThePlanesThereAre) {
  write_aovs(in_folder("a.exr"), gradient(4, 4, {.depth = true}));
  EXPECT_EQ(read_image(in_folder("a.exr")).planes(), (Planes{.depth = true}));
}

TEST_F(ImageTest, NoFormatStoresTheTime) {
  for (const char* name : {"a.png", "a.tif", "a.exr", "a.hdr", "a.jpg"}) {
    write_image(in_folder(name), gradient(8, 8));
    std::ifstream in(in_folder(name), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), {});
    EXPECT_FALSE(std::regex_search(bytes, std::regex("20[0-9][0-9]:[0-9][0-9]:"))) << name;
  }
}

}  // namespace
}  // namespace scanlit
