// The question of every course: how many triangles does Gouraud shading need to be as right as
// Phong shading, and what does each cost?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lessons/studio/tradeoff/axes.h"

namespace scanlit::studio {

struct ShadingCost {
  double triangles, ms, steps;  // steps: as Measured::steps()
};

struct Answer {
  ShadingCost phong;  // the axis' default
  // Between the two measured meshes of which one is less and one is more right than Phong's, on
  // straight lines in logarithms. None where the finest is not as right.
  std::optional<ShadingCost> gouraud;
  ShadingCost finest_gouraud;
};

/// Of an axis with points of Phong (among them its default) and of Gouraud shading; else none.
std::optional<Answer> answer(const AxisResult& axis);

/// "teapot: Gouraud needs 31,000 triangles (2.4 ms) to be as right as Phong with 16,384 (1.9 ms)".
std::string words(const AxisResult& axis, const Answer& answer);

}  // namespace scanlit::studio
