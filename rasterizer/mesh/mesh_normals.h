// Vertex normals computed from flat arrays of triangles.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "rasterizer/mesh.h"

namespace scanlit::detail {

/// One unit normal per group: the mean of the normals of the triangles that have a corner in it,
/// weighted by their area or by the angle they make there. corner_point[i] is the position of
/// corner i (three per triangle), corner_group[i] < group_count the group it belongs to. Where the
/// mean is zero: the normal of one of the triangles, or +z where all of them have zero area.
std::vector<glm::vec3> group_normals(std::span<const glm::vec3> positions,
                                     std::span<const std::uint32_t> corner_point,
                                     std::span<const std::uint32_t> corner_group,
                                     std::size_t group_count, NormalWeight weight);

/// The normalised vector, or zero where it has no direction (zero, NaN or Inf).
glm::dvec3 unit_or_zero(const glm::dvec3& v);

}  // namespace scanlit::detail
