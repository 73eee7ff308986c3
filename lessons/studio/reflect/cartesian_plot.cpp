#include <algorithm>
#include <cmath>

#include "lessons/studio/reflect/panel.h"
#include "lessons/studio/reflect/plane_of_incidence.h"

namespace scanlit::studio {
namespace {

constexpr double panel_width = 620, panel_height = 400, left = 96, gap = 110, right = 30;

/// Powers of ten from the largest value to the least, but no more than can be told apart.
int decades_of(double max, double least) {
  return int(std::clamp(std::ceil(std::log10(max)) - std::floor(std::log10(least)), 2.0, 6.0));
}

void draw_panel(Svg& svg, const PanelPlace& place, const Axis& y, const PlotRequest& request) {
  const auto samples = sample_lobes(request, [&](double value) { return y.place(value); });
  const CurveSet set = make_curves(request.models, request.light_angles_deg, samples);
  const Panel panel(svg, place, angle_axis(-90, 90, 30, "viewing angle θ_v (the light is at −θ_l)"),
                    y);
  for (const double light_deg : request.light_angles_deg) {
    panel.mark(-light_deg, "L", {"#333333", 1.2});
    panel.mark(light_deg, light_deg == 0 ? "" : "R", {"#777777", 1, "5 4"});
  }
  panel.draw(set.curves);
}

}  // namespace

std::string plot_cartesian(const PlotRequest& request) {
  const double max = largest_value(request);
  const auto samples = sample_lobes(request, [](double) { return 0.0; });
  const CurveSet set = make_curves(request.models, request.light_angles_deg, samples);
  const std::string title = heading(request, "Lobes"), remark = remarks(request, set);

  const int panels = request.logarithmic ? 2 : 1;
  const double width = left + panels * panel_width + (panels - 1) * gap + right;
  const double legend_top = remark.empty() ? 68 : 92;
  const double top = legend_top + legend_height(set.legend, width - left - right) + 18;
  Svg svg(width, top + panel_height + 64, "Plot of " + title);
  svg.text({width / 2, 34}, title, {.size = 19, .anchor = "middle", .bold = true});
  svg.text({width / 2, 60}, remark, {.size = 14, .anchor = "middle", .formula = true});
  draw_legend(svg, {left, legend_top}, set.legend, width - left - right);

  const std::string quantity = quantity_title(request);
  draw_panel(svg, {left, top, panel_width, panel_height}, linear_axis(max, quantity), request);
  if (request.logarithmic)
    draw_panel(svg, {left + panel_width + gap, top, panel_width, panel_height},
               logarithmic_axis(max, decades_of(max, set.least), quantity), request);
  return svg.finish();
}

}  // namespace scanlit::studio
