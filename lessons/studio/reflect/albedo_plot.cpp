#include <algorithm>

#include "lessons/studio/reflect/panel.h"
#include "lessons/studio/reflect/plane_of_incidence.h"
#include "lessons/studio/reflect/query.h"
#include "models/albedo.h"

namespace scanlit::studio {
namespace {

constexpr double left = 96, panel_width = 720, panel_height = 430, right = 40;
constexpr double tolerance = 1e-4;  // a fifth of what could be seen

/// Denser towards grazing, where albedo changes fastest.
std::vector<Sample> albedo_over_angle(const ReflectionModel& model, double azimuth_deg) {
  std::vector<double> angles_deg;
  for (double angle = 0; angle < 80; angle += 2) angles_deg.push_back(angle);
  for (double angle = 80; angle < 88; angle += 1) angles_deg.push_back(angle);
  for (double angle = 88; angle < 89.9; angle += 0.25) angles_deg.push_back(angle);
  std::vector<Sample> samples;
  for (const double angle : angles_deg) {
    const Vec3<double> v = direction_at(angle, azimuth_deg);
    samples.push_back({angle, models::directional_albedo(model, v, tolerance, 2'000'000).value});
  }
  return samples;
}

}  // namespace

std::string plot_albedo(const PlotRequest& request) {
  SampleTable samples;
  for (const models::NamedModel& named : request.models)
    samples.push_back({albedo_over_angle(*named.model, request.azimuth_deg)});
  const CurveSet set = make_curves(request.models, {}, samples);
  const std::string title = heading(request, "Directional albedo");

  const double legend_top = 92, top = legend_top + legend_height(set.legend, panel_width) + 12;
  const double width = left + panel_width + right;
  Svg svg(width, top + panel_height + 64, "Directional albedo of " + title);
  svg.text({width / 2, 34}, title, {.size = 19, .anchor = "middle", .bold = true});
  std::string remark = "share of the light from every side that is reflected to the viewer";
  if (set.of_colour && !set.channels_apart) remark += ", luminance";
  svg.text({width / 2, 60}, remark, {.size = 14, .anchor = "middle"});
  draw_legend(svg, {left, legend_top}, set.legend, panel_width);

  const Panel panel(svg, {left, top, panel_width, panel_height},
                    angle_axis(0, 90, 15, "viewing angle θ_v"),
                    linear_axis(std::max(1.1, set.max), "directional albedo"));
  // Above it a surface gives back more light than it gets.
  svg.line(panel.at(0, 1), panel.at(90, 1), {"#444444", 1.4, "7 5"});
  const PlotPoint end = panel.at(90, 1);
  svg.text({end.x - 10, end.y - 7}, "a perfect white",
           {.size = 13, .anchor = "end", .colour = "#444444"});
  panel.draw(set.curves);
  return svg.finish();
}

}  // namespace scanlit::studio
