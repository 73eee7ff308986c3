// Golden images: a picture is drawn anew and compared with a reference that somebody looked at.
// A new case is one entry in cases.cpp and `tests/bless NAME`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rasterizer/framebuffer.h"

namespace scanlit::golden {

/// How far colours, normals and parts may be from the reference. Coverage (alpha), depth and the
/// object and triangle ids have to be equal to the bit.
struct Tolerance {
  float absolute;  // a channel may differ by this much, or
  float relative;  // by this share of the mean of the two values;
  int pixels;      // so many pixels may differ by more: at most .1 % of the picture
  std::string reason;
};

struct Case {
  std::string name;  // of the reference file; letters, digits and _
  Tolerance tolerance;
  // Renders, or reads with read_image what another program wrote. The planes it holds are those
  // that are compared.
  std::function<Framebuffer()> draw;
};

/// The table, in the order in which the report shows passed cases.
const std::vector<Case>& cases();

/// Of the colour's R, G and B.
struct Difference {
  double max = 0, mean = 0, rms = 0;
  std::int64_t pixels = 0;  // that differ by more than the tolerance
};

struct Comparison {
  std::vector<std::string> problems;  // one line each; empty where the pictures agree
  std::optional<Difference> colour;   // where both have the same size and planes
};

Comparison compare(const Framebuffer& actual, const Framebuffer& expected,
                   const Tolerance& tolerance);

/// What came of a case. `actual` is missing where drawing failed, `expected` where there is no
/// readable reference; both are among the problems then.
struct Result {
  std::string name;
  Tolerance tolerance;
  std::optional<Framebuffer> actual, expected;
  Comparison comparison;

  bool passed() const { return comparison.problems.empty(); }
};

/// Draws the case and compares it with NAME.exr in the folder; never throws for a picture's sake.
Result check(const Case& golden_case, const std::filesystem::path& references);

/// Draws the case, makes the picture the reference, and returns lines that tell the difference to
/// the reference before and after. Throws Error where the case cannot be drawn or written, or the
/// picture holds a NaN or Inf.
std::string bless(const Case& golden_case, const std::filesystem::path& references);

/// Empties the folder and writes index.html, failures first, with the pictures it shows: actual,
/// expected, and their difference amplified.
void write_report(const std::filesystem::path& folder, const std::vector<Result>& results);

}  // namespace scanlit::golden
