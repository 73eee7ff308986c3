#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "rasterizer/image.h"
#include "tests/golden/golden.h"

namespace scanlit::golden {
namespace {

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) {
    if (c == '<')
      html += "&lt;";
    else if (c == '&')
      html += "&amp;";
    else
      html += c;
  }
  return html;
}

// The largest difference of colour becomes white; magenta where what must be equal to the bit
// (coverage, depth, ids) is not.
Framebuffer amplified_difference(const Framebuffer& actual, const Framebuffer& expected,
                                 float factor) {
  Framebuffer difference(actual.width, actual.height);
  const auto differ = [](const auto& a, const auto& b, std::size_t i) {
    return i < a.size() && i < b.size() && a[i] != b[i];
  };
  for (std::size_t i = 0; i < difference.pixel_count(); ++i) {
    float* out = &difference.colour[4 * i];
    for (std::size_t c = 0; c < 3; ++c)
      out[c] = factor * std::abs(actual.colour[4 * i + c] - expected.colour[4 * i + c]);
    if (differ(actual.colour, expected.colour, 4 * i + 3) ||
        differ(actual.depth, expected.depth, i) ||
        differ(actual.object_id, expected.object_id, i) ||
        differ(actual.triangle_id, expected.triangle_id, i)) {
      out[0] = out[2] = 1;
      out[1] = 0;
    }
  }
  return difference;
}

std::string picture(const std::filesystem::path& folder, const std::string& file,
                    const std::string& caption, const Framebuffer& framebuffer) {
  write_image(folder / file, framebuffer);
  return "<figure><img src=\"" + file + "\" width=\"" + std::to_string(2 * framebuffer.width) +
         "\" alt=\"" + caption + "\"><figcaption>" + caption + "</figcaption></figure>\n";
}

std::string pictures(const std::filesystem::path& folder, const Result& result) {
  std::string html;
  const std::string file = result.name + "-";
  if (result.actual) html += picture(folder, file + "actual.png", "actual", *result.actual);
  if (result.expected) html += picture(folder, file + "expected.png", "expected", *result.expected);
  if (result.comparison.colour) {
    const double max = result.comparison.colour->max;
    const float factor = max > 0 && std::isfinite(max) ? float(1 / max) : 1;
    std::ostringstream caption;
    caption << "difference, " << factor << " times";
    html += picture(folder, file + "difference.png", caption.str(),
                    amplified_difference(*result.actual, *result.expected, factor));
  }
  return html;
}

std::string section(const std::filesystem::path& folder, const Result& result) {
  std::ostringstream html;
  html << "<section class=\"" << (result.passed() ? "passed" : "failed") << "\" id=\""
       << result.name << "\">\n<h2>" << result.name << (result.passed() ? " passed" : " failed")
       << "</h2>\n";
  for (const std::string& problem : result.comparison.problems)
    html << "<p class=\"problem\">" << escaped(problem) << "</p>\n";
  if (!result.passed())
    html << "<p>To accept the new picture: <code>tests/bless " << result.name << "</code></p>\n";
  html << pictures(folder, result);
  const Tolerance& tolerance = result.tolerance;
  if (const auto& difference = result.comparison.colour)
    html << "<p>Colour differs by max " << difference->max << ", mean " << difference->mean
         << ", RMS " << difference->rms << "; " << difference->pixels
         << " pixels beyond the tolerance of " << tolerance.absolute << " or "
         << 100 * tolerance.relative << " %, where " << tolerance.pixels << " may be ("
         << escaped(tolerance.reason) << ").</p>\n";
  html << "</section>\n";
  return html.str();
}

constexpr const char* page_head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Golden images</title><style>
body { font-family: sans-serif; margin: 2em; background: #f4f4f4; color: #222; }
section { background: #fff; margin: 1em 0; padding: .5em 1em; border-left: .5em solid #3a3; }
section.failed { border-color: #c22; }
.problem { color: #c22; font-weight: bold; }
figure { display: inline-block; margin: 0 1em 0 0; }
img { image-rendering: pixelated; background: #000; display: block; }
code { background: #eee; padding: .2em .5em; }
</style></head><body>
<h1>Golden images</h1>
)";

}  // namespace

void write_report(const std::filesystem::path& folder, const std::vector<Result>& results) {
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  std::vector<const Result*> in_order;
  for (const Result& result : results) in_order.push_back(&result);
  const auto passed =
      std::ranges::stable_partition(in_order, [](const Result* r) { return !r->passed(); });
  std::ofstream page(folder / "index.html");
  page << page_head << "<p>" << results.size() - passed.size() << " failed, " << passed.size()
       << " passed.</p>\n";
  for (const Result* result : in_order) page << section(folder, *result);
  page << "</body></html>\n";
}

}  // namespace scanlit::golden
