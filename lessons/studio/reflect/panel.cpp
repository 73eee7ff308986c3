#include "lessons/studio/reflect/panel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lessons/studio/reflect/ticks.h"

namespace scanlit::studio {

double Axis::place(double value) const {
  if (!logarithmic) return (value - low) / (high - low);
  // Far below the axis, but a number: a curve that goes to 0 leaves the panel downwards.
  if (!(value > 0)) return -1;
  return std::max(-1.0, std::log(value / low) / std::log(high / low));
}

Axis angle_axis(double low_deg, double high_deg, int step_deg, const std::string& title) {
  Axis axis{low_deg, high_deg, {}, title};
  for (int deg = int(low_deg); deg <= high_deg; deg += step_deg)
    axis.ticks.emplace_back(deg, (deg < 0 ? "−" : "") + std::to_string(std::abs(deg)) + "°");
  return axis;
}

Axis linear_axis(double max, const std::string& title) {
  Axis axis{0, 1, {}, title};
  for (const double tick : round_ticks(max, 5)) axis.ticks.emplace_back(tick, tick_text(tick));
  axis.high = axis.ticks.back().first;
  return axis;
}

Axis logarithmic_axis(double max, int decades, const std::string& title) {
  const int top = int(std::ceil(std::log10(max) - 1e-9));
  Axis axis{std::pow(10.0, top - decades), std::pow(10.0, top), {}, title, true};
  for (int exponent = top - decades; exponent <= top; ++exponent)
    axis.ticks.emplace_back(std::pow(10.0, exponent), power_of_ten(exponent));
  return axis;
}

Panel::Panel(Svg& svg, const PanelPlace& place, Axis x, Axis y)
    : svg_(svg), place_(place), x_(std::move(x)), y_(std::move(y)) {
  const Stroke grid{"#DDDDDD", 1}, axis{"black", 1.4};
  const double bottom = place.top + place.height, right = place.left + place.width;
  for (const auto& [value, label] : x_.ticks) {
    const double px = at(value, y_.low).x;
    svg.line({px, place.top}, {px, bottom}, grid);
    svg.line({px, bottom}, {px, bottom + 6}, axis);
    svg.text({px, bottom + 22}, label, {.size = 14, .anchor = "middle"});
  }
  for (const auto& [value, label] : y_.ticks) {
    const double py = at(x_.low, value).y;
    svg.line({place.left, py}, {right, py}, grid);
    svg.line({place.left - 6, py}, {place.left, py}, axis);
    svg.text({place.left - 10, py + 5}, label, {.size = 14, .anchor = "end"});
  }
  svg.rectangle({place.left, place.top}, {right, bottom}, "none", axis);
  svg.text({place.left + place.width / 2, bottom + 46}, x_.title,
           {.size = 15, .anchor = "middle", .formula = true});
  svg.text({place.left - 56, place.top + place.height / 2}, y_.title,
           {.size = 15, .anchor = "middle", .turned_deg = -90, .formula = true});
}

PlotPoint Panel::at(double x, double y) const {
  return {place_.left + place_.width * x_.place(x), place_.top + place_.height * (1 - y_.place(y))};
}

void Panel::draw(const std::vector<Curve>& curves) const {
  svg_.begin_clip({place_.left, place_.top - 2},
                  {place_.left + place_.width, place_.top + place_.height + 2});
  for (Curve curve : curves) {
    for (PlotPoint& p : curve.points) p = at(p.x, p.y);
    svg_.curve(curve.points, curve.stroke);
  }
  svg_.end_clip();
}

void Panel::mark(double x, const std::string& word, const Stroke& stroke) const {
  const double px = at(x, y_.low).x;
  svg_.line({px, place_.top}, {px, place_.top + place_.height}, stroke);
  svg_.text({px, place_.top - 7}, word, {.size = 14, .anchor = "middle", .colour = stroke.colour});
}

}  // namespace scanlit::studio
