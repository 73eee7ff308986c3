// The Utah teapot.
#pragma once

#include <glm/vec3.hpp>

namespace scanlit::detail {

/// Martin Newell's 32 bicubic Bezier patches (1975) as published, each a net of 4 x 4 control
/// points [i][j] for parameters u and v: z up, spout towards +x, handle towards -x, base on z = 0.
constexpr int teapot_patch_count = 32;
extern const double teapot_patches[teapot_patch_count][4][4][3];

/// Where a point of the published data lies in the shape: y up, centred, x from -1 to 1.
glm::dvec3 shape_from_teapot(const glm::dvec3& published);

/// The control points of S(u, v) = sum B_i(u) B_j(v) control[i][j], B Bernstein's cubic
/// polynomials. dS/dv x dS/du points outwards.
struct BezierPatch {
  glm::dvec3 control[4][4];
};

/// A patch in the shape's coordinates.
BezierPatch teapot_patch(int index);

}  // namespace scanlit::detail
