#include "rasterizer/mesh/shape_builder.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace scanlit::detail {

CosSin turn(int i, int n) {
  const int step = i % n;
  if (4LL * step % n == 0) {
    constexpr CosSin quarters[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    return quarters[4LL * step / n];
  }
  const double angle_rad = glm::two_pi<double>() * step / n;
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

ShapeBuilder::ShapeBuilder(std::size_t triangles) {
  mesh_.request_vertex_normals();
  mesh_.request_vertex_texcoords2D();
  mesh_.reserve(triangles / 2, triangles * 3 / 2, triangles);
}

OpenMesh::VertexHandle ShapeBuilder::add_vertex(const SurfacePoint& point) {
  const OpenMesh::VertexHandle vertex = mesh_.add_vertex(to_openmesh(glm::vec3(point.position)));
  mesh_.set_normal(vertex, to_openmesh(glm::vec3(point.normal)));
  mesh_.set_texcoord2D(vertex, to_openmesh(glm::vec2(point.texcoord)));
  return vertex;
}

void ShapeBuilder::add_triangle(OpenMesh::VertexHandle a, OpenMesh::VertexHandle b,
                                OpenMesh::VertexHandle c) {
  const auto &p = mesh_.point(a), &q = mesh_.point(b), &r = mesh_.point(c);
  if (p != q && q != r && r != p) mesh_.add_face(a, b, c);
}

}  // namespace scanlit::detail
