// The judge's own pictures: from light to codes, what differs, and how a fault looks in characters.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lessons/assignments/judge/verdict.h"
#include "rasterizer/framebuffer.h"

namespace scanlit::assignments {

/// sRGB codes of a picture in linear light, rgb.
std::vector<std::uint8_t> codes_of(const Framebuffer& framebuffer);

/// A picture beside what it should be. In the difference, black is none; what is off by one code
/// is to be seen.
JudgedPicture judged(std::string name, std::string title, const Framebuffer& fresh,
                     const Framebuffer& reference);

/// A pixel in which the two differ by more than so many codes in a channel: the first, from the top
/// left, and how many there are.
struct PixelDifference {
  int x = 0, y = 0, count = 0;
};
std::optional<PixelDifference> first_difference(const JudgedPicture& picture, int tolerance);

/// Linear light that has these sRGB codes, rgb.
Framebuffer picture_of(int width, int height, const std::vector<std::uint8_t>& rgb);

/// How often each pixel was covered, and how often it should have been.
struct CoverageGrid {
  int width = 0, height = 0;
  std::vector<int> covered, expected;

  CoverageGrid(int w, int h)
      : width(w), height(h), covered(std::size_t(w * h)), expected(std::size_t(w * h)) {}
  std::size_t at(int x, int y) const { return std::size_t(y * width + x); }
};

/// Missing, doubled and misplaced fragments as characters, around the first of them; empty where
/// there are none. `#` is as it should be, `.` empty. The grid's row 0 is on top; y_up counts rows
/// from below.
std::string draw_faults(const CoverageGrid& grid, bool y_up = false);

}  // namespace scanlit::assignments
