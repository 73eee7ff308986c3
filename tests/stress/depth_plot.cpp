#include <cmath>
#include <cstdint>
#include <functional>

#include "lessons/studio/reflect/panel.h"
#include "tests/stress/plots.h"
#include "tests/unit/test_scene.h"

namespace scanlit::stress {

namespace {

using studio::PlotPoint;

// Distances in units of the near plane's.
constexpr double far = 1e6;

/// A way of storing depth.
struct Format {
  std::string name;
  studio::Stroke stroke;
  std::function<double(double)> next;  // the distance whose stored depth follows that of `distance`
};

/// 1 / w, from 1 at near to 0 at infinity, in float: the engine's.
double next_reversed(double distance) {
  const float depth = float(1 / distance);
  return distance * double(depth) / double(std::nextafter(depth, 0.0f));
}
double forward(double distance) { return far / (far - 1) * (1 - 1 / distance); }
/// Beyond far there is nothing: the curve ends.
double distance_of_forward(double depth) {
  return depth <= 1 ? 1 / (1 - depth * (far - 1) / far) : std::nan("");
}
double next_forward(double distance) {
  const float depth = float(forward(distance));
  return distance * distance_of_forward(double(std::nextafter(depth, 2.0f))) /
         distance_of_forward(double(depth));
}
/// Whole numbers of so many bits, forward.
double next_fixed(double distance, int bits) {
  return distance_of_forward(forward(distance) + std::exp2(-bits));
}

const std::vector<Format>& formats() {
  static const std::vector<Format> all = {
      {"float, 1 at near to 0 at infinity (Scanlit)", {"#0072B2", 3}, next_reversed},
      {"float, 0 at near to 1 at far", {"#D55E00", 2.2}, next_forward},
      {"24 bits, 0 at near to 1 at far",
       {"#009E73", 2.2, "8 4"},
       [](double d) { return next_fixed(d, 24); }},
      {"16 bits, 0 at near to 1 at far",
       {"#CC79A7", 2.2, "8 4"},
       [](double d) { return next_fixed(d, 16); }},
      {"24 bits, linear in the distance", {"#777777", 2.2, "2 3"}, [](double d) {
         return d + far * 0x1p-24;
       }}};
  return all;
}

/// The least 2^-k, all coarser ones included, by which a square that faces the camera must be
/// nearer than another to be seen before it at every pixel.
double measured_threshold(double distance) {
  const auto nearer_is_seen = [&](double e) {
    std::vector<glm::vec3> corners;
    for (const double d : {distance * (1 + e), distance}) {
      const auto r = float(2 * d), z = float(-d);
      corners.insert(corners.end(), {{-r, -r, z}, {r, r, z}, {r, -r, z}});
    }
    const auto picture =
        test::picture_of(test::scene_of({test::object_of(test::triangle_soup(corners))}),
                         test::eye_at_origin(1), 8, 8);
    for (const std::uint32_t id : picture.framebuffer.triangle_id)
      if (id == 0) return false;
    return true;
  };
  int bits = 10;
  while (bits < 30 && nearer_is_seen(std::exp2(-bits - 1))) ++bits;
  return std::exp2(-bits);
}

}  // namespace

std::string plot_depth() {
  constexpr double left = 110, top = 190, width = 760, height = 460;
  studio::Svg svg(left + width + 40, top + height + 64, "Plot of depth precision over distance");
  svg.text({(left + width + 40) / 2, 34}, "What depth can tell apart",
           {.size = 19, .anchor = "middle", .bold = true});
  std::vector<studio::LegendEntry> legend;
  std::vector<studio::Curve> curves;
  for (const Format& format : formats()) {
    legend.push_back({format.name, format.stroke});
    studio::Curve& curve = curves.emplace_back(studio::Curve{format.stroke, {}});
    // The upper rim of the staircase: the largest step in the neighbourhood.
    for (double decade = 0.02; decade < 5.99; decade += 0.02) {
      double step = 0;
      for (int i = 0; i < 40; ++i) {
        const double d = std::pow(10.0, decade + 0.0005 * i), here = format.next(d) / d - 1;
        step = std::isnan(here) || std::isnan(step) ? std::nan("") : std::max(step, here);
      }
      if (std::isnan(step)) break;
      curve.points.push_back({std::pow(10.0, decade), step});
    }
  }
  legend.push_back(
      {"circles: from there on Scanlit is measured to draw two squares right", {"black", 1.6}});
  studio::draw_legend(svg, {left, 60}, legend, width);
  const studio::Panel panel(svg, {left, top, width, height},
                            studio::logarithmic_axis(far, 6, "distance / near"),
                            studio::logarithmic_axis(1, 9, "least step / distance"));
  panel.draw(curves);
  for (double decade = 0; decade < 5.9; decade += 0.3) {
    double worst = 0;  // one pair may be lucky
    for (int i = 0; i < 16; ++i)
      worst = std::max(worst, measured_threshold(std::pow(10.0, decade + 0.017 * i)));
    const PlotPoint at = panel.at(std::pow(10.0, decade + 0.15), worst);
    for (const double half : {0.0, 180.0}) svg.arc(at, 4, half, half + 180, {"black", 1.6});
  }
  return svg.finish();
}

}  // namespace scanlit::stress
