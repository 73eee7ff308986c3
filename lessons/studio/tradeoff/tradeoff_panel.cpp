#include "lessons/studio/tradeoff/tradeoff_panel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lessons/studio/reflect/ticks.h"
#include "lessons/studio/text.h"
#include "lessons/studio/tradeoff/label_places.h"

namespace scanlit::studio {
namespace {

constexpr double left = 96, top = 94, panel_width = 560, panel_height = 348;
constexpr double marker_radius = 5.5, ring_radius = 10.5, label_size = 13;

/// How a series is drawn: colours that the colour-blind tell apart (Okabe and Ito 2008), and shapes
/// besides.
struct Style {
  const char* series;
  const char* colour;
  Marker marker;
};
constexpr Style styles[] = {{"flat", "#666666", Marker::square},
                            {"Gouraud", "#D55E00", Marker::triangle},
                            {"Phong", "#0072B2", Marker::circle},
                            {"textbook renderer", "#CC79A7", Marker::diamond},
                            {"the engine", "#0072B2", Marker::circle}};
constexpr const char* front_colour = "#F5D76E";

const Style& style_of(const std::string& series) {
  const auto found = std::ranges::find(styles, series, &Style::series);
  return found != std::end(styles) ? *found : styles[0];
}

/// 1, 2, 5 times powers of ten, or over many decades powers alone, around all values.
Axis axis_around(const std::vector<double>& values, const std::string& title) {
  const auto [least, most] = std::ranges::minmax(values);
  const bool decades = most / least > 300;
  Axis axis{0, 0, {}, title, true};
  const double low = least / 1.15, high = most * 1.15;
  for (int exponent = int(std::floor(std::log10(low))) - 1;; ++exponent)
    for (const double digit : {1.0, 2.0, 5.0}) {
      if (decades && digit > 1) continue;
      const double tick = digit * std::pow(10.0, exponent);
      if (tick <= low) axis.low = tick, axis.ticks.clear();
      axis.ticks.emplace_back(tick, decades ? power_of_ten(exponent) : tick_text(tick));
      if (tick < high) continue;
      axis.high = tick;
      return axis;
    }
}

std::vector<double> values_of(const AxisResult& axis, Value value) {
  std::vector<double> result;
  for (const Measured& point : axis.points) result.push_back(value(point));
  return result;
}

/// "4,060", "131k", "1.0M".
std::string short_count(std::int64_t count) {
  if (count < 10000) return grouped(count);
  if (count < 1000000) return std::to_string((count + 500) / 1000) + "k";
  return fixed(double(count) / 1e6, 1) + "M";
}

}  // namespace

TradeoffPanel::TradeoffPanel(Svg& svg, const AxisResult& axis, PlotPoint cell,
                             const std::string& title, Value x, const std::string& x_title, Value y,
                             const std::string& y_title)
    : svg_(svg),
      axis_(axis),
      place_{cell.x + left, cell.y + top, panel_width, panel_height},
      x_axis_(axis_around(values_of(axis, x), x_title)),
      panel_(svg, place_, x_axis_, axis_around(values_of(axis, y), y_title)),
      x_(x),
      y_(y) {
  svg.text({place_.left, cell.y + 28}, title, {.size = 18, .bold = true});
  for (const Measured& p : axis.points)
    if (std::ranges::find(series_, p.series) == series_.end()) series_.push_back(p.series);
}

void TradeoffPanel::mark(double x, const std::string& word) const {
  if (x > x_axis_.low && x < x_axis_.high) panel_.mark(x, word, {"#777777", 1, "5 4"});
}

void TradeoffPanel::draw_front() const {
  std::vector<const Measured*> points;
  for (const Measured& p : axis_.points)
    if (p.pareto) points.push_back(&p);
  std::ranges::sort(points, {}, &Measured::steps);
  std::vector<PlotPoint> line;
  for (const Measured* p : points) {
    if (!line.empty()) line.push_back({at(*p).x, line.back().y});
    line.push_back(at(*p));
  }
  svg_.curve(line, {front_colour, 7});
}

void TradeoffPanel::draw_curves() const {
  for (const std::string& series : series_) {
    std::vector<PlotPoint> line;
    for (const Measured& p : axis_.points)
      if (p.series == series) line.push_back(at(p));
    svg_.curve(line, {style_of(series).colour, 1.2});
  }
}

void TradeoffPanel::draw_points() const {
  for (std::size_t i = 0; i < axis_.points.size(); ++i) {
    const Measured& p = axis_.points[i];
    const Style& style = style_of(p.series);
    svg_.begin_link(point_name(axis_, i), caption(p));
    if (p.is_default) svg_.marker(at(p), Marker::circle, ring_radius, "none", {"black", 1.6});
    svg_.marker(at(p), style.marker, marker_radius, style.colour, {"white", 1});
    svg_.end_link();
  }
}

void TradeoffPanel::draw_labels(bool all) const {
  LabelPlaces places(place_, label_size);
  for (const Measured& p : axis_.points)
    places.keep_free(at(p), p.is_default ? ring_radius : marker_radius + 1);
  const auto label = [&](const Measured& p, const std::string& text) {
    const PlacedLabel l =
        places.place(at(p), text, p.is_default ? ring_radius + 3 : marker_radius + 4);
    svg_.text(l.at, text, {.size = label_size, .anchor = l.anchor, .halo = true});
  };
  for (const std::string& series : series_) {
    std::vector<const Measured*> of_series;
    for (const Measured& p : axis_.points)
      if (p.series == series) of_series.push_back(&p);
    for (const Measured* p : of_series)
      if (all)
        label(*p, p->label);
      else if (p == of_series.front() || p == of_series.back() || p->is_default)
        label(*p, short_count(p->triangles));
  }
}

void TradeoffPanel::draw_legend(bool with_front) const {
  double x = place_.left;
  const double y = place_.top - 40;
  const auto entry = [&](const std::string& text, const auto& draw) {
    draw(PlotPoint{x + 8, y});
    svg_.text({x + 22, y + 5}, text, {.size = 14});
    x += 44 + 8.6 * double(text.size());
  };
  for (const std::string& series : series_)
    entry(series, [&](PlotPoint p) {
      svg_.marker(p, style_of(series).marker, marker_radius, style_of(series).colour, {"white", 1});
    });
  entry("default", [&](PlotPoint p) {
    svg_.marker(p, Marker::circle, marker_radius + 2, "none", {"black", 1.6});
  });
  if (with_front)
    entry("Pareto front", [&](PlotPoint p) {
      svg_.line({p.x - 9, p.y}, {p.x + 9, p.y}, {front_colour, 7});
    });
}

std::string point_name(const AxisResult& axis, std::size_t point) {
  return axis.name + "-" + std::to_string(point);
}

std::string caption(const Measured& p) {
  char text[200];
  std::snprintf(text, sizeof text, "%.3g ms; rms %.3g, largest %.3g steps; mean FLIP %.2g", p.ms,
                p.steps(), p.error.interior.max_steps, p.flip);
  return p.series + ", " + p.label + ": " + text;
}

}  // namespace scanlit::studio
