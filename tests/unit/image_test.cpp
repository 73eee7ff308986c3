#include "rasterizer/image.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <regex>

#include "rasterizer/error.h"
#include "rasterizer/image/image_encoding.h"

namespace scanlit {
namespace {

namespace fs = std::filesystem;

class ImageTest : public testing::Test {
 protected:
  ImageTest() { fs::create_directories(folder_); }
  ~ImageTest() override { fs::remove_all(folder_); }
  fs::path in_folder(const std::string& name) const { return folder_ / name; }
  std::size_t files() const {
    return std::size_t(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

 private:
  fs::path folder_ = fs::path(testing::TempDir()) / ("scanlit-image-" + std::to_string(getpid()));
};

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

// Every pixel and channel different; the lower right corner is not covered.
Framebuffer gradient(int width, int height, const Planes& planes = {}) {
  Framebuffer framebuffer(width, height, planes);
  for (std::size_t i = 0; i < framebuffer.pixel_count(); ++i) {
    const float t = float(i + 1) / float(framebuffer.pixel_count() + 1);
    const float rgba[4] = {t, t * t, 1 - t, t < 0.9f ? 1.0f : 0.0f};
    std::memcpy(&framebuffer.colour[4 * i], rgba, sizeof rgba);
  }
  return framebuffer;
}

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
  Framebuffer original = gradient(33, 70, {true, true, true, true});
  for (std::size_t i = 0; i < original.pixel_count(); ++i) {
    original.depth[i] = 1 / float(i + 3);
    original.object_id[i] = i % 7 == 0 ? no_id : std::uint32_t(i % 5);
    original.triangle_id[i] = (1u << 24) + std::uint32_t(i);  // not every one is a float
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
  EXPECT_EQ(back.colour, original.colour);
  EXPECT_EQ(back.depth, original.depth);
  EXPECT_EQ(back.normal, original.normal);
  EXPECT_EQ(back.object_id, original.object_id);
  EXPECT_EQ(back.triangle_id, original.triangle_id);
  EXPECT_EQ(back.ambient, original.ambient);
  EXPECT_EQ(back.diffuse, original.diffuse);
  EXPECT_EQ(back.glossy, original.glossy);
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

TEST_F(ImageTest, ReplacesAFileAndLeavesNothingElse) {
  const fs::path file = in_folder("a.png");
  std::ofstream(file) << "old";
  write_image(file, gradient(5, 5));
  EXPECT_EQ(read_image(file).width, 5);
  EXPECT_EQ(files(), 1u);
}

TEST_F(ImageTest, ALinkStaysALinkToWhatIsReplaced) {
  fs::create_directory(in_folder("elsewhere"));
  std::ofstream(in_folder("elsewhere/a.png")) << "old";
  fs::create_symlink("elsewhere/a.png", in_folder("link.png"));
  write_image(in_folder("link.png"), gradient(5, 5));
  EXPECT_TRUE(fs::is_symlink(in_folder("link.png")));
  EXPECT_EQ(read_image(in_folder("elsewhere/a.png")).width, 5);
}

TEST_F(ImageTest, WritesIntoTheWorkingFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(in_folder(""));
  write_image("a.png", gradient(5, 5));
  fs::current_path(before);
  EXPECT_TRUE(fs::exists(in_folder("a.png")));
}

TEST_F(ImageTest, RefusesNamesItCannotUse) {
  const Framebuffer framebuffer = gradient(4, 4);
  const auto refusal = [&](const fs::path& file) {
    const std::string error = error_of([&] { write_image(file, framebuffer); });
    EXPECT_EQ(error, error_of([&] { check_image_target(file, 4, 4); }));
    EXPECT_EQ(error.find(file.string() + ": "), 0u) << error;
    return error.substr(std::min(error.size(), file.string().size() + 2));
  };
  EXPECT_EQ(refusal("a.gif"),
            "unknown image format '.gif'; there are: .png, .jpg, .jpeg, .bmp, .tga, .tif, .tiff, "
            ".ppm, .hdr, .exr");
  EXPECT_EQ(refusal("picture").find("the name has no suffix"), 0u);
  EXPECT_EQ(refusal(in_folder("none/a.png")),
            "there is no folder '" + in_folder("none").string() + "'");
  std::ofstream(in_folder("file")) << "x";
  EXPECT_EQ(refusal(in_folder("file/a.png")), "cannot create a file there: Not a directory");
  EXPECT_EQ(refusal("/proc/a.png"), "cannot create a file there: No such file or directory");
  EXPECT_EQ(refusal(in_folder(std::string(300, 'a') + ".png")),
            "cannot create a file there: File name too long");
  fs::create_directory(in_folder("folder.png"));
  EXPECT_EQ(refusal(in_folder("folder.png")), "is a folder; the name of a file is needed");
  EXPECT_EQ(files(), 2u);
}

TEST_F(ImageTest, RefusesWhatItCannotWrite) {
  EXPECT_EQ(error_of([&] { write_aovs("a.png", gradient(4, 4)); }),
            "a.png: only an .exr file holds named channels");
  EXPECT_THROW(write_image(in_folder("a.png"), Framebuffer()), Error);
  EXPECT_THROW(check_image_target(in_folder("a.png"), 16385, 4), Error);
  Framebuffer torn = gradient(4, 4);
  torn.colour.pop_back();
  EXPECT_THROW(write_image(in_folder("a.png"), torn), Error);
  for (const double ev : {33.0, std::nan(""), -std::numeric_limits<double>::infinity()}) {
    ImageOptions options;
    options.exposure_ev = ev;
    EXPECT_THROW(write_image(in_folder("a.png"), gradient(4, 4), options), Error);
  }
  EXPECT_EQ(files(), 0u);
}

// No file may grow beyond so many bytes while this lives: to a program that ignores the signal, a
// write beyond it fails as one on a full disk does.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    previous_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &previous_);
    const rlimit limit{bytes, previous_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &previous_);
    std::signal(SIGXFSZ, previous_handler_);
  }

 private:
  rlimit previous_{};
  void (*previous_handler_)(int) = nullptr;
};

TEST_F(ImageTest, AFullDiskIsAnErrorInEveryFormatAndLeavesTheOldFile) {
  Framebuffer noise(300, 300);
  std::uint32_t state = 1;
  for (float& value : noise.colour)
    value = float((state = state * 1664525u + 1013904223u) >> 8) / float(1 << 24);
  for (const char* suffix : {".png", ".jpg", ".bmp", ".tga", ".tif", ".ppm", ".hdr", ".exr"}) {
    const fs::path file = in_folder(std::string("a") + suffix);
    write_image(file, noise);
    const auto size = fs::file_size(file);
    // The first byte, the middle, and what is written last: an index, or a buffer's rest.
    for (const auto limit : {std::uintmax_t(0), size / 2, size - 1}) {
      std::ofstream(file) << "old";
      std::string error;
      {
        const FileSizeLimit disk(limit);
        error = error_of([&] { write_image(file, noise); });
      }
      EXPECT_EQ(error, file.string() + ": cannot write: File too large") << limit;
      EXPECT_EQ(fs::file_size(file), 3u);
      EXPECT_EQ(files(), 1u);
    }
    fs::remove(file);
  }
}

TEST_F(ImageTest, ReadingSaysWhatIsWrong) {
  const auto refusal = [&](const fs::path& file) { return error_of([&] { read_image(file); }); };
  const auto none = in_folder("none.png"), text = in_folder("text.png");
  EXPECT_EQ(refusal(none).find(none.string() + ": cannot read the image: "), 0u);
  std::ofstream(text) << "not a picture";
  EXPECT_EQ(refusal(text).find(text.string() + ": cannot read the image: "), 0u);
  write_image(in_folder("cut.png"), gradient(64, 64));
  fs::resize_file(in_folder("cut.png"), fs::file_size(in_folder("cut.png")) / 2);
  EXPECT_NE(refusal(in_folder("cut.png")), "no error");
  std::ofstream(in_folder("huge.ppm")) << "P6 2000000000 2000000000 255\n";
  EXPECT_NE(refusal(in_folder("huge.ppm")), "no error");
}

TEST(Framebuffer, HoldsWhatIsAskedForAndIsClear) {
  const Framebuffer framebuffer(3, 2, {.depth = true, .ids = true});
  EXPECT_EQ(framebuffer.planes(), (Planes{.depth = true, .ids = true}));
  EXPECT_EQ(framebuffer.colour, std::vector<float>(24));
  EXPECT_EQ(framebuffer.depth, std::vector<float>(6));
  EXPECT_EQ(framebuffer.triangle_id, std::vector<std::uint32_t>(6, no_id));
}

TEST(Framebuffer, RefusesSizes) {
  EXPECT_NO_THROW(Framebuffer(1, 1));
  for (const auto& [width, height] : {std::pair{0, 1}, {1, 0}, {-5, 5}, {16385, 1}, {1, 16385}})
    EXPECT_THROW(Framebuffer(width, height), Error);
}

}  // namespace
}  // namespace scanlit
