// The Utah teapot.
#pragma once

#include <glm/vec3.hpp>

namespace scanlit::detail {

/// Martin Newell's 32 bicubic Bezier patches (1975) as published, each a net of 4 x 4 control
/// points [i][j] for parameters u and v: z up, spout towards +x, handle towards -x, base on z = 0.
extern const double teapot_patches[32][4][4][3];

/// Where a point of the published data lies in the shape: y up, centred, x from -1 to 1.
glm::dvec3 shape_from_teapot(const glm::dvec3& published);

}  // namespace scanlit::detail
