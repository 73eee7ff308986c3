// A panel with two straight axes and curves in it.
#pragma once

#include "lessons/studio/reflect/curves.h"

namespace scanlit::studio {

struct Axis {
  double low, high;
  std::vector<std::pair<double, std::string>> ticks;
  std::string title;  // "f_r": a subscript
  bool logarithmic = false;

  /// Where on the axis a value lies, 0 at `low` and 1 at `high`; below 0 where a logarithm is not.
  double place(double value) const;
};

/// Ticks each `step` degrees.
Axis angle_axis(double low_deg, double high_deg, int step_deg, const std::string& title);
/// 0 to at least `max`.
Axis linear_axis(double max, const std::string& title);
/// Down from at least `max` by so many powers of ten.
Axis logarithmic_axis(double max, int decades, const std::string& title);

/// Where a panel's axes are, in pixels.
struct PanelPlace {
  double left, top, width, height;
};

class Panel {
 public:
  /// Draws grid, ticks and titles.
  Panel(Svg& svg, const PanelPlace& place, Axis x, Axis y);
  PlotPoint at(double x, double y) const;
  void draw(const std::vector<Curve>& curves) const;
  /// A line over the whole height, with a word at its upper end.
  void mark(double x, const std::string& word, const Stroke& stroke) const;

 private:
  Svg& svg_;
  PanelPlace place_;
  Axis x_, y_;
};

}  // namespace scanlit::studio
