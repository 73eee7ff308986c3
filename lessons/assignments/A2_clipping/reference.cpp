#include "lessons/assignments/A2_clipping/reference.h"

#include "lessons/assignments/judge/dice.h"

namespace scanlit::assignments::clipping {

ClipVariant clip_variant(std::uint64_t seed) {
  Dice dice(seed, "A2");
  return {
      .window = dice.between(14, 18) / 20.0, .near_at_0 = dice.coin(), .given_inv_w = dice.coin()};
}

double right_distance(const ClipVariant& variant, const Vertex& v, Plane plane) {
  switch (plane) {
    case Plane::left: return variant.window * v.w + v.x;
    case Plane::right: return variant.window * v.w - v.x;
    case Plane::bottom: return variant.window * v.w + v.y;
    case Plane::top: return variant.window * v.w - v.y;
    case Plane::near: return v.z + (variant.near_at_0 ? 0 : v.w);
    default: return v.w - v.z;
  }
}

Vertex right_cut(const Vertex& inside, const Vertex& outside, double d_inside, double d_outside) {
  const double out = d_inside / (d_inside - d_outside), in = 1 - out;
  Vertex v{in * inside.x + out * outside.x,
           in * inside.y + out * outside.y,
           in * inside.z + out * outside.z,
           in * inside.w + out * outside.w,
           {}};
  for (int i = 0; i < 3; ++i)
    v.attribute[i] = in * inside.attribute[i] + out * outside.attribute[i];
  return v;
}

Polygon right_clip(const ClipVariant& variant, const Polygon& polygon, Plane plane) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double d_a = right_distance(variant, a, plane), d_b = right_distance(variant, b, plane);
    if (d_a >= 0) result.push_back(a);
    if ((d_a >= 0) != (d_b >= 0))
      result.push_back(d_a >= 0 ? right_cut(a, b, d_a, d_b) : right_cut(b, a, d_b, d_a));
  }
  return result;
}

Polygon right_pieces(const ClipVariant& variant, const Vertex (&triangle)[3]) {
  Polygon polygon(triangle, triangle + 3);
  for (const Plane plane : a2::all_planes) polygon = right_clip(variant, polygon, plane);
  return polygon;
}

Weights right_perspective(const Weights& on_screen, const double (&w)[3]) {
  Weights shares;
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += shares.corner[i] = on_screen.corner[i] / w[i];
  for (double& share : shares.corner) share /= sum;
  return shares;
}

}  // namespace scanlit::assignments::clipping
