// How shapes are made: grids of points on surfaces, as OpenMesh meshes.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "rasterizer/mesh/poly_mesh.h"

namespace scanlit::detail {

struct SurfacePoint {
  glm::dvec3 position;
  glm::dvec3 normal;  // unit, outward
  glm::dvec2 texcoord;
};

struct CosSin {
  double cos, sin;
};
/// Of i / n of a full turn, i >= 0. Equal to the bit for i and i + n, and exactly 0 and 1 at
/// quarter turns: only so do seams and poles close without cracks.
CosSin turn(int i, int n);

class ShapeBuilder {
 public:
  explicit ShapeBuilder(std::size_t triangles);

  /// Joins points (i, j), i = 0..columns, j = 0..rows, by two triangles a quad. Seen from outside,
  /// i counts to the right and j up. Triangles of which two corners coincide (at a pole) are left
  /// out.
  template <class PointAt>
  void add_grid(int columns, int rows, PointAt point_at) {
    const int base = int(mesh_.n_vertices());
    for (int j = 0; j <= rows; ++j)
      for (int i = 0; i <= columns; ++i) add_vertex(point_at(i, j));
    const auto vertex = [&](int i, int j) {
      return OpenMesh::VertexHandle(base + j * (columns + 1) + i);
    };
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        add_triangle(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        add_triangle(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
  }

  OpenMesh::VertexHandle add_vertex(const SurfacePoint& point);
  void add_triangle(OpenMesh::VertexHandle a, OpenMesh::VertexHandle b, OpenMesh::VertexHandle c);

  PolyMesh take() { return std::move(mesh_); }

 private:
  PolyMesh mesh_;
};

}  // namespace scanlit::detail
