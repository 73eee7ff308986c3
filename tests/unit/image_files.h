// What the tests of image files share: a folder of their own, a picture, a refusal's words.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <functional>
#include <iterator>
#include <string>

#include "rasterizer/error.h"
#include "rasterizer/image.h"

namespace scanlit::test {

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

inline std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

// Every pixel and channel different; the lower right corner is not covered.
inline Framebuffer gradient(int width, int height, const Planes& planes = {}) {
  Framebuffer framebuffer(width, height, planes);
  for (std::size_t i = 0; i < framebuffer.pixel_count(); ++i) {
    const float t = float(i + 1) / float(framebuffer.pixel_count() + 1);
    const float rgba[4] = {t, t * t, 1 - t, t < 0.9f ? 1.0f : 0.0f};
    std::memcpy(&framebuffer.colour[4 * i], rgba, sizeof rgba);
  }
  return framebuffer;
}

}  // namespace scanlit::test
