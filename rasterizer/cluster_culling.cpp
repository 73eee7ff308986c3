#include "rasterizer/cluster_culling.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <limits>

namespace scanlit {

namespace {

constexpr double u = 0x1p-24;  // half a unit in float's last place

// A little more than 4 u, for the rounding of these tests themselves, in double.
constexpr double row_error = 4.001 * u;

// Where subnormals are flushed to zero, 2^-126 may be lost of any factor; u times this.
constexpr double flushed = 0x1p-102;

}  // namespace

ClusterCuller::ClusterCuller(const Draw& draw, const Viewport& viewport)
    : clip_from_object_(draw.clip_from_object),
      half_width_(viewport.width * double(half_pixel)),
      half_height_(viewport.height * double(half_pixel)),
      draw_back_faces_(draw.draw_back_faces) {
  for (int column = 0; column < 4; ++column)
    magnitudes_[column] = glm::abs(clip_from_object_[column]) + flushed;
  for (int i = 0; i < 4; ++i) {
    rows_[i] = glm::dvec3(glm::row(clip_from_object_, i));
    lengths_[i] = glm::length(rows_[i]);
  }
  const auto& [x, y, z, w] = rows_;
  const double eye_side = draw.mirrored ? -1 : 1;
  x_y_ = eye_side * glm::cross(x, y);
  y_w_ = eye_side * glm::cross(y, w);
  w_x_ = eye_side * glm::cross(w, x);
  // What cancels in it is wrong by less than the second term.
  determinant_ =
      std::abs(glm::dot(x, glm::cross(y, w))) + 0x1p-49 * lengths_[0] * lengths_[1] * lengths_[3];

  const auto plane = [&](const glm::dvec4& f) {
    return Plane{f, glm::length(f.x * x + f.y * y + f.z * z + f.w * w)};
  };
  depth_ = {plane({0, 0, -1, 1}), plane({0, 0, 1, 0})};
  const auto sides = [&](double width, double height) {
    return std::array{plane({1, 0, 0, width}), plane({-1, 0, 0, width}), plane({0, 1, 0, height}),
                      plane({0, -1, 0, height})};
  };
  // Beyond the picture's edge by more than snapping moves a vertex and float's division and
  // products are wrong: what lies outside of these has no sample in the picture even then.
  const auto beyond = [](double half_size) { return 1 + 1.5 / half_size + 8 * u; };
  picture_ = sides(beyond(half_width_), beyond(half_height_));
  guard_band_ = sides(double(viewport.guard_x()), double(viewport.guard_y()));
}

ClusterCuller::Extent ClusterCuller::extent(const glm::dvec3& centre, double radius) const {
  Extent e;
  e.centre = clip_from_object_ * glm::dvec4(centre, 1);
  e.error = row_error * (magnitudes_ * glm::dvec4(glm::abs(centre) + (radius + flushed), 1));
  e.radius = radius;
  e.least_w = e.centre.w - lengths_[3] * radius - e.error.w;
  return e;
}

// Each comparison is false where something is NaN or infinite: the answer then is `crossing`.
ClusterView ClusterCuller::view(const Extent& e) const {
  // Twice the vertices' rounding: a corner that clip() makes is wrong by far less than they are.
  // It moves corners to z = w, so the rounding of z is in that of every plane.
  const auto outside = [&](const Plane& p) {
    const double error = glm::dot(glm::abs(p.rows), e.error) + e.error.z;
    return glm::dot(p.rows, e.centre) < -(p.gradient * e.radius + 2 * error);
  };
  const auto inside = [&](const Plane& p) {
    const double error = glm::dot(glm::abs(p.rows), e.error);
    return glm::dot(p.rows, e.centre) >= p.gradient * e.radius + error;
  };
  for (const Plane& plane : depth_)
    if (outside(plane)) return ClusterView::outside;
  for (const Plane& plane : picture_)
    if (outside(plane)) return ClusterView::outside;

  for (const Plane& plane : depth_)
    if (!inside(plane)) return ClusterView::crossing;
  for (const Plane& plane : guard_band_)
    if (!inside(plane)) return ClusterView::crossing;
  // Beyond 1e18 a vertex is out of range. Its rounding error is known, and proportional.
  const double largest = 0.99e18 * row_error;
  const bool in_range =
      e.error.x <= largest && e.error.y <= largest && e.error.z <= largest && e.error.w <= largest;
  return in_range ? ClusterView::inside : ClusterView::crossing;
}

bool ClusterCuller::back_facing(const Cluster& cluster, const Extent& e) const {
  if (!(e.least_w > 0)) return false;
  const auto& [x, y, z, w] = rows_;
  const auto& [length_x, length_y, length_z, length_w] = lengths_;

  const glm::dvec3 to_eye = x_y_ * e.centre.w + y_w_ * e.centre.x + w_x_ * e.centre.y;
  // Of axis, cosine and sine, each stored as float; and of double where to_eye cancels.
  const double error = 0x1p-20 * glm::length(to_eye) + 0x1p-26 * (length_x * length_y * e.error.w +
                                                                  length_y * length_w * e.error.x +
                                                                  length_w * length_x * e.error.y);
  const glm::dvec3 axis(cluster.axis);
  const double towards = glm::dot(axis, to_eye) * double(cluster.cosine) +
                         glm::length(glm::cross(axis, to_eye)) * double(cluster.sine) +
                         determinant_ * double(cluster.plane_distance) + error;
  if (!(towards < 0)) return false;

  // How far a vertex may be drawn from where it is, and by how much a side is stretched.
  const auto moved_and_stretched = [&](const glm::dvec3& row, double length, double centre,
                                       double row_rounding, double half_size) {
    const double farthest = (std::abs(centre) + length * e.radius + row_rounding) / e.least_w;
    const double moved = 0.5 + half_size * ((row_rounding + farthest * e.error.w) / e.least_w +
                                            row_error * (1 + farthest));
    const double stretch = glm::distance(row, w * (centre / e.centre.w)) +
                           1e-12 * (length + farthest * length_w);  // where they cancel
    return glm::dvec2(moved, half_size * stretch);
  };
  const glm::dvec2 h = moved_and_stretched(x, length_x, e.centre.x, e.error.x, half_width_);
  const glm::dvec2 v = moved_and_stretched(y, length_y, e.centre.y, e.error.y, half_height_);
  const double moved = glm::length(glm::dvec2(h.x, v.x));
  // The place on the screen, and with it the stretch, differs over the cluster.
  const double stretch =
      glm::length(glm::dvec2(h.y, v.y)) / e.least_w * (1 + length_w * e.radius / e.least_w);
  const double most_w = e.centre.w + length_w * e.radius;
  const double height = half_width_ * half_height_ * -towards * double(cluster.height) /
                        (most_w * most_w * most_w * stretch);
  return height > 2.0001 * moved;
}

ClusterView ClusterCuller::view(const Cluster& cluster) const {
  const Extent e = extent(glm::dvec3(cluster.centre), double(cluster.radius));
  const ClusterView result = view(e);
  const bool culled = result == ClusterView::inside && !draw_back_faces_ && back_facing(cluster, e);
  return culled ? ClusterView::back_facing : result;
}

ClusterView ClusterCuller::view(const Sphere& bounds) const {
  return view(extent(bounds.centre, bounds.radius));
}

ScreenBounds ClusterCuller::screen_bounds(const Sphere& sphere) const {
  constexpr int farthest = 1 << 24;  // pixels: far outside, and an int holds it
  const Extent e = extent(sphere.centre, sphere.radius);
  if (!(e.least_w > 0))  // rounding has eaten it up: nothing is known
    return {{-farthest, -farthest, farthest, farthest}, std::numeric_limits<double>::infinity()};
  const double most_w = e.centre.w + lengths_[3] * e.radius + e.error.w;
  const auto divided = [&](double largest) { return largest / (largest > 0 ? e.least_w : most_w); };
  // From -1 to 1 in the picture.
  const auto range = [&](double centre, double length, double error) {
    const double reach = length * e.radius + error;
    return std::array{-divided(reach - centre), divided(reach + centre)};
  };
  const auto x = range(e.centre.x, lengths_[0], e.error.x);
  const auto y = range(e.centre.y, lengths_[1], e.error.y);
  // Snapping moves vertices by half of 1/256 pixel, and float's product with half the size, of at
  // most 2^13 pixels, by less than twice as much.
  const double moved = 0x1p-6;
  const auto pixel = [&](double half_size, double place, double beyond) {
    const double pixels = (half_size + half_size * place) / subpixel + beyond;
    return int(std::floor(std::clamp(pixels, -double(farthest), double(farthest))));
  };
  const Rect pixels{pixel(half_width_, x[0], -moved), pixel(half_height_, -y[1], -moved),
                    pixel(half_width_, x[1], moved) + 1, pixel(half_height_, -y[0], moved) + 1};
  // Division rounds, and interpolation three times more, each time by less than 2^-23.
  const double nearest = divided(e.centre.z + lengths_[2] * e.radius + e.error.z);
  return {pixels, nearest + 0x1p-20 * std::abs(nearest)};
}

}  // namespace scanlit
