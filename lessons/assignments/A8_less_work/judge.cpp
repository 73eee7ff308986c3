// A8: the judge evaluates the model for the student's program, and counts.
#include <algorithm>
#include <cmath>

#include "lessons/assignments/A8_less_work/parts.h"
#include "lessons/assignments/judge/judged_picture.h"
#include "lessons/assignments/judge/registry.h"
#include "lessons/assignments/judge/worded.h"
#include "rasterizer/framebuffer.h"

namespace scanlit::assignments {
namespace {

using namespace less_work;

/// Rows one below the other, as strips.
Framebuffer strips(const std::vector<a8::Colour>& pixels, int scale, int height) {
  constexpr int columns = 64;
  Framebuffer picture(columns * scale, rows * height);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const a8::Colour& c = pixels[std::size_t(y / height * columns + x / scale)];
      const double all[] = {c.r, c.g, c.b, 1};
      for (std::size_t k = 0; k < 4; ++k)
        picture.colour[4 * std::size_t(y * picture.width + x) + k] =
            float(std::clamp(all[k], 0., 1.));
    }
  return picture;
}

constexpr const char* only_right = "Work counts only where the picture is right: see A8.1.";

Finding test_right(Examination& e) {
  const Shaded shaded = shade_rows(e);
  e.pictures.push_back(judged("A8.1-rows", "The rows, as strips", strips(shaded.pixels, 1, 3),
                              strips(shaded.right, 1, 3)));
  if (shaded.is_right()) return {};
  return Finding::wrong(
      worded("The worst pixel is off by %.3g times the tolerance. ", shaded.error) + shaded.worst);
}

/// All points at `full` evaluations, none at `none`.
Finding test_work(Examination& e, int Work::*none, int Work::*full, const char* hint) {
  const Shaded shaded = shade_rows(e);
  if (!shaded.is_right()) return Finding::wrong(only_right);
  const double most = shaded.work.*none, least = shaded.work.*full;
  const double share = std::clamp((most - shaded.evaluations) / (most - least), 0., 1.);
  if (share == 1) return {};
  return {std::round(share * 100) / 100,
          worded("%d evaluations, where %.0f will do; from %.0f on there are no points.\n%s",
                 shaded.evaluations, least, most, hint)};
}

Finding test_visible(Examination& e) {
  const Shaded shaded = shade_rows(e);
  if (!shaded.is_right()) return Finding::wrong(only_right);
  if (shaded.evaluations <= shaded.work.visible) return {};
  return Finding::wrong(
      worded("%d evaluations, where %d will do.\nFragments are evaluated that "
             "another one hides.",
             shaded.evaluations, shaded.work.visible));
}

Finding test_lit(Examination& e) {
  return test_work(e, &Work::visible, &Work::lit,
                   "Which lights stand behind the surface, or out of reach?");
}
Finding test_bounded(Examination& e) {
  return test_work(
      e, &Work::lit, &Work::bounded,
      "The tolerance is for all that is left out at a pixel, together: how many of the "
      "weakest lights is that at most?");
}

/// Of a program that is right.
std::optional<Effort> effort(Examination& e) {
  const Shaded shaded = shade_rows(e);
  if (!shaded.is_right()) return std::nullopt;
  return Effort{
      .evaluations = shaded.evaluations, .fragments = shaded.fragments, .seconds = shaded.seconds};
}

Words words_of(std::uint64_t seed) {
  const Variant variant(seed);
  const auto power = [](const std::string& text, int exponent) {
    return exponent == 1 ? text : text + "^" + std::to_string(exponent);
  };
  const std::string near = variant.inner == 1 ? "d / reach" : power("(d / reach)", variant.inner);
  return {{"larger_is_nearer", variant.larger_is_nearer ? "true" : "false"},
          {"inner", std::to_string(variant.inner)},
          {"outer", std::to_string(variant.outer)},
          {"share", power("(1 - " + near + ")", variant.outer)},
          {"first_wins", variant.first_wins ? "true" : "false"},
          {"nearer", variant.larger_is_nearer ? "larger" : "smaller"},
          {"winner", variant.first_wins ? "first" : "last"}};
}

std::map<std::string, JudgedPicture> illustrations(std::uint64_t seed) {
  const Variant variant(seed);
  std::vector<a8::Colour> before, after;
  for (int i = 0; i < rows; ++i) {
    const JudgedRow row = drawn_row(variant, 100 + std::uint64_t(i));
    for (const a8::Colour& c : painted_pixels(variant, row)) before.push_back(c);
    for (const a8::Colour& c : right_pixels(variant, row)) after.push_back(c);
  }
  const auto shown = [](const std::vector<a8::Colour>& pixels) {
    const Framebuffer picture = strips(pixels, 5, 16);
    return judged("", "", picture, picture);
  };
  return {{"before.png", shown(before)}, {"after.png", shown(after)}};
}

}  // namespace

Assignment a8_less_work() {
  return {.id = "A8",
          .title = "Less work",
          .folder = "A8_less_work",
          .file = "less_work.cpp",
          .header = "less_work.h",
          .words = words_of,
          .illustrations = illustrations,
          .parts = {{"A8.1", "The picture is right", test_right},
                    {"A8.2", "Only what is seen", test_visible},
                    {"A8.3", "Only lights that arrive", test_lit},
                    {"A8.4", "Only what could be noticed", test_bounded}},
          .effort = effort};
}

}  // namespace scanlit::assignments
