// (8) A vector of triangles on the screen, and bounds of what is interpolated across them: normals,
// positions, V. For strides.h.
#pragma once

#include "rasterizer/bounded_directions.h"
#include "rasterizer/pipeline.h"

namespace scanlit {

/// Twice the area, in (1/256 pixel)^2; negative where it faces away.
inline std::int64_t area_of(const DrawnTriangle& t) {
  return edge_function(t.vertices[0], t.vertices[1], t.vertices[2].x, t.vertices[2].y);
}

/// One number for each triangle of a vector.
struct Lanes {
  float of[max_lanes] = {};

  operator Batch() const { return Batch::load(of); }
};
struct Vec3Lanes {
  Lanes x, y, z;

  void put(int lane, const glm::vec3& v) { x.of[lane] = v.x, y.of[lane] = v.y, z.of[lane] = v.z; }
  operator Vec3<Batch>() const { return {x, y, z}; }
};

/// A vector of triangles of one draw on the screen, x to the right and y down in pixels, and how
/// their attributes change along a row. An attribute is a = sum(l_k w_k a_k) / sum(l_k w_k), l_k
/// the corner's weight that is linear on the screen, w_k its 1/w.
///
/// Each lane is a triangle, or a cell of one, because bounds are the sharper the smaller the cone
/// of directions is: one of the four that the middles of its edges cut it into, or of a large
/// triangle all lanes are rectangles of a tile. A cell is the hull of four corners, two of which
/// may be one.
struct ScreenGroup {
  int cells = 1;           // of a triangle: 1, 4 or all lanes
  Lanes share[4][3];       // barycentric coordinates in the triangle: [corner of the cell][vertex]
  Lanes step[3];           // d(l_k w_k) / dx
  Lanes x[3], y[3], w[3];  // of the triangle's corners
  Vec3Lanes normal[3], position[3];  // at the corners, object space

  void put(const Frame& frame, const DrawnTriangle& drawn, int lane);
  /// Into all lanes.
  void put(const Frame& frame, const DrawnTriangle& drawn);
  void put_inner_cell(int lane);
  /// In 1/256 pixel.
  void put_rectangle(const DrawnTriangle& drawn, const Rect& rectangle, int lane);

  BoundedVector attribute(const Vec3<Batch> (&corner)[3]) const;
  /// An attribute at corner i of the cells.
  template <class A>
  A at_corner(int i, const A& a0, const A& a1, const A& a2) const {
    return a0 * Batch(share[i][0]) + a1 * Batch(share[i][1]) + a2 * Batch(share[i][2]);
  }
  /// What holds in all of a triangle's cells.
  Bounded of_triangle(const Bounded& of_cell) const;
  Batch largest(Batch a) const;
  Batch sum(Batch a) const;  // a line may cross one cell's kinks after another's
};

/// What is known of the surface across a group, and from where it is seen; in world space.
struct BoundedSurface {
  BoundedDirection n, v;
  Cosine<Bounded> n_v;
  BoundedVector position;
  bool framed = false;  // axes are known
  BoundedAxes axes{};
};

/// V across the group; `position` as attribute() gives it, in world space.
BoundedDirection to_viewer(const Frame& frame, const ScreenGroup& group,
                           const BoundedVector& position);

}  // namespace scanlit
