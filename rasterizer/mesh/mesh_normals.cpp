#include "rasterizer/mesh/mesh_normals.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace scanlit::detail {

// In double, the squares of float lengths neither overflow nor vanish.
glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : glm::dvec3(0);
}

std::vector<glm::vec3> group_normals(std::span<const glm::vec3> positions,
                                     std::span<const std::uint32_t> corner_point,
                                     std::span<const std::uint32_t> corner_group,
                                     std::size_t group_count, NormalWeight weight) {
  // Below this share of the weights that went into it, a sum is what rounding (of the float
  // positions too) left of normals that cancel (the two sides of a sheet), and its direction means
  // nothing.
  constexpr double cancelled = 1e-6;
  std::vector<glm::dvec4> sum(group_count, glm::dvec4(0));      // w: of the weights
  std::vector<glm::vec3> any(group_count, glm::vec3(0, 0, 1));  // a triangle's, for sums of zero
  for (std::size_t t = 0; t < corner_point.size(); t += 3) {
    const glm::dvec3 p[3] = {positions[corner_point[t]], positions[corner_point[t + 1]],
                             positions[corner_point[t + 2]]};
    const glm::dvec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
    const glm::dvec3 normal = unit_or_zero(area);
    if (normal == glm::dvec3(0)) continue;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t group = corner_group[t + std::size_t(i)];
      any[group] = normal;
      const glm::dvec3 a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
      const double share = weight == NormalWeight::area
                               ? glm::length(area)
                               : std::atan2(glm::length(area), glm::dot(a, b));
      sum[group] += glm::dvec4(normal, 1) * share;
    }
  }
  for (std::size_t group = 0; group < group_count; ++group) {
    const glm::dvec3 total(sum[group]);
    if (glm::length(total) > cancelled * sum[group].w) any[group] = unit_or_zero(total);
  }
  return any;
}

}  // namespace scanlit::detail
