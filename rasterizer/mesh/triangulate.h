// A polygon becomes triangles.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace scanlit::detail {

/// Appends size - 2 triangles, three indices into `polygon` each, wound as the polygon is; at least
/// 3 corners. Concave polygons are cut by their ears. Returns false where the rest had to become a
/// fan, which may cover what it should not: the outline crosses itself, or is concave and has more
/// than 1,000 corners.
bool triangulate(const std::vector<glm::vec3>& polygon, std::vector<std::uint32_t>& triangles);

}  // namespace scanlit::detail
