// A chart: two axes, grid, ticks, and curves whose names stand beside them.
#pragma once

#include "lessons/studio/drawing/canvas.h"

namespace scanlit::studio {

struct ChartAxis {
  double low, high;
  std::string title;
  bool logarithmic = false;  // low and high above 0; ticks at powers of ten

  /// 0 at `low`, 1 at `high`.
  double place(double value) const;
};

class Chart {
 public:
  /// Words as for a picture of sheet_height pixels; 0: of the chart's own.
  Chart(int width, int height, ChartAxis x, ChartAxis y, int sheet_height = 0);

  void curve(const std::vector<glm::dvec2>& values, const Rgb<double>& colour, double width = 7);
  void dot(glm::dvec2 value, const Rgb<double>& colour, double radius = 9);
  void line(glm::dvec2 a, glm::dvec2 b, const Rgb<double>& colour, double width = 4);
  void words(glm::dvec2 value, const std::string& words, const Rgb<double>& colour,
             Align align = Align::left);
  Framebuffer finish() { return canvas_.finish(); }

 private:
  glm::dvec2 at(glm::dvec2 value) const;

  Canvas canvas_;
  ChartAxis x_, y_;
  glm::dvec2 low_, high_;  // pixels: the corners at the axes' low ends and high ends
};

}  // namespace scanlit::studio
