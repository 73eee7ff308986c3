// Meshes for the properties: grids whose two ends may be joined, in any shape.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <vector>

#include "rasterizer/mesh.h"
#include "tests/stress/property.h"

namespace scanlit::stress {

/// columns x rows quadrangles, each of two triangles by either diagonal. Joined at both pairs of
/// ends it is a closed surface, wherever its vertices are; at none, a disc.
class Grid {
 public:
  Grid(int columns, int rows, bool joined, Property& property)
      : columns_(columns), rows_(rows), joined_(joined) {
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        const std::uint32_t a = vertex(x, y), b = vertex(x + 1, y), c = vertex(x + 1, y + 1),
                            d = vertex(x, y + 1);
        if (property.random()() & 1)
          indices.insert(indices.end(), {a, b, c, a, c, d});
        else
          indices.insert(indices.end(), {a, b, d, b, c, d});
      }
  }

  std::size_t vertex_count() const {
    return joined_ ? std::size_t(columns_ * rows_) : std::size_t((columns_ + 1) * (rows_ + 1));
  }
  std::uint32_t vertex(int x, int y) const {
    return joined_ ? std::uint32_t((y % rows_) * columns_ + x % columns_)
                   : std::uint32_t(y * (columns_ + 1) + x);
  }
  /// A disc's border, in the order in which its faces go around.
  std::vector<std::uint32_t> border() const {
    std::vector<std::uint32_t> result;
    for (int x = 0; x < columns_; ++x) result.push_back(vertex(x, 0));
    for (int y = 0; y < rows_; ++y) result.push_back(vertex(columns_, y));
    for (int x = columns_; x > 0; --x) result.push_back(vertex(x, rows_));
    for (int y = rows_; y > 0; --y) result.push_back(vertex(0, y));
    return result;
  }

  std::vector<std::uint32_t> indices;

 private:
  int columns_, rows_;
  bool joined_;
};

inline glm::dvec3 random_direction(Property& property) {
  std::normal_distribution<double> coordinate;
  auto& random = property.random();
  return glm::normalize(glm::dvec3(coordinate(random), coordinate(random), coordinate(random)));
}

/// A torus of outer radius 1, facing outwards, with each vertex moved by up to `noise`; where that
/// is large, a tangle that goes through itself. Within a radius of 1 + noise.
inline std::vector<glm::dvec3> torus_positions(int columns, int rows, double tube, double noise,
                                               Property& property) {
  std::vector<glm::dvec3> positions;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const double u = 2 * std::numbers::pi * x / columns, v = 2 * std::numbers::pi * y / rows;
      const double r = 1 - tube + tube * std::cos(v);
      positions.push_back(glm::dvec3(r * std::cos(u), r * std::sin(u), tube * std::sin(v)) +
                          noise * property.uniform(0, 1) * random_direction(property));
    }
  return positions;
}

/// With normals along +z.
inline std::shared_ptr<Mesh> mesh_of(const std::vector<glm::vec3>& positions,
                                     const std::vector<std::uint32_t>& indices) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = positions;
  mesh->normals.assign(positions.size(), {0, 0, 1});
  mesh->indices = indices;
  return mesh;
}

}  // namespace scanlit::stress
