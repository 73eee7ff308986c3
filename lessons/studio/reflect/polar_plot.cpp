#include <algorithm>
#include <cmath>

#include "lessons/studio/reflect/plane_of_incidence.h"
#include "lessons/studio/reflect/query.h"
#include "lessons/studio/reflect/ticks.h"
#include "lessons/studio/text.h"

namespace scanlit::studio {
namespace {

constexpr double width = 900, radius = 370, margin = 80;
constexpr double legend_width = width - 2 * margin;
constexpr double below = 78;  // of the surface: its hatching, the radial ticks, the axis' title
const Stroke grid{"#CCCCCC", 1}, rays{"#DDDDDD", 1}, axis{"black", 1.4};
const Stroke light_stroke{"#333333", 2}, mirror_stroke{"#555555", 1.2, "5 4"};

/// The half disc over the surface; angles are viewing angles, negative on the left.
class HalfDisc {
 public:
  HalfDisc(Svg& svg, PlotPoint centre, std::vector<double> ticks)
      : svg_(svg), centre_(centre), ticks_(std::move(ticks)) {}

  PlotPoint at(double view_deg, double r) const {
    const double angle = radians_of(view_deg);
    return {centre_.x + r * std::sin(angle), centre_.y - r * std::cos(angle)};
  }
  double pixels(double value) const { return radius * value / ticks_.back(); }

  void draw_grid(const std::string& title) const {
    for (int deg = -75; deg <= 75; deg += 15) svg_.line(centre_, at(deg, radius), rays);
    for (const double tick : ticks_)
      if (tick > 0) svg_.arc(centre_, pixels(tick), 0, 180, grid);
    svg_.arc(centre_, radius, 0, 180, {"#888888", 1});
    for (int deg = -90; deg <= 90; deg += 15) {
      const PlotPoint p = at(deg, radius + (deg == 0 ? 8 : 14));
      const std::string side = deg < 0 ? "end" : deg > 0 ? "start" : "middle";
      svg_.text({p.x, p.y + (std::abs(deg) > 60 ? 5 : 0)}, std::to_string(std::abs(deg)) + "°",
                {.size = 14, .anchor = side});
    }
    for (double x = -radius; x < radius; x += 12)  // the body under the surface
      svg_.line({centre_.x + x, centre_.y + 9}, {centre_.x + x + 9, centre_.y}, {"#999999", 1});
    svg_.line(at(-90, radius), at(90, radius), {"black", 2});
    svg_.line(centre_, at(0, radius), {"#888888", 1.2, "2 3"});
    for (const double tick : ticks_) {
      const PlotPoint p{centre_.x + pixels(tick), centre_.y};
      svg_.line(p, {p.x, p.y + 12}, axis);
      svg_.text({p.x, p.y + 29}, tick_text(tick), {.size = 14, .anchor = "middle"});
    }
    svg_.text({centre_.x + radius / 2, centre_.y + 54}, title,
              {.size = 15, .anchor = "middle", .formula = true});
    svg_.text({centre_.x - radius / 2, centre_.y + 33}, "viewing angle θ_v from the normal",
              {.size = 14, .anchor = "middle", .formula = true});
    svg_.text({centre_.x - radius / 2, centre_.y + 54}, "← towards the light | away from it →",
              {.size = 13, .anchor = "middle", .colour = "#555555"});
  }

  void draw_light(double light_deg) const {
    svg_.line(centre_, at(light_deg, radius), mirror_stroke);
    svg_.arrow(at(-light_deg, radius), at(-light_deg, 4), light_stroke);
    const PlotPoint l = at(-light_deg - 2.6, 0.93 * radius), r = at(light_deg + 2.2, 0.93 * radius);
    svg_.text({l.x, l.y}, "L", {.size = 16, .anchor = "middle", .bold = true});
    svg_.text({r.x, r.y}, "R", {.size = 15, .anchor = "middle", .colour = "#555555"});
  }

  void draw_curve(Curve curve) const {
    for (PlotPoint& p : curve.points) p = at(p.x, pixels(p.y));
    // From the origin and back to it: a lobe is a closed line where it does not reach the horizon.
    svg_.curve(curve.points, curve.stroke);
  }

 private:
  Svg& svg_;
  PlotPoint centre_;
  std::vector<double> ticks_;
};

}  // namespace

std::string plot_polar(const PlotRequest& request) {
  const std::vector<double> ticks = round_ticks(largest_value(request), 4);
  const auto samples = sample_lobes(request, [&](double value) { return value / ticks.back(); });
  const CurveSet set = make_curves(request.models, request.light_angles_deg, samples);
  const std::string title = heading(request, "Lobes"), remark = remarks(request, set);

  const double top = 44 + (remark.empty() ? 0 : 24);
  const double disc_top = top + 20 + legend_height(set.legend, legend_width) + 24;
  const PlotPoint centre{width / 2, disc_top + radius};
  Svg svg(width, centre.y + below, "Polar plot of " + title);
  svg.text({width / 2, 34}, title, {.size = 19, .anchor = "middle", .bold = true});
  svg.text({width / 2, 60}, remark, {.size = 14, .anchor = "middle", .formula = true});
  draw_legend(svg, {margin, top + 24}, set.legend, legend_width);

  const HalfDisc disc(svg, centre, ticks);
  disc.draw_grid(quantity_title(request));
  for (const Curve& curve : set.curves) disc.draw_curve(curve);
  for (const double light_deg : request.light_angles_deg) disc.draw_light(light_deg);
  return svg.finish();
}

}  // namespace scanlit::studio
