#include "rasterizer/mesh/teapot.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "rasterizer/mesh/shape_builder.h"
#include "rasterizer/mesh/shape_surfaces.h"

namespace scanlit::detail {
namespace {

using glm::dvec3;

/// Bernstein's cubic polynomials and their derivatives at i / n.
struct Weights {
  double value[4], slope[4];

  Weights(int i, int n) {
    const double t = double(i) / n, s = double(n - i) / n;
    // Written so that i and n - i give the same numbers in reverse: patches that share a border run
    // along it in opposite directions, and must meet to the bit.
    value[0] = s * (s * s);
    value[1] = (3 * t) * (s * s);
    value[2] = (3 * s) * (t * t);
    value[3] = t * (t * t);
    slope[0] = -3 * s * s;
    slope[1] = 3 * s * s - 6 * s * t;
    slope[2] = 6 * s * t - 3 * t * t;
    slope[3] = 3 * t * t;
  }
};

dvec3 weighted(const double (&w)[4], const dvec3& a, const dvec3& b, const dvec3& c,
               const dvec3& d) {
  return (w[0] * a + w[3] * d) + (w[1] * b + w[2] * c);  // the same in reverse
}

dvec3 weighted(const BezierPatch& patch, const double (&u)[4], const double (&v)[4]) {
  const auto& p = patch.control;
  const auto row = [&](int i) { return weighted(v, p[i][0], p[i][1], p[i][2], p[i][3]); };
  return weighted(u, row(0), row(1), row(2), row(3));
}

dvec3 normal(const BezierPatch& patch, const Weights& u, const Weights& v) {
  const dvec3 along_u = weighted(patch, u.slope, v.value);
  dvec3 along_v = weighted(patch, u.value, v.slope);
  // Where the edge u = 0 is a point, dP/dv vanishes; close to it, it is u d2P/dudv. What rounding
  // leaves of it has no direction: control points are of size 1, other derivatives above .01.
  constexpr double vanished = 1e-9;
  if (glm::length(along_v) < vanished) along_v = weighted(patch, u.slope, v.slope);
  return glm::normalize(glm::cross(along_v, along_u));
}

}  // namespace

dvec3 shape_from_teapot(const dvec3& published) {
  constexpr double handle = -3, spout = 3.434, top = 3.15;  // where the surface ends
  constexpr double half_length = (spout - handle) / 2;
  // z up becomes y up by a quarter turn about x.
  return dvec3(published.x - (handle + half_length), published.z - top / 2, -published.y) /
         half_length;
}

BezierPatch teapot_patch(int index) {
  const auto& published = teapot_patches[index];
  BezierPatch patch;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double(&p)[3] = published[i][j];
      patch.control[i][j] = shape_from_teapot({p[0], p[1], p[2]});
    }
  // On top of the knob, points that should be one are .002 apart in the data. Left so, they make a
  // pinhole whose border has normals in all directions.
  constexpr double one_point = 0.003;
  dvec3(&edge)[4] = patch.control[0];
  if (std::ranges::all_of(edge, [&](const dvec3& p) { return distance(p, edge[0]) < one_point; }))
    std::ranges::fill(edge, edge[0]);
  return patch;
}

PolyMesh make_teapot(int n) {
  ShapeBuilder shape(64 * std::size_t(n) * std::size_t(n));
  for (int p = 0; p < teapot_patch_count; ++p) {
    const BezierPatch patch = teapot_patch(p);
    shape.add_grid(n, n, [&](int i, int j) {
      const Weights v(i, n), u(j, n);
      return SurfacePoint{
          weighted(patch, u.value, v.value), normal(patch, u, v), {double(i) / n, double(j) / n}};
    });
  }
  return shape.take();
}

}  // namespace scanlit::detail
