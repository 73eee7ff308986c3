#include "rasterizer/mesh/triangulate.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace scanlit::detail {
namespace {

constexpr std::size_t max_clipped_corners = 1000;  // ear clipping takes the square of it in steps

using Outline = std::vector<glm::dvec2>;

/// Twice the signed area of the triangle; positive where a, b, c turn left.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon seen along the axis nearest to its normal, counter-clockwise.
Outline projected(const std::vector<glm::vec3>& polygon) {
  glm::dvec3 normal{0};  // Newell's: right for every outline, also where some corners are in line
  for (std::size_t i = 0; i < polygon.size(); ++i)
    normal += glm::cross(glm::dvec3(polygon[i] - polygon[0]),
                         glm::dvec3(polygon[(i + 1) % polygon.size()] - polygon[0]));
  const glm::dvec3 size = glm::abs(normal);
  const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;

  Outline outline;
  for (const glm::vec3& p : polygon) {
    const glm::dvec2 seen{p[(axis + 1) % 3], p[(axis + 2) % 3]};
    outline.emplace_back(normal[axis] < 0 ? glm::dvec2(seen.y, seen.x) : seen);
  }
  return outline;
}

bool is_convex(const Outline& outline) {
  const std::size_t size = outline.size();
  int x_turns = 0;  // a convex outline goes left once and right once; a star does so more often
  for (std::size_t i = 0; i < size; ++i) {
    const glm::dvec2 &a = outline[i], &b = outline[(i + 1) % size], &c = outline[(i + 2) % size];
    if (turn(a, b, c) < 0) return false;
    if ((b.x < a.x) != (c.x < b.x)) ++x_turns;
  }
  return x_turns <= 2;
}

/// Whether the corner at ring[i] can be cut off: it turns left and no other corner lies in it.
bool is_ear(const Outline& outline, const std::vector<std::uint32_t>& ring, std::size_t i) {
  const std::size_t size = ring.size();
  const glm::dvec2& a = outline[ring[(i + size - 1) % size]];
  const glm::dvec2& b = outline[ring[i]];
  const glm::dvec2& c = outline[ring[(i + 1) % size]];
  if (turn(a, b, c) <= 0) return false;
  for (const std::uint32_t other : ring) {
    const glm::dvec2& p = outline[other];
    // Where a bridge to a hole meets the outline, two corners share a place: not in the way.
    if (p == a || p == b || p == c) continue;
    if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
  }
  return true;
}

}  // namespace

bool triangulate(const std::vector<glm::vec3>& polygon, std::vector<std::uint32_t>& triangles) {
  std::vector<std::uint32_t> ring(polygon.size());
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = std::uint32_t(i);

  bool good = true;
  if (polygon.size() > 3) {
    const Outline outline = projected(polygon);
    if (!is_convex(outline)) {
      good = polygon.size() <= max_clipped_corners;
      for (std::size_t i = 0, tried = 0; good && ring.size() > 3;) {
        if (is_ear(outline, ring, i)) {
          const std::size_t size = ring.size();
          triangles.insert(triangles.end(),
                           {ring[(i + size - 1) % size], ring[i], ring[(i + 1) % size]});
          ring.erase(ring.begin() + std::ptrdiff_t(i));
          tried = 0;
        } else {
          ++i;
          good = ++tried <= ring.size();
        }
        i %= ring.size();
      }
    }
  }
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    triangles.insert(triangles.end(), {ring[0], ring[i], ring[i + 1]});
  return good;
}

}  // namespace scanlit::detail
