// One axis of `scanlit tradeoff` in one panel: its points, the curves they lie on, their labels.
#pragma once

#include <string>
#include <vector>

#include "lessons/studio/reflect/panel.h"
#include "lessons/studio/tradeoff/axes.h"

namespace scanlit::studio {

using Value = double (*)(const Measured&);

class TradeoffPanel {
 public:
  static constexpr double cell_width = 700,
                          cell_height = 520;  // what a panel takes with its titles

  /// Both axes are logarithmic.
  TradeoffPanel(Svg& svg, const AxisResult& axis, PlotPoint cell, const std::string& title, Value x,
                const std::string& x_title, Value y, const std::string& y_title);

  PlotPoint at(double x, double y) const { return panel_.at(x, y); }
  const PanelPlace& place() const { return place_; }

  /// A line at a value of x, where it is in the panel.
  void mark(double x, const std::string& word) const;
  /// Steps from point to point: what can be had lies above them and to the right.
  void draw_front() const;
  void draw_curves() const;
  /// Each leads to point_name() in the page.
  void draw_points() const;
  /// Of every point, or of each curve's ends and of the default.
  void draw_labels(bool all) const;
  void draw_legend(bool with_front) const;

 private:
  PlotPoint at(const Measured& p) const { return at(x_(p), y_(p)); }

  Svg& svg_;
  const AxisResult& axis_;
  PanelPlace place_;
  Axis x_axis_;
  Panel panel_;
  Value x_, y_;
  std::vector<std::string> series_;
};

/// "teapot-12": the axis' point of this number.
std::string point_name(const AxisResult& axis, std::size_t point);

/// What the page, and the pointer, say of a point: "Phong, 4,096 triangles: 1.21 ms; ...".
std::string caption(const Measured& point);

}  // namespace scanlit::studio
