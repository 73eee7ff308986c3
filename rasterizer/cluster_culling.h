// Which clusters of a mesh cannot give a fragment, and which need no clipping: decided from their
// bounds alone, and never against what their triangles would say one by one.
//
// Notation: x, y, z, w are the rows of clip_from_object, each a function of an object position p,
// x(p) = X.p + x(0); c and r are a cluster's centre and radius.
//
// Outside, inside. A plane of the view is f(p) >= 0 for a sum f of rows, and over a sphere f
// differs from f(c) by at most |F| r. The vertex stage rounds: of ((X0 p0 + X1 p1) + X2 p2) + x(0)
// in float it gets at most 4 u (|X0 p0| + |X1 p1| + |X2 p2| + |x(0)|) wrong, u = 2^-24.
//
// Back-facing. On the screen, half its size being 1, a triangle (a, b, c) of normal n has
//   twice its area = twice its area in object space * n.E(a) / (w(a) w(b) w(c)),
//   E(p) = w(p) X x Y + x(p) Y x W + y(p) W x X:
// by Cauchy and Binet the determinant of the three corners' (x, y, w) is n's doubled area times
// n.E. E(p) points from p to the eye: E(p) = E(c) + D (p - c) with D = det(X, Y, W), 0 in parallel
// projection. So n.E(a) is negative for a whole cluster if, the angle between its cone's axis and
// E(c) being t and the cone's half angle h,
//   |E(c)| cos(t - h) + |D| plane_distance < 0.
// But vertices are drawn where float and 1/256 pixel put them, each off by up to `moved`, and a
// sliver may turn over. If it did, its corners would on the way lie on one line; each has moved by
// at most `moved`, so all lay within `moved` of that line, and the least height was at most
// 2 moved. Triangles higher than that on the screen face where they faced; a height there is twice
// the area over the longest side, and the projection stretches sides at most by
//   |(X - q W, Y - s W)| / w,   (q, s) = (x, y) / w the place on the screen.
#pragma once

#include <array>

#include "rasterizer/mesh/clusters.h"
#include "rasterizer/pipeline.h"

namespace scanlit {

enum class ClusterView {
  outside,      // of the picture, or of near and far: no triangle gives a fragment
  back_facing,  // inside, and every triangle faces away, where back faces are not drawn
  inside,       // of near, far and guard band: every outcode is 0
  crossing      // or not known
};

/// What a sphere can cover on the screen, and how near it can be.
struct ScreenBounds {
  Rect pixels;     // may be empty, may leave the picture
  double nearest;  // the greatest depth of any fragment, or more
};

/// One draw's constants of the tests.
class ClusterCuller {
 public:
  ClusterCuller(const Draw& draw, const Viewport& viewport);

  ClusterView view(const Cluster& cluster) const;
  /// Of anything that the sphere (object space) holds; never back_facing.
  ClusterView view(const Sphere& bounds) const;

  /// Of a cluster or sphere whose view is `inside`.
  ScreenBounds screen_bounds(const Sphere& sphere) const;

 private:
  /// A sphere in clip space.
  struct Extent {
    glm::dvec4 centre;  // x(c), y(c), z(c), w(c)
    glm::dvec4 error;   // of a vertex's x, y, z, w by the vertex stage's rounding
    double radius;      // object space
    double least_w;     // of any vertex, rounded or not
  };
  Extent extent(const glm::dvec3& centre, double radius) const;
  ClusterView view(const Extent& extent) const;
  bool back_facing(const Cluster& cluster, const Extent& extent) const;

  struct Plane {
    glm::dvec4 rows;  // f = rows.x x + rows.y y + rows.z z + rows.w w, >= 0 inside
    double gradient;  // |F|
  };
  glm::dmat4 clip_from_object_;
  glm::dmat4 magnitudes_;            // of its entries
  std::array<Plane, 2> depth_;       // near, far
  std::array<Plane, 4> picture_;     // left, right, bottom, top; and a little more
  std::array<Plane, 4> guard_band_;  // in the same order
  glm::dvec3 rows_[4];               // X, Y, Z, W
  double lengths_[4];                // of them
  glm::dvec3 x_y_, y_w_, w_x_;       // X x Y, Y x W, W x X, away from the eye if mirrored
  double determinant_;               // |D|
  double half_width_, half_height_;  // 1/256 pixel
  bool draw_back_faces_;
};

}  // namespace scanlit
