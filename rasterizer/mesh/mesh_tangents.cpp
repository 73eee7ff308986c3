#include "rasterizer/mesh/mesh_tangents.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec4.hpp>

#include "rasterizer/mesh/mesh_normals.h"

namespace scanlit::detail {
namespace {

/// A triangle as the vectors from its first corner to the two others, in space and in texture.
struct Edges {
  glm::dvec3 p1, p2;
  glm::dvec2 t1, t2;

  Edges(const Mesh& mesh, const std::uint32_t* corner) {
    const glm::dvec3 p0 = mesh.positions[corner[0]];
    const glm::dvec2 t0 = mesh.texcoords[corner[0]];
    p1 = glm::dvec3(mesh.positions[corner[1]]) - p0,
    p2 = glm::dvec3(mesh.positions[corner[2]]) - p0;
    t1 = glm::dvec2(mesh.texcoords[corner[1]]) - t0,
    t2 = glm::dvec2(mesh.texcoords[corner[2]]) - t0;
  }

  /// Unit; zero where it has none. p = p0 + (u - u0) dp/du + (v - v0) dp/dv, by Cramer's rule.
  glm::dvec3 dp_du() const {
    const double determinant = t1.x * t2.y - t1.y * t2.x;
    // Texture coordinates are rounded to float: of three on one line the determinant is that
    // rounding, and dp/du any direction.
    constexpr double on_one_line = 1e-6;
    if (!(std::abs(determinant) > on_one_line * glm::length(t1) * glm::length(t2)))
      return glm::dvec3(0);
    return unit_or_zero((t2.y * p1 - t1.y * p2) * (determinant > 0 ? 1.0 : -1.0));
  }

  /// At the three corners, in radians.
  glm::dvec3 angles() const {
    const double area = glm::length(glm::cross(p1, p2));
    const double first = std::atan2(area, glm::dot(p1, p2));
    const double second = std::atan2(area, glm::dot(p1, p1 - p2));
    return {first, second, glm::pi<double>() - first - second};
  }
};

}  // namespace

std::vector<glm::vec3> texcoord_tangents(const Mesh& mesh) {
  // Below this share of the weights that went into it, a sum is what rounding left of tangents that
  // cancel (where u turns back on itself), or that stand along the normal.
  constexpr double cancelled = 1e-6;
  std::vector<glm::dvec4> sum(mesh.positions.size(), glm::dvec4(0));  // w: of the weights
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const std::uint32_t* corner = &mesh.indices[t];
    const Edges edges(mesh, corner);
    const glm::dvec3 tangent = edges.dp_du();
    if (tangent == glm::dvec3(0)) continue;
    const glm::dvec3 angles = edges.angles();
    for (int i = 0; i < 3; ++i) sum[corner[i]] += glm::dvec4(tangent, 1) * angles[i];
  }
  std::vector<glm::vec3> tangents(mesh.positions.size());
  for (std::size_t v = 0; v < tangents.size(); ++v) {
    const glm::dvec3 total(sum[v]), normal(mesh.normals[v]);
    const glm::dvec3 across = total - normal * (glm::dot(normal, total) / glm::dot(normal, normal));
    tangents[v] = glm::length(across) > cancelled * sum[v].w ? unit_or_zero(across) : glm::dvec3(0);
  }
  return tangents;
}

}  // namespace scanlit::detail
