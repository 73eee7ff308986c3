// The plots of `scanlit tradeoff`, in one drawing.
#pragma once

#include <string>
#include <vector>

#include "lessons/studio/tradeoff/axes.h"

namespace scanlit::studio {

/// SVG text: for each axis time over error, and, where it answers the question of Gouraud and Phong
/// shading, error over triangles before it.
std::string plot_tradeoffs(const std::vector<AxisResult>& axes);

}  // namespace scanlit::studio
