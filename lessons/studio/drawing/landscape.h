// A function of two variables as a landscape, seen from above one of its corners.
#pragma once

#include <functional>

#include "lessons/studio/drawing/chart.h"

namespace scanlit::studio {

struct Landscape {
  ChartAxis x;  // grows to the right
  ChartAxis y;  // grows away from the viewer
  ChartAxis z;  // grows upwards
  std::function<double(double x, double y)> height;
  std::function<Rgb<double>(double x, double y)> colour;
};

/// With ticks and titles; words as for a picture of sheet_height pixels.
Framebuffer draw(const Landscape& landscape, int width, int height, int sheet_height);

}  // namespace scanlit::studio
