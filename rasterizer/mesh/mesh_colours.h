// Vertex colours: from a file's numbers to linear RGB.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "rasterizer/mesh/poly_mesh.h"

namespace scanlit::detail {

/// What a file's colours are counted in. No format says it; this is what programs write: whole
/// numbers are codes of the screen (sRGB), fractions are linear light.
enum class ColourCode { fraction, eight_bit, sixteen_bit };

/// Linear RGB, 0..1. A channel outside of what the code can hold is clamped, NaN taken for 0, and
/// the vertex counted in `repairs`.
std::vector<glm::vec3> linear_colours(const std::vector<glm::dvec3>& colours, ColourCode code,
                                      Repairs& repairs);

}  // namespace scanlit::detail
