#include "rasterizer/screen_group.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace scanlit {

void ScreenGroup::put(const Frame& frame, const DrawnTriangle& drawn, int lane) {
  const auto& v = drawn.vertices;
  const std::int64_t twice_area = area_of(drawn);
  const double scale = twice_area == 0 ? 0 : subpixel / double(twice_area);
  const bool perspective = frame.settings.interpolation == Interpolation::perspective;
  const double inv_w[3] = {perspective ? v[0].inv_w : 1.0f, perspective ? v[1].inv_w : 1.0f,
                           perspective ? v[2].inv_w : 1.0f};
  for (int k = 0; k < 3; ++k) {
    const auto &next = v[(k + 1) % 3], &after = v[(k + 2) % 3];
    step[k].of[lane] = float(double(next.y - after.y) * -scale * inv_w[k]);
    x[k].of[lane] = float(v[k].x) / subpixel - .5f, y[k].of[lane] = float(v[k].y) / subpixel - .5f;
    w[k].of[lane] = float(1 / inv_w[k]);
  }
  const Draw& draw = frame.draw_of(drawn);
  const bool behind = (twice_area < 0) != draw.mirrored;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t vertex = draw.mesh->indices[3 * std::size_t(drawn.triangle) + k];
    const glm::vec3& n = draw.mesh->normals[vertex];
    normal[k].put(lane, behind ? -n : n);
    position[k].put(lane, draw.mesh->positions[vertex]);
  }
}

void ScreenGroup::put(const Frame& frame, const DrawnTriangle& drawn) {
  put(frame, drawn, 0);
  const auto spread = [](Lanes& lanes) { std::ranges::fill(lanes.of, lanes.of[0]); };
  for (auto* of_corners : {&step, &x, &y, &w})
    for (Lanes& lanes : *of_corners) spread(lanes);
  for (auto* of_corners : {&normal, &position})
    for (Vec3Lanes& v : *of_corners) spread(v.x), spread(v.y), spread(v.z);
}

void ScreenGroup::put_inner_cell(int lane) {
  const int cell = cells == 1 ? -1 : lane % 4;  // 3: the middle one
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 3; ++k) {
      const int corner = std::min(i, 2);
      const float own = corner == k ? 1 : 0, towards = k == cell ? 1 : 0;
      share[i][k].of[lane] = cell < 0 ? own : cell == 3 ? (1 - own) / 2 : (own + towards) / 2;
    }
}

/// Where a corner lies beyond the horizon of the triangle's plane, 1/w is not positive: then w is
/// NaN, and nothing is known.
void ScreenGroup::put_rectangle(const DrawnTriangle& drawn, const Rect& r, int lane) {
  const auto& v = drawn.vertices;
  double scale[3];
  for (int k = 0; k < 3; ++k) scale[k] = 1 / (double(area_of(drawn)) * double(w[k].of[lane]));
  for (int i = 0; i < 4; ++i) {
    const int at_x = i % 2 ? r.x_end : r.x_begin, at_y = i / 2 ? r.y_end : r.y_begin;
    double over_w[3], sum = 0;
    for (int k = 0; k < 3; ++k) {
      over_w[k] = double(edge_function(v[(k + 1) % 3], v[(k + 2) % 3], at_x, at_y)) * scale[k];
      sum += over_w[k];
    }
    const double inverse = sum > 0 ? 1 / sum : std::numeric_limits<double>::quiet_NaN();
    for (int k = 0; k < 3; ++k) share[i][k].of[lane] = float(over_w[k] * inverse);
  }
}

/// With n = sum(l_k w_k (a_k - centre)) and d = sum(l_k w_k), both linear in x, is a = centre +
/// n/d: a' = (n' - (a - centre) d') / d and a'' = -2 a' d' / d.
BoundedVector ScreenGroup::attribute(const Vec3<Batch> (&corner)[3]) const {
  Vec3<Batch> cell[4];
  Batch greatest_w = 0, least_w = Bounded::no_limit, shares = 0;
  for (int i = 0; i < 4; ++i) {
    cell[i] = at_corner(i, corner[0], corner[1], corner[2]);
    const Batch w_there = at_corner<Batch>(i, w[0], w[1], w[2]);
    greatest_w = max(greatest_w, w_there), least_w = min(least_w, w_there);
    shares =
        max(shares, abs(Batch(share[i][0])) + abs(Batch(share[i][1])) + abs(Batch(share[i][2])));
  }
  const Vec3<Batch> centre = (cell[0] + cell[1] + cell[2] + cell[3]) * Batch(0.25f);
  // The engine's own numbers are rounded, too: it sees the attribute jitter by so much.
  const Batch rounding = Batch(5e-7f) * shares * (abs(centre.x) + abs(centre.y) + abs(centre.z));
  const Batch inverse = greatest_w;  // 1 / d, at most
  const Batch middle = Batch(0.5f) * (least_w + greatest_w), off = greatest_w - middle;
  Vec3<Batch> growth{Batch(0), Batch(0), Batch(0)};
  Batch radius2 = 0, change = 0, changes = 0;
  for (const Vec3<Batch>& c : cell) radius2 = max(radius2, dot(c - centre, c - centre));
  for (int k = 0; k < 3; ++k) {
    growth = growth + (corner[k] - centre) * Batch(step[k]);
    change += step[k], changes += abs(Batch(step[k]));
  }
  const Batch turn = abs(change) * inverse, radius = sqrt(radius2) + rounding;
  const Batch fast = sqrt(dot(growth, growth));
  const Batch unsteadiness =
      mul_add(fast, off, mul_add(radius, turn, rounding * changes * inverse));
  const Batch speed = mul_add(fast, middle, unsteadiness);
  return {centre, radius, growth * middle, unsteadiness, Batch(2) * speed * turn};
}

Batch ScreenGroup::largest(Batch a) const {
  if (cells == 1) return a;
  if (cells == Batch::lanes)
    return Batch(hn::MaxOfLanes(Batch::tag, a.raw)) +
           Batch(0) * Batch(hn::SumOfLanes(Batch::tag, a.raw));
  a = max(a, Batch(hn::Reverse2(Batch::tag, a.raw))) + Batch(0) * a;  // NaN stays
  return max(a, Batch(hn::Reverse4(Batch::tag, a.raw))) + Batch(0) * a;
}

Batch ScreenGroup::sum(Batch a) const {
  if (cells == 1) return a;
  if (cells == Batch::lanes) return Batch(hn::SumOfLanes(Batch::tag, a.raw));
  a = a + Batch(hn::Reverse2(Batch::tag, a.raw));
  return a + Batch(hn::Reverse4(Batch::tag, a.raw));
}

Bounded ScreenGroup::of_triangle(const Bounded& of_cell) const {
  return {-largest(-of_cell.lo), largest(of_cell.hi), largest(of_cell.slope),
          largest(of_cell.curvature), sum(of_cell.kink)};
}

BoundedDirection to_viewer(const Frame& frame, const ScreenGroup& group,
                           const BoundedVector& position) {
  const Viewer& viewer = frame.viewer;
  if (viewer.far) return {.centre = broadcast(viewer.direction)};
  if (frame.settings.samples > 1) return direction(towards(broadcast(viewer.eye), position));
  // A pixel's own ray, as place() has it: linear in x and y.
  const Vec3<Batch> right = broadcast(viewer.right), below = broadcast(viewer.below);
  Vec3<Batch> corner[4];
  for (int i = 0; i < 4; ++i) {
    const Batch depth[3] = {group.w[0], group.w[1], group.w[2]};
    const Batch inverse = Batch(1) / group.at_corner(i, depth[0], depth[1], depth[2]);
    const Batch x =
        group.at_corner(i, depth[0] * group.x[0], depth[1] * group.x[1], depth[2] * group.x[2]);
    const Batch y =
        group.at_corner(i, depth[0] * group.y[0], depth[1] * group.y[1], depth[2] * group.y[2]);
    corner[i] = broadcast(viewer.first) + right * (x * inverse) + below * (y * inverse);
  }
  const Vec3<Batch> centre = (corner[0] + corner[1] + corner[2] + corner[3]) * Batch(0.25f);
  Batch radius2 = 0;
  for (const Vec3<Batch>& c : corner) radius2 = max(radius2, dot(c - centre, c - centre));
  return direction({.centre = centre,
                    .radius = sqrt(radius2) + Batch(2e-6f),
                    .velocity = right,
                    .unsteadiness = Batch(0),
                    .acceleration = Batch(0)});
}

}  // namespace scanlit
