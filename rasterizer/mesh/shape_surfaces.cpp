#include "rasterizer/mesh/shape_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "rasterizer/mesh/shape_builder.h"

namespace scanlit::detail {
namespace {

using glm::dvec2;
using glm::dvec3;

std::size_t square(int n) { return std::size_t(n) * std::size_t(n); }

/// -1 for i = 0 to 1 for i = n; coordinate(n - i, n) is exactly its negative.
double coordinate(int i, int n) { return double(2 * i - n) / n; }

/// A square of side 2 at distance `height` along the normal; right x up = normal.
void add_square(ShapeBuilder& shape, int n, const dvec3& right, const dvec3& up, double height) {
  const dvec3 normal = glm::cross(right, up);
  shape.add_grid(n, n, [&](int i, int j) {
    return SurfacePoint{coordinate(i, n) * right + coordinate(j, n) * up + height * normal, normal,
                        dvec2(i, j) / double(n)};
  });
}

/// A disc of radius 1 across the y axis, seen from outside; `up` is 1 for the top, -1 for the
/// bottom.
void add_cap(ShapeBuilder& shape, int segments, int rings, int up) {
  shape.add_grid(segments, rings, [&](int i, int j) {
    const CosSin turned = turn(i, segments);
    // From outside, the radius must run up where the angle runs to the right.
    const double radius = double(up > 0 ? rings - j : j) / rings;
    const dvec3 position{radius * turned.sin, up, radius * turned.cos};
    return SurfacePoint{position, dvec3(0, up, 0),
                        dvec2(0.5 + position.x / 2, 0.5 - up * position.z / 2)};
  });
}

/// Rings of quads that are about as high as wide, for n segments around.
int rings_for(int n) { return std::max(1, n / 4); }

}  // namespace

PolyMesh make_plane(int n) {
  ShapeBuilder shape(2 * square(n));
  add_square(shape, n, {1, 0, 0}, {0, 1, 0}, 0);
  return shape.take();
}

PolyMesh make_cube(int n) {
  ShapeBuilder shape(12 * square(n));
  const dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  add_square(shape, n, x, y, 1);   // front, +z
  add_square(shape, n, -x, y, 1);  // back
  add_square(shape, n, -z, y, 1);  // right, +x
  add_square(shape, n, z, y, 1);   // left
  add_square(shape, n, x, -z, 1);  // top, +y
  add_square(shape, n, x, z, 1);   // bottom
  return shape.take();
}

PolyMesh make_sphere(int n) {
  ShapeBuilder shape(4 * square(n));
  shape.add_grid(2 * n, n, [&](int i, int j) {
    const CosSin east = turn(i, 2 * n), polar = turn(n - j, 2 * n);
    const dvec3 direction{polar.sin * east.sin, polar.cos, polar.sin * east.cos};
    // A pole is a vertex for each triangle there, half way between the meridians that meet in it.
    const double pole = j == 0 ? 0.5 : j == n ? -0.5 : 0.0;
    return SurfacePoint{direction, direction, dvec2((i + pole) / (2 * n), double(j) / n)};
  });
  return shape.take();
}

PolyMesh make_icosphere(int n) {
  const double g = glm::golden_ratio<double>();
  const std::array<dvec3, 12> corner = {{{-1, g, 0},
                                         {1, g, 0},
                                         {-1, -g, 0},
                                         {1, -g, 0},
                                         {0, -1, g},
                                         {0, 1, g},
                                         {0, -1, -g},
                                         {0, 1, -g},
                                         {g, 0, -1},
                                         {g, 0, 1},
                                         {-g, 0, -1},
                                         {-g, 0, 1}}};
  constexpr int face[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                               {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                               {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                               {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  ShapeBuilder shape(20 * square(n));
  for (const auto& [a, b, c] : face) {
    const dvec3 centre = corner[std::size_t(a)] + corner[std::size_t(b)] + corner[std::size_t(c)];
    const auto east = [](const dvec3& p) { return std::atan2(p.x, p.z) / glm::two_pi<double>(); };
    // Row j has n - j + 1 points; along an edge, both faces add the same two numbers and a zero.
    std::vector<OpenMesh::VertexHandle> row, below;
    for (int j = 0; j <= n; ++j) {
      below.swap(row);
      row.clear();
      for (int i = 0; i <= n - j; ++i) {
        const dvec3 p =
            glm::normalize(double(n - i - j) * corner[std::size_t(a)] +
                           double(i) * corner[std::size_t(b)] + double(j) * corner[std::size_t(c)]);
        // Within half a turn of the face's centre, so that no triangle spans the whole texture.
        double u = east(p) - east(centre);
        u += east(centre) - std::round(u) + 0.5;
        row.push_back(shape.add_vertex(
            {p, p, dvec2(u, std::asin(std::clamp(p.y, -1.0, 1.0)) / glm::pi<double>() + 0.5)}));
      }
      for (std::size_t i = 0; i + 1 < below.size(); ++i) {
        shape.add_triangle(below[i], below[i + 1], row[i]);
        if (i + 1 < row.size()) shape.add_triangle(below[i + 1], row[i + 1], row[i]);
      }
    }
  }
  return shape.take();
}

PolyMesh make_cylinder(int n) {
  const int rings = rings_for(n);
  ShapeBuilder shape(6 * std::size_t(n) * std::size_t(rings));
  shape.add_grid(n, rings, [&](int i, int j) {
    const CosSin turned = turn(i, n);
    return SurfacePoint{dvec3(turned.sin, coordinate(j, rings), turned.cos),
                        dvec3(turned.sin, 0, turned.cos), dvec2(double(i) / n, double(j) / rings)};
  });
  add_cap(shape, n, rings, 1);
  add_cap(shape, n, rings, -1);
  return shape.take();
}

PolyMesh make_cone(int n) {
  const int rings = rings_for(n);
  ShapeBuilder shape(4 * std::size_t(n) * std::size_t(rings));
  shape.add_grid(n, rings, [&](int i, int j) {
    const CosSin turned = turn(i, n);
    const double radius = double(rings - j) / rings;
    // The apex is a vertex for each triangle there, with the normal half way along its base.
    const double apex = j == rings ? -0.5 : 0.0;
    const CosSin facing = turn(2 * (i + n) - (j == rings ? 1 : 0), 2 * n);
    return SurfacePoint{dvec3(radius * turned.sin, coordinate(j, rings), radius * turned.cos),
                        glm::normalize(dvec3(2 * facing.sin, 1, 2 * facing.cos)),
                        dvec2((i + apex) / n, double(j) / rings)};
  });
  add_cap(shape, n, rings, -1);
  return shape.take();
}

PolyMesh make_torus(int n) {
  constexpr double major = 0.7, minor = 0.3;
  ShapeBuilder shape(4 * square(n));
  shape.add_grid(2 * n, n, [&](int i, int j) {
    const CosSin ring = turn(i, 2 * n), tube = turn(j, n);
    const dvec3 out{ring.cos, ring.sin, 0};
    const dvec3 normal = tube.cos * out + dvec3(0, 0, tube.sin);
    return SurfacePoint{major * out + minor * normal, normal,
                        dvec2(double(i) / (2 * n), double(j) / n)};
  });
  return shape.take();
}

// The knot sin t + 2 sin 2t, cos t - 2 cos 2t, -sin 3t. Its curvature is nowhere zero, so normal
// and binormal of the curve turn with it and meet themselves after one round.
PolyMesh make_trefoil(int n) {
  constexpr double scale = 0.27, tube_radius = 0.18;
  const int along = 8 * n;
  ShapeBuilder shape(16 * square(n));
  shape.add_grid(along, n, [&](int i, int j) {
    const CosSin t1 = turn(i, along), t2 = turn(2 * i, along), t3 = turn(3 * i, along);
    const dvec3 centre{t1.sin + 2 * t2.sin, t1.cos - 2 * t2.cos, -t3.sin};
    const dvec3 first{t1.cos + 4 * t2.cos, -t1.sin + 4 * t2.sin, -3 * t3.cos};
    const dvec3 second{-t1.sin - 8 * t2.sin, -t1.cos + 8 * t2.cos, 9 * t3.sin};
    const dvec3 binormal = glm::normalize(glm::cross(first, second));
    const dvec3 inward = glm::normalize(glm::cross(binormal, first));
    const CosSin around = turn(n - j, n);
    const dvec3 normal = around.cos * inward + around.sin * binormal;
    return SurfacePoint{scale * centre + tube_radius * normal, normal,
                        dvec2(double(i) / along, double(j) / n)};
  });
  return shape.take();
}

}  // namespace scanlit::detail
