// A2, clipping and perspective: what is yours to write, in clipping.cpp. README.md says what each
// function is to do.
#pragma once

#include <vector>

namespace a2 {

/// In clip space, before the division by w.
struct Vertex {
  double x, y, z, w;
  double attribute[3];  // whatever is interpolated: a colour, a texture coordinate ...
};

/// In the order of a convex polygon's border.
using Polygon = std::vector<Vertex>;

enum class Plane { left, right, bottom, top, near, far };
constexpr Plane all_planes[] = {Plane::near,  Plane::far,    Plane::left,
                                Plane::right, Plane::bottom, Plane::top};

/// Shares of a triangle's three corners, which add up to 1.
struct Weights {
  double corner[3];
};

/// The functions below, for the later ones to call. While a part is judged, these are right,
/// whatever yours are; in the picture of A2.6 they are your own.
struct Stages {
  double (*distance)(const Vertex& vertex, Plane plane);
  Vertex (*cut)(const Vertex& inside, const Vertex& outside, double d_inside, double d_outside);
  Polygon (*clip)(const Polygon& polygon, Plane plane);
};

/// A2.1
double distance(const Vertex& vertex, Plane plane);
/// A2.2
Vertex cut(const Vertex& inside, const Vertex& outside, double d_inside, double d_outside);
/// A2.3
Polygon clip(const Polygon& polygon, Plane plane, const Stages& stages);
/// A2.4
Polygon clip_triangle(const Vertex (&triangle)[3], const Stages& stages);
/// A2.5: corner_w holds w or 1/w of the corners, as your variant says.
Weights perspective(const Weights& on_screen, const double (&corner_w)[3]);

}  // namespace a2
