// A1: the variant in words, and the parts.
#include "lessons/assignments/A1_scan_conversion/parts.h"
#include "lessons/assignments/judge/judged_picture.h"
#include "lessons/assignments/judge/registry.h"

namespace scanlit::assignments {
namespace {

using namespace a1;
using namespace scan;

/// A triangle with centres on its edges, as the variant covers it.
std::string example(const ScanVariant& variant) {
  const int height = 6;
  const int shift = variant.centre();
  const Triangle t{
      {{shift + 256, shift + 256}, {shift + 256 * 7, shift + 256}, {shift + 256, shift + 256 * 4}}};
  std::vector<std::string> rows(std::size_t(height), std::string(9, '.'));
  for (const Fragment& f : right_fragments(variant, t, {9, height}))
    rows[std::size_t(engine_row(variant, f.row, height))][std::size_t(f.column)] = '#';
  std::string text = "The triangle " + words(t) + " covers\n\n";
  for (int y = 0; y < height; ++y)
    text += "    row " + std::to_string(engine_row(variant, y, height)) + "  " +
            rows[std::size_t(y)] + "\n";
  return text;
}

Words words_of(std::uint64_t seed) {
  const ScanVariant v = scan_variant(seed);
  const auto truth = [](bool b) { return std::string(b ? "true" : "false"); };
  return {
      {"y_up", truth(v.y_up)},
      {"owns_left", truth(v.owns_left)},
      {"owns_top", truth(v.owns_top)},
      {"centre_256", std::to_string(v.centre())},
      {"centre", v.centres_at_integers ? "(i, j)" : "(i + 1/2, j + 1/2)"},
      {"centre in 1/256", v.centres_at_integers ? "(256 i, 256 j)" : "(256 i + 128, 256 j + 128)"},
      {"y", v.y_up ? "up" : "down"},
      {"row 0", v.y_up ? "at the bottom" : "on top"},
      {"rule", rule_of(v)},
      {"side", v.owns_left ? "left" : "right"},
      {"other side", v.owns_left ? "right" : "left"},
      {"end", v.owns_top ? "top" : "bottom"},
      {"beyond", v.owns_top ? "below" : "above"},
      {"example", example(v)}};
}

}  // namespace

Assignment a1_scan_conversion() {
  return {.id = "A1",
          .title = "Scan conversion",
          .folder = "A1_scan_conversion",
          .file = "scan_conversion.cpp",
          .header = "scan_conversion.h",
          .words = words_of,
          .illustrations =
              [](std::uint64_t seed) {
                const auto shown = [](const Framebuffer& f) { return judged("", "", f, f); };
                return std::map<std::string, JudgedPicture>{
                    {"before.png", shown(box_teapot())},
                    {"after.png", shown(right_teapot(scan_variant(seed)))}};
              },
          .parts = {{"A1.1", "Edge function", test_edge},
                    {"A1.2", "Fill rule", test_owns},
                    {"A1.3", "Coverage of a pixel", test_covers},
                    {"A1.4", "Spans", test_span},
                    {"A1.5", "Scan conversion", test_scan_convert},
                    {"A1.6", "The picture", test_picture}}};
}

}  // namespace scanlit::assignments
