// A2, clipping and perspective. README.md says what each function is to do; `scanlit check .` says
// how far you are.
#include "clipping.h"

#include "variant.h"

namespace a2 {

double distance(const Vertex& vertex, Plane plane) {
  //<< TODO(A2.1) How far inside of the plane a vertex is, in units of w; negative: outside.
  const auto& [x, y, z, w, attribute] = vertex;
  switch (plane) {
    case Plane::left: return variant::window * w + x;
    case Plane::right: return variant::window * w - x;
    case Plane::bottom: return variant::window * w + y;
    case Plane::top: return variant::window * w - y;
    case Plane::near: return variant::near_at_0 ? z : w + z;
    default: return w - z;
  }
  //== return 1;
  //>>
}

Vertex cut(const Vertex& inside, const Vertex& outside, double d_inside, double d_outside) {
  //<< TODO(A2.2) Where the edge between the two meets the plane. For now: the vertex inside.
  const double t = d_inside / (d_inside - d_outside);
  const auto mix = [t](double a, double b) { return a + t * (b - a); };
  Vertex v{mix(inside.x, outside.x),
           mix(inside.y, outside.y),
           mix(inside.z, outside.z),
           mix(inside.w, outside.w),
           {}};
  for (int i = 0; i < 3; ++i) v.attribute[i] = mix(inside.attribute[i], outside.attribute[i]);
  return v;
  //== return inside;
  //>>
}

Polygon clip(const Polygon& polygon, Plane plane, const Stages& stages) {
  //<< TODO(A2.3) What of the polygon is inside of the plane. For now: all of it.
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double d_a = stages.distance(a, plane), d_b = stages.distance(b, plane);
    if (d_a >= 0) result.push_back(a);
    if (d_a >= 0 && d_b < 0) result.push_back(stages.cut(a, b, d_a, d_b));
    if (d_a < 0 && d_b >= 0) result.push_back(stages.cut(b, a, d_b, d_a));
  }
  return result;
  //== return polygon;
  //>>
}

Polygon clip_triangle(const Vertex (&triangle)[3], const Stages& stages) {
  //<< TODO(A2.4) What of the triangle is inside of all planes. For now: all of it, or nothing where
  //<< a corner lies behind the eye.
  Polygon polygon(triangle, triangle + 3);
  for (const Plane plane : all_planes) polygon = stages.clip(polygon, plane);
  return polygon;
  //== for (const Vertex& corner : triangle)
  //==   if (corner.w <= 0) return {};
  //== return Polygon(triangle, triangle + 3);
  //>>
}

Weights perspective(const Weights& on_screen, const double (&corner_w)[3]) {
  //<< TODO(A2.5) The weights on the surface, from those on the screen. For now: the same.
  Weights result;
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double inv_w = variant::given_inv_w ? corner_w[i] : 1 / corner_w[i];
    sum += result.corner[i] = on_screen.corner[i] * inv_w;
  }
  for (double& share : result.corner) share /= sum;
  return result;
  //== return on_screen;
  //>>
}

}  // namespace a2
