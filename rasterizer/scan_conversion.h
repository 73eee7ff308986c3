// (7) Scan conversion: which pixel centres a triangle covers, exactly.
//
// A pixel is covered if its centre lies strictly inside the triangle, or on one of its left edges
// or on its horizontal top edge (the top-left rule): of two triangles that share an edge exactly
// one covers a centre on it. With y half-open that is: rows whose centre lies in [y_min, y_max),
// and in each row the half-open span from the left edges' crossing to the right edges', both
// rounded up to the next centre. All in integers (see Viewport in pipeline.h for why they cannot
// overflow), so coverage is that of exact arithmetic on the snapped vertices.
#pragma once

#include <algorithm>

#include "rasterizer/pipeline.h"

namespace scanlit {

/// The pixels whose centres lie in a triangle's box [x_min, x_max) x [y_min, y_max), outside of
/// which it covers none. Not limited to the picture; may be empty.
inline Rect centre_bounds(const ScreenTriangle& triangle) {
  const auto& [a, b, c] = triangle.vertices;
  const int x_min = std::min(a.x, std::min(b.x, c.x)), x_max = std::max(a.x, std::max(b.x, c.x));
  const int y_min = std::min(a.y, std::min(b.y, c.y)), y_max = std::max(a.y, std::max(b.y, c.y));
  const int up = half_pixel - 1;  // up to the next centre; the shifts round down
  return {(x_min + up) >> 8, (y_min + up) >> 8, (x_max + up) >> 8, (y_max + up) >> 8};
}

/// By minus an offset: a sample lies there where its pixel's centre was.
inline ScreenTriangle moved(ScreenTriangle triangle, const SampleOffset& offset) {
  for (ScreenVertex& vertex : triangle.vertices) vertex.x -= offset.x, vertex.y -= offset.y;
  return triangle;
}

inline std::int64_t floor_divide(std::int64_t a, std::int64_t positive) {
  const std::int64_t q = a / positive;
  return q - (a % positive < 0);
}

/// Follows one edge down the rows. In each row column() is the first pixel column whose centre lies
/// on the crossing or to the right of it: ceil(N / D) with
///   D = 256 |b.y - a.y|,  N = (a.x - 128) |b.y - a.y| + (y - a.y) (b.x - a.x) sign(b.y - a.y),
/// y the row's centre. The next row's is reached by adding quotient and remainder, as in
/// Bresenham's line, without division and without error.
class EdgeWalker {
 public:
  EdgeWalker() = default;
  EdgeWalker(const ScreenVertex& a, const ScreenVertex& b, int row) {
    const std::int64_t height = std::abs(std::int64_t(b.y) - a.y);
    const std::int64_t run = b.y > a.y ? b.x - a.x : a.x - b.x;
    const std::int64_t y = std::int64_t(row) * subpixel + half_pixel;
    divisor_ = subpixel * height;
    const std::int64_t numerator = (a.x - half_pixel) * height + (y - a.y) * run;
    const std::int64_t rounded_up = numerator + divisor_ - 1;
    column_ = floor_divide(rounded_up, divisor_);
    remainder_ = rounded_up - column_ * divisor_;
    column_step_ = floor_divide(run, height);
    remainder_step_ = (run - column_step_ * height) * subpixel;
  }

  std::int64_t column() const { return column_; }

  void next_row() {
    column_ += column_step_;
    remainder_ += remainder_step_;
    const bool carry = remainder_ >= divisor_;
    column_ += carry;
    remainder_ -= carry ? divisor_ : 0;
  }

 private:
  std::int64_t column_ = 0, column_step_ = 0;
  std::int64_t remainder_ = 0, remainder_step_ = 0, divisor_ = 1;
};

/// Calls emit(y, x_begin, x_end) for each row y in [y_begin, y_end) in which the triangle covers
/// the non-empty half-open span of pixels [x_begin, x_end); x is not limited to the picture.
template <class Emit>
void for_each_span(const ScreenTriangle& triangle, int y_begin, int y_end, const Emit& emit) {
  if (triangle.twice_area == 0) return;
  const auto& [a, b, c] = triangle.vertices;
  const Rect bounds = centre_bounds(triangle);
  const int first_row = std::max(y_begin, bounds.y_begin);
  const int end_row = std::min(y_end, bounds.y_end);
  if (first_row >= end_row) return;

  // Going around a front face with y down, left edges run down and right edges run up.
  EdgeWalker left[2], right[2];
  int left_count = 0, right_count = 0;
  const ScreenVertex edges[3][2] = {{a, b}, {b, c}, {c, a}};
  for (const auto& [from, to] : edges) {
    if (from.y == to.y) continue;
    const bool runs_down = to.y > from.y;
    if (runs_down == (triangle.twice_area > 0))
      left[left_count++] = EdgeWalker(from, to, first_row);
    else
      right[right_count++] = EdgeWalker(from, to, first_row);
  }
  // One side has one edge, the other two, unless an edge is horizontal.
  for (int y = first_row; y < end_row; ++y) {
    std::int64_t x_begin = left[0].column(), x_end = right[0].column();
    left[0].next_row(), right[0].next_row();
    if (left_count == 2) {
      x_begin = std::max(x_begin, left[1].column());
      left[1].next_row();
    }
    if (right_count == 2) {
      x_end = std::min(x_end, right[1].column());
      right[1].next_row();
    }
    if (x_begin < x_end) emit(y, int(x_begin), int(x_end));
  }
}

/// Depth over a triangle (which must outlive it), linear on the screen. Once per row in double from
/// exact edge functions, rounded once; within a row by one unfused float step from the row's first
/// covered pixel. So it is as precise in a sliver as in any triangle, and never outside the
/// triangle's own depths.
class DepthPlane {
 public:
  explicit DepthPlane(const ScreenTriangle& t)
      : a_(t.vertices[0]),
        b_(t.vertices[1]),
        c_(t.vertices[2]),
        inverse_area_(1.0 / double(t.twice_area)),
        to_b_(double(b_.depth) - double(a_.depth)),
        to_c_(double(c_.depth) - double(a_.depth)) {}

  /// At the centre of a pixel.
  float at(int column, int row) const {
    const std::int64_t x = std::int64_t(column) * subpixel + half_pixel;
    const std::int64_t y = std::int64_t(row) * subpixel + half_pixel;
    const double weight_b = double(edge_function(c_, a_, x, y));
    const double weight_c = double(edge_function(a_, b_, x, y));
    return float(depth(weight_b, weight_c));
  }
  /// Change from one pixel to the next in a row.
  float per_pixel() const {
    const double weight_b = double(a_.y - c_.y), weight_c = double(b_.y - a_.y);
    return float((weight_b * to_b_ + weight_c * to_c_) * inverse_area_ * subpixel);
  }

  /// at() for many pixels, not rounded yet; in double or vectors of doubles. The same whole
  /// numbers, added up as doubles, which hold them exactly.
  class Rows {
   public:
    explicit Rows(const DepthPlane& plane)
        : plane_(plane),
          b_(double(edge_function(plane.c_, plane.a_, half_pixel, half_pixel))),
          c_(double(edge_function(plane.a_, plane.b_, half_pixel, half_pixel))),
          b_per_column_(double(plane.a_.y - plane.c_.y) * subpixel),
          b_per_row_(double(plane.c_.x - plane.a_.x) * subpixel),
          c_per_column_(double(plane.b_.y - plane.a_.y) * subpixel),
          c_per_row_(double(plane.a_.x - plane.b_.x) * subpixel) {}

    template <class T>
    T at(const T& column, const T& row) const {
      return plane_.depth(T(b_) + column * T(b_per_column_) + row * T(b_per_row_),
                          T(c_) + column * T(c_per_column_) + row * T(c_per_row_));
    }

   private:
    const DepthPlane& plane_;
    double b_, c_, b_per_column_, b_per_row_, c_per_column_, c_per_row_;
  };

  float min() const { return std::min(a_.depth, std::min(b_.depth, c_.depth)); }
  float max() const { return std::max(a_.depth, std::max(b_.depth, c_.depth)); }

 private:
  template <class T>
  T depth(const T& weight_b, const T& weight_c) const {
    return T(double(a_.depth)) + (weight_b * T(to_b_) + weight_c * T(to_c_)) * T(inverse_area_);
  }

  const ScreenVertex &a_, &b_, &c_;
  double inverse_area_, to_b_, to_c_;
};

}  // namespace scanlit
