#include "bench_shapes.h"

#include <cmath>
#include <numbers>

namespace scanlit::bench {

using std::numbers::pi;

Mesh sphere(int stacks, int slices) {
  Mesh mesh;
  mesh.closed = true;
  mesh.positions.reserve(std::size_t(stacks + 1) * std::size_t(slices + 1));
  mesh.indices.reserve(std::size_t(stacks - 1) * std::size_t(slices) * 6);
  for (int i = 0; i <= stacks; ++i)
    for (int j = 0; j <= slices; ++j) {
      const double theta = pi * i / stacks, phi = 2 * pi * j / slices;
      mesh.positions.emplace_back(std::sin(theta) * std::sin(phi), std::cos(theta),
                                  std::sin(theta) * std::cos(phi));
    }
  mesh.normals = mesh.positions;
  for (int i = 0; i < stacks; ++i)
    for (int j = 0; j < slices; ++j) {
      const auto a = std::uint32_t(i * (slices + 1) + j), b = a + std::uint32_t(slices) + 1;
      if (i != stacks - 1) mesh.indices.insert(mesh.indices.end(), {a, b, b + 1});
      if (i != 0) mesh.indices.insert(mesh.indices.end(), {a, b + 1, a + 1});
    }
  return mesh;
}

Mesh torus(int around, int tube) {
  Mesh mesh;
  mesh.closed = true;
  const double tilt = -40 * pi / 180;
  const auto tilted = [&](double x, double y, double z) {
    return glm::vec3(x, y * std::cos(tilt) - z * std::sin(tilt),
                     y * std::sin(tilt) + z * std::cos(tilt));
  };
  for (int j = 0; j <= tube; ++j)
    for (int i = 0; i <= around; ++i) {
      const double u = 2 * pi * i / around, v = 2 * pi * j / tube, radius = .7 + .3 * std::cos(v);
      mesh.positions.push_back(
          tilted(radius * std::cos(u), radius * std::sin(u), .3 * std::sin(v)));
      mesh.normals.push_back(
          tilted(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)));
    }
  for (int j = 0; j < tube; ++j)
    for (int i = 0; i < around; ++i) {
      const auto a = std::uint32_t(j * (around + 1) + i), d = a + std::uint32_t(around) + 1;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, d + 1, a, d + 1, d});
    }
  return mesh;
}

Mesh unit_cube() {
  Mesh mesh;
  mesh.closed = true;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 normal(0), u(0), v(0);
      normal[axis] = side;
      u[(axis + 1) % 3] = side;  // so that u x v = normal on both sides
      v[(axis + 2) % 3] = 1;
      const auto a = std::uint32_t(mesh.positions.size());
      for (const glm::vec2 corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        mesh.positions.push_back((normal + corner.x * u + corner.y * v) / 2.0f);
        mesh.normals.push_back(normal);
      }
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + 2, a, a + 2, a + 3});
    }
  return mesh;
}

}  // namespace scanlit::bench
