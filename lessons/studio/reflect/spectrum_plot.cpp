// Why copper is red at normal incidence and white at grazing: a metal's Fresnel reflectance over
// wavelength, over the angle, and as the colour that is made of it.
#include <algorithm>
#include <cstdio>

#include "lessons/studio/reflect/metal_curves.h"
#include "lessons/studio/reflect/panel.h"
#include "lessons/studio/reflect/plots.h"
#include "rasterizer/error.h"

namespace scanlit::studio {
namespace {

using models::first_wavelength_nm, models::last_wavelength_nm;

constexpr double left = 96, panel_width = 500, gap = 104, right = 40;
constexpr double second_left = left + panel_width + gap, full_width = 2 * panel_width + gap;
constexpr double panel_height = 330, channels_height = 250;
constexpr double strip_height = 30, strips_height = 3 * strip_height;
constexpr double below_panel = 64;  // ticks and the axis' title
constexpr double legend_drop = 28;  // from a heading to its legend
const Stroke no_outline{"none", 0};

Axis wavelength_axis() {
  Axis axis{first_wavelength_nm, last_wavelength_nm, {}, "wavelength λ [nm]"};
  for (int nm = 400; nm <= 750; nm += 50) axis.ticks.emplace_back(nm, std::to_string(nm));
  return axis;
}

Axis incidence_axis() { return angle_axis(0, 90, 15, "angle of incidence θ"); }

void draw_heading(Svg& svg, PlotPoint at, const std::string& title, const LabelledCurves& curves,
                  double width) {
  svg.text(at, title, {.size = 16, .bold = true});
  draw_legend(svg, {at.x, at.y + legend_drop}, curves.legend, width);
}

/// The colours of light along the axis of wavelengths, at the panel's lower edge.
void draw_rainbow(Svg& svg, const Panel& panel) {
  for (double nm = first_wavelength_nm; nm <= last_wavelength_nm; nm += 5) {
    const PlotPoint low = panel.at(std::max(nm - 2.5, first_wavelength_nm), 0);
    const PlotPoint high = panel.at(last_wavelength_nm, 0);  // over the next ones: no seams
    svg.rectangle({low.x, low.y - 13}, {high.x, high.y - 1}, screen_colour(hue(nm)), no_outline);
  }
}

/// Where n and k were measured.
void draw_samples(Svg& svg, const Panel& panel, const models::Metal& metal, double angle_deg) {
  for (const models::OpticalConstants& m : metal.table) {
    if (m.wavelength_nm < first_wavelength_nm || m.wavelength_nm > last_wavelength_nm) continue;
    const PlotPoint p =
        panel.at(m.wavelength_nm, reflectance_at(metal, m.wavelength_nm, angle_deg));
    svg.rectangle({p.x - 3, p.y - 3}, {p.x + 3, p.y + 3}, "white", {"black", 1.3});
  }
}

/// In words, at the panel's lower left, where no metal's curves are: how far each curve falls.
void draw_dips(Svg& svg, const Panel& panel, const LabelledCurves& by_angle) {
  const PlotPoint at = panel.at(3, 0);
  for (std::size_t i = 0; i < by_angle.curves.size(); ++i) {
    const Curve& curve = by_angle.curves[i];
    const double first = curve.points.front().y;
    const PlotPoint low = lowest(curve);
    char text[100];
    if (first - low.y < 0.001)  // would show as the same number
      std::snprintf(text, sizeof text, "%.3f at 0°, falls by less than 0.001", first);
    else
      std::snprintf(text, sizeof text, "%.3f at 0°, lowest %.3f at %.0f°", first, low.y, low.x);
    svg.text({at.x, at.y - 10 - 17 * double(i)}, by_angle.legend[i].label + ": " + text,
             {.size = 13, .colour = curve.stroke.colour});
  }
}

void draw_strip(Svg& svg, PlotPoint at, const std::string& name, const ColourOverAngle& colour) {
  constexpr int steps = 180;
  for (int i = 0; i < steps; ++i)
    svg.rectangle({at.x + full_width * i / steps, at.y},
                  {at.x + full_width, at.y + strip_height},  // over the next ones: no seams
                  screen_colour(colour(90 * (i + 0.5) / steps)), no_outline);
  svg.text({at.x - 10, at.y + strip_height / 2 + 5}, name, {.size = 14, .anchor = "end"});
}

void draw_strips(Svg& svg, double top, const MetalColours& colours) {
  draw_strip(svg, {left, top}, "spectrum", colours.spectrum);
  draw_strip(svg, {left, top + strip_height}, "fit", colours.fit);
  draw_strip(svg, {left, top + 2 * strip_height}, "Schlick", colours.schlick);
  // A metal that is white at grazing would leave its end open.
  svg.rectangle({left, top}, {left + full_width, top + strips_height}, "none", {"#888888", 1});
}

void draw_channels(Svg& svg, double top, const LabelledCurves& channels) {
  double max = 1;
  for (const Curve& curve : channels.curves)
    for (const PlotPoint& p : curve.points) max = std::max(max, p.y);
  const Panel panel(svg, {left, top, full_width, channels_height}, incidence_axis(),
                    linear_axis(max, "F, linear sRGB"));
  panel.draw(channels.curves);
}

std::string explanation(const MetalColours& colours) {
  char text[200];
  std::snprintf(text, sizeof text,
                "spectrum: F summed over 380 to 780 nm. fit: what is rendered with, within %.5f of "
                "it. Schlick: F_0 + (1 − F_0)(1 − cos θ)⁵, with its F_0.",
                colours.fit_error + 5e-6);  // rounded up
  return text;
}

}  // namespace

std::string plot_spectrum(const PlotRequest& request) {
  if (request.models.size() != 1)
    throw Error("--plot", "spectrum wants one model, not " + std::to_string(request.models.size()));
  const models::Metal& metal = metal_of(request.models[0]);
  const MetalColours colours(metal);
  const std::vector<double>& angles_deg = request.light_angles_deg;
  const LabelledCurves a = curves_over_wavelength(metal, angles_deg), b = curves_over_angle(metal),
                       c = channels_over_angle(colours);

  const double first_head = 102;
  const double top =
      first_head + 22 +
      std::max(legend_height(a.legend, panel_width), legend_height(b.legend, panel_width));
  const double second_head = top + panel_height + below_panel + 28;
  const double strips_top = second_head + 22 + legend_height(c.legend, full_width);
  const double channels_top = strips_top + strips_height + 14;
  const double foot = channels_top + channels_height + below_panel + 16;
  const double width = left + full_width + right;

  const std::string title = "Fresnel reflectance of " + metal.name;
  Svg svg(width, foot + 20, title);
  svg.text({width / 2, 34}, title, {.size = 20, .anchor = "middle", .bold = true});
  svg.text({width / 2, 60},
           "Fresnel's equations for unpolarised light; n + ik measured at the squares by " +
               metal.source + ", linear between",
           {.size = 14, .anchor = "middle"});

  draw_heading(svg, {left, first_head}, "(a) over wavelength", a, panel_width);
  const Axis reflectance = linear_axis(1, "reflectance F");
  const Panel over_wavelength(svg, {left, top, panel_width, panel_height}, wavelength_axis(),
                              reflectance);
  draw_rainbow(svg, over_wavelength);
  over_wavelength.draw(a.curves);
  draw_samples(svg, over_wavelength, metal, angles_deg[0]);

  draw_heading(svg, {second_left, first_head}, "(b) over angle", b, panel_width);
  const Panel over_angle(svg, {second_left, top, panel_width, panel_height}, incidence_axis(),
                         reflectance);
  draw_dips(svg, over_angle, b);
  over_angle.draw(b.curves);

  draw_heading(svg, {left, second_head}, "(c) as a colour, under daylight (D65)", c, full_width);
  draw_strips(svg, strips_top, colours);
  draw_channels(svg, channels_top, c);
  svg.text({left + full_width / 2, foot}, explanation(colours),
           {.size = 13, .anchor = "middle", .colour = "#333333", .formula = true});
  return svg.finish();
}

}  // namespace scanlit::studio
