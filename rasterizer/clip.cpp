// (4) Clip: cut what leaves the near plane, the far plane or the guard band, in homogeneous
// coordinates, before division by w.
//
// Ivan Sutherland, Gary Hodgman, "Reentrant polygon clipping", CACM 17(1), 1974; in homogeneous
// coordinates after James Blinn, Martin Newell, "Clipping using homogeneous coordinates", SIGGRAPH
// 1978. In double, because a triangle may reach from a hand's breadth to the horizon.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "rasterizer/pipeline.h"

namespace scanlit {

namespace {

struct Corner {
  double x, y, z, w;
  double barycentric[3];
};

struct Polygon {
  // 6 planes add a corner each to a triangle, 9 in all; a polygon that rounding has made slightly
  // non-convex may gain one more.
  static constexpr int capacity = 16;
  Corner corners[capacity];
  int size = 0;
};

/// Signed distance to a plane, in units of w: positive inside.
double distance(const Corner& c, Outside plane, double guard_x, double guard_y) {
  switch (plane) {
    case outside_near: return c.w - c.z;
    case outside_far: return c.z;
    case outside_left: return guard_x * c.w + c.x;
    case outside_right: return guard_x * c.w - c.x;
    case outside_bottom: return guard_y * c.w + c.y;
    default: return guard_y * c.w - c.y;
  }
}

Corner cut(const Corner& inside, const Corner& outside, double d_inside, double d_outside) {
  const double t = d_inside / (d_inside - d_outside);
  const double from_outside = d_outside / (d_outside - d_inside);
  // From the nearer end: 1e-16 of a far end's coordinates may be more than all of a near one's.
  const auto mix = [=](double a, double b) {
    return t <= 0.5 ? a + t * (b - a) : b + from_outside * (a - b);
  };
  Corner c{mix(inside.x, outside.x),
           mix(inside.y, outside.y),
           mix(inside.z, outside.z),
           mix(inside.w, outside.w),
           {}};
  for (int i = 0; i < 3; ++i) c.barycentric[i] = mix(inside.barycentric[i], outside.barycentric[i]);
  return c;
}

/// z = w in spite of rounding: depth 1. An edge from the horizon to far behind the eye has lost w
/// in cancellation, but not z, which hardly changes along it; in parallel projection w is the
/// constant.
void put_on_near_plane(Corner& c, const Corner& a, const Corner& b) {
  if (std::abs(a.z - b.z) < std::abs(a.w - b.w))
    c.w = c.z;
  else
    c.z = c.w;
}

Polygon clip(const Polygon& polygon, Outside plane, double guard_x, double guard_y) {
  Polygon result;
  for (int i = 0; i < polygon.size; ++i) {
    const Corner& a = polygon.corners[i];
    const Corner& b = polygon.corners[(i + 1) % polygon.size];
    const double d_a = distance(a, plane, guard_x, guard_y);
    const double d_b = distance(b, plane, guard_x, guard_y);
    assert(result.size + 2 <= Polygon::capacity);
    if (d_a >= 0) result.corners[result.size++] = a;
    if ((d_a >= 0) != (d_b >= 0)) {
      Corner c = d_a >= 0 ? cut(a, b, d_a, d_b) : cut(b, a, d_b, d_a);
      if (plane == outside_near) put_on_near_plane(c, a, b);
      if (plane == outside_far) c.z = 0;
      result.corners[result.size++] = c;
    }
  }
  return result;
}

}  // namespace

void clip(const ClipVertex (&triangle)[3], unsigned outcodes, const Viewport& viewport,
          std::vector<ClippedTriangle>& pieces) {
  Polygon polygon;
  for (const ClipVertex& v : triangle) {
    Corner& c = polygon.corners[polygon.size];
    c = {v.x, v.y, v.z, v.w, {}};
    c.barycentric[polygon.size++] = 1;
  }
  // Near first: behind the eye the side planes mean nothing.
  for (const Outside plane :
       {outside_near, outside_far, outside_left, outside_right, outside_bottom, outside_top})
    if (outcodes & plane) polygon = clip(polygon, plane, viewport.guard_x(), viewport.guard_y());

  // What is inside has at least the near distance, 1e-12 or more (camera.cpp), for w. Less is what
  // cancellation left of ends 1e15 times as far away, and 1/w might be infinite.
  if (std::any_of(polygon.corners, polygon.corners + polygon.size,
                  [](const Corner& c) { return !(c.w > 1e-13); }))
    return;

  const auto fill = [&](ClippedTriangle& piece, int corner, const Corner& c) {
    ClipVertex v{float(c.x), float(c.y), float(c.z), float(c.w)};
    // Beyond the volume by rounding alone; the integers of scan conversion rely on it.
    v.x = std::clamp(v.x, -viewport.guard_x() * v.w, viewport.guard_x() * v.w);
    v.y = std::clamp(v.y, -viewport.guard_y() * v.w, viewport.guard_y() * v.w);
    v.z = std::clamp(v.z, 0.0f, v.w);
    piece.vertices[corner] = project(v, viewport);
    for (int i = 0; i < 3; ++i) piece.barycentric[corner][i] = float(c.barycentric[i]);
  };
  for (int i = 2; i < polygon.size; ++i) {
    ClippedTriangle& piece = pieces.emplace_back();
    fill(piece, 0, polygon.corners[0]);
    fill(piece, 1, polygon.corners[i - 1]);
    fill(piece, 2, polygon.corners[i]);
  }
}

}  // namespace scanlit
