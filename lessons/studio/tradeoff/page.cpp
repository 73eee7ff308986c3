#include "lessons/studio/tradeoff/page.h"

#include <fstream>

#include "lessons/studio/html.h"
#include "lessons/studio/tradeoff/answer.h"
#include "lessons/studio/tradeoff/study_scene.h"
#include "lessons/studio/tradeoff/tradeoff_panel.h"
#include "lessons/studio/tradeoff/tradeoff_plot.h"
#include "rasterizer/vector_level.h"

namespace scanlit::studio {
namespace {

/// The picture as a PNG file within the page.
std::string url_of(const ExactPicture& picture) {
  Framebuffer framebuffer(picture.width, picture.height);
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
    const Rgb<double>& c = picture.colour[i];
    float* const pixel = &framebuffer.colour[4 * i];
    pixel[0] = float(c.r), pixel[1] = float(c.g), pixel[2] = float(c.b), pixel[3] = 1;
  }
  return png_url(framebuffer);
}

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Run time over error</title><style>
body { font: 16px/1.45 "DejaVu Sans", Verdana, Arial, sans-serif; max-width: 1400px; margin: 24px auto;
       padding: 0 16px; }
svg { max-width: 100%; height: auto; }
.answer { font-size: 20px; font-weight: bold; margin: .3em 0; }
.pictures { display: flex; flex-wrap: wrap; gap: 16px; }
figure { margin: 0; padding: 6px; width: 320px; font-size: 13px; }
figure img { width: 100%; }
figure:target { outline: 4px solid #F5D76E; }
#shown { position: fixed; right: 16px; bottom: 16px; border: 2px solid #333; display: none; }
</style></head><body>
)";

// Without it, the page works by clicks alone.
constexpr const char* show_on_hover = R"(<img id="shown" alt=""><script>
const shown = document.getElementById("shown");
for (const link of document.querySelectorAll("svg a")) {
  link.onmouseenter = () => {
    shown.src = document.querySelector(link.getAttribute("href") + " img").src;
    shown.style.display = "block";
  };
  link.onmouseleave = () => shown.style.display = "none";
}
</script></body></html>
)";

std::string introduction() {
  return "<p>Each point is one way to draw a picture of " + std::to_string(study_width) + " x " +
         std::to_string(study_height) +
         " pixels: to the right it is farther from what it should be, higher up it takes longer. "
         "One thing is changed at a time; the default, in a ring, is " +
         std::string(study_shape) + ", Phong shading, " + study_model +
         ", two far lights, the engine's float vectors. On the Pareto front nothing is both faster "
         "and nearer to the truth. Beyond half a step rounding to 8 bits shows the error.</p>\n"
         "<p>Errors are those before rounding, clamped to what a screen shows, without silhouettes "
         "(pixels beside an edge of either picture), where a coarse mesh is not where the surface "
         "is. Times are medians, in processor time, of whole frames on one thread of " +
         machine() + ". Click on a point to see its picture.</p>\n";
}

}  // namespace

std::string machine() {
  std::ifstream info("/proc/cpuinfo");
  std::string name = "an unknown processor";
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name") && line.find(": ") != line.npos) {
      name = line.substr(line.find(": ") + 2);
      break;
    }
  return name + " (" + vector_level() + ")";
}

std::string tradeoff_page(const std::vector<AxisResult>& axes) {
  std::string page = std::string(head) + "<h1>Run time over error</h1>\n";
  for (const AxisResult& axis : axes)
    if (const auto found = answer(axis))
      page += "<p class=\"answer\">" + words(axis, *found) + "</p>\n";
  const std::string svg = plot_tradeoffs(axes);
  page += introduction() + svg.substr(svg.find("<svg"));  // the page has its own encoding
  for (const AxisResult& axis : axes) {
    page += "<h2>" + axis.title + "</h2>\n<div class=\"pictures\">\n";
    for (std::size_t i = 0; i < axis.points.size(); ++i)
      page += "<figure id=\"" + point_name(axis, i) + "\"><img loading=\"lazy\" alt=\"\" src=\"" +
              url_of(axis.points[i].picture) + "\"><figcaption>" + caption(axis.points[i]) +
              "</figcaption></figure>\n";
    page += "</div>\n";
  }
  return page + show_on_hover;
}

}  // namespace scanlit::studio
