#include "lessons/assignments/judge/judged_picture.h"

#include <algorithm>
#include <cmath>

#include "rasterizer/image/image_encoding.h"
#include "rasterizer/reference/picture_error.h"

namespace scanlit::assignments {

std::vector<std::uint8_t> codes_of(const Framebuffer& framebuffer) {
  std::vector<std::uint8_t> codes;
  codes.reserve(3 * framebuffer.pixel_count());
  for (std::size_t i = 0; i < framebuffer.pixel_count(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double light = std::clamp(double(framebuffer.colour[4 * i + c]), 0.0, 1.0);
      codes.push_back(std::uint8_t(std::lround(255 * encoded(light, Encoding::srgb))));
    }
  return codes;
}

JudgedPicture judged(std::string name, std::string title, const Framebuffer& fresh,
                     const Framebuffer& reference) {
  JudgedPicture picture{.name = std::move(name),
                        .title = std::move(title),
                        .width = reference.width,
                        .height = reference.height,
                        .fresh = codes_of(fresh),
                        .reference = codes_of(reference)};
  picture.difference.reserve(picture.fresh.size());
  for (std::size_t i = 0; i < picture.fresh.size(); ++i) {
    const int off = std::abs(int(picture.fresh[i]) - int(picture.reference[i]));
    picture.difference.push_back(std::uint8_t(off == 0 ? 0 : std::min(255, 40 + 4 * off)));
  }
  return picture;
}

std::optional<PixelDifference> first_difference(const JudgedPicture& picture, int tolerance) {
  std::optional<PixelDifference> first;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto at = 3 * std::size_t(y * picture.width + x);
      int off = 0;
      for (std::size_t c = at; c < at + 3; ++c)
        off = std::max(off, std::abs(int(picture.fresh[c]) - int(picture.reference[c])));
      if (off <= tolerance) continue;
      if (!first) first = {x, y, 0};
      ++first->count;
    }
  return first;
}

Framebuffer picture_of(int width, int height, const std::vector<std::uint8_t>& rgb) {
  Framebuffer framebuffer(width, height);
  for (std::size_t i = 0; i < framebuffer.pixel_count(); ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      framebuffer.colour[4 * i + c] = float(linear_from_srgb(rgb[3 * i + c] / 255.0));
    framebuffer.colour[4 * i + 3] = 1;
  }
  return framebuffer;
}

// ------------------------------------------------------------------------------------- characters

namespace {

char symbol(int covered, int expected) {
  if (covered == expected) return covered == 0 ? '.' : '#';
  if (covered == 0) return '-';
  if (expected == 0) return '+';
  return covered > expected ? '2' : '-';
}

}  // namespace

std::string draw_faults(const CoverageGrid& grid, bool y_up) {
  constexpr int columns = 64, rows = 24;
  int counts[3] = {};  // missing, doubled, misplaced
  int first_x = -1, first_y = -1;
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x) {
      const char c = symbol(grid.covered[grid.at(x, y)], grid.expected[grid.at(x, y)]);
      if (c == '.' || c == '#') continue;
      ++counts[c == '-' ? 0 : c == '2' ? 1 : 2];
      if (first_x < 0) first_x = x, first_y = y;
    }
  if (first_x < 0) return "";
  const int left = std::clamp(first_x - columns / 2, 0, std::max(0, grid.width - columns));
  const int top = std::clamp(first_y - rows / 3, 0, std::max(0, grid.height - rows));
  std::string text;
  for (int y = top; y < std::min(top + rows, grid.height); ++y) {
    text += "  ";
    for (int x = left; x < std::min(left + columns, grid.width); ++x)
      text += symbol(grid.covered[grid.at(x, y)], grid.expected[grid.at(x, y)]);
    text += "\n";
  }
  const auto row = [&](int y) { return std::to_string(y_up ? grid.height - 1 - y : y); };
  text += "  # right, - missing (" + std::to_string(counts[0]) + "), 2 doubled (" +
          std::to_string(counts[1]) + "), + should not be there (" + std::to_string(counts[2]) +
          "); first at column " + std::to_string(first_x) + ", row " + row(first_y);
  if (left > 0 || top > 0)
    text += "; what is drawn begins at column " + std::to_string(left) + ", row " + row(top);
  return text;
}

}  // namespace scanlit::assignments
