// (8) Barycentric coordinates: where in its triangle a fragment lies.
//
// Three ways, chosen by the triangle and the pixel alone, so that a fragment's coordinates do not
// depend on where its run begins:
//   SmallWeights    exact in float: most triangles of a fine mesh
//   WeightPlanes    planes in float, made once a tile: most triangles of a coarse mesh
//   ExactWeights    edge functions in double: slivers, strong perspective, cut triangles, centroids
#pragma once

#include "rasterizer/batch.h"
#include "rasterizer/pipeline.h"

namespace scanlit {

/// Those of a vector of fragments, of corners 1 and 2 of the mesh's triangle.
struct Barycentric {
  Batch b1, b2;
};

/// Of a triangle whose box is at most 16 pixels wide and high. The edge functions of the pixels in
/// it are whole numbers of at most 2^24, which float holds.
class SmallWeights {
 public:
  static bool fits(const DrawnTriangle& drawn) {
    constexpr int size = 16 * subpixel;
    const auto& [a, b, c] = drawn.vertices;
    const auto extent = [](int p, int q, int r) {
      return std::max(p, std::max(q, r)) - std::min(p, std::min(q, r));
    };
    return drawn.piece == DrawnTriangle::not_cut && extent(a.x, b.x, c.x) <= size &&
           extent(a.y, b.y, c.y) <= size;
  }

  /// Of pixel (x, y) and those to the right of it.
  SmallWeights(const DrawnTriangle& drawn, bool perspective, int x, int y) {
    const auto& [a, b, c] = drawn.vertices;
    const int centre_x = x * subpixel + half_pixel, centre_y = y * subpixel + half_pixel;
    const int ab_x = b.x - a.x, ab_y = b.y - a.y, ca_x = a.x - c.x, ca_y = a.y - c.y;
    twice_area_ = ab_x * ca_y - ab_y * ca_x;
    edge_1_ = Batch(ca_y * (centre_x - c.x) - ca_x * (centre_y - c.y));
    edge_2_ = Batch(ab_y * (centre_x - a.x) - ab_x * (centre_y - a.y));
    step_1_ = Batch(ca_y * subpixel), step_2_ = Batch(ab_y * subpixel);
    for (int k = 0; k < 3; ++k) inv_w_[k] = perspective ? drawn.vertices[k].inv_w : 1.0f;
  }

  bool clockwise() const { return twice_area_ < 0; }

  /// Of the pixels i, i + 1, ... of them; or of those.
  Barycentric at(int i) const { return at(Batch::iota(float(i))); }
  Barycentric at(const Batch& steps) const {
    const Batch edge_1 = mul_add(steps, step_1_, edge_1_);
    const Batch edge_2 = mul_add(steps, step_2_, edge_2_);
    const Batch edge_0 = Batch(twice_area_) - edge_1 - edge_2;
    const Batch w1 = edge_1 * inv_w_[1], w2 = edge_2 * inv_w_[2];
    const Batch inverse_sum = reciprocal(mul_add(edge_0, inv_w_[0], w1 + w2));
    return {w1 * inverse_sum, w2 * inverse_sum};
  }

 private:
  int twice_area_;
  Batch edge_1_, edge_2_, step_1_, step_2_;
  Batch inv_w_[3];
};

/// Of a larger triangle, in perspective: over w, b1, b2 and the sum of all three are planes over
/// the screen.
class WeightPlanes {
 public:
  WeightPlanes() = default;
  explicit WeightPlanes(const DrawnTriangle& drawn);

  /// Whether float holds them: where a coordinate changes by more than 4 over the triangle's box,
  /// or distances differ by more than a factor of 2, rounding errors would grow as much.
  bool precise() const { return precise_; }

  /// Pixel (x, y) and those to the right of it.
  class Row {
   public:
    Row(const WeightPlanes& planes, int x, int y)
        : planes_(planes),
          b1_(planes.on_row(planes.b1_, y)),
          b2_(planes.on_row(planes.b2_, y)),
          sum_(planes.on_row(planes.sum_, y)),
          x_(x - planes.x_) {}

    Barycentric at(int i) const { return at(Batch::iota(float(i))); }
    Barycentric at(const Batch& steps) const {
      const Batch column = Batch(x_) + steps;
      const Batch inverse_sum = reciprocal(mul_add(column, planes_.sum_.right, sum_));
      return {mul_add(column, planes_.b1_.right, b1_) * inverse_sum,
              mul_add(column, planes_.b2_.right, b2_) * inverse_sum};
    }

   private:
    const WeightPlanes& planes_;
    Batch b1_, b2_, sum_;
    int x_;
  };

 private:
  struct Plane {
    float first, right, below;  // at pixel (x_, y_), and its growth per pixel
  };
  Batch on_row(const Plane& plane, int y) const {
    return plane.first + float(y - y_) * plane.below;
  }

  bool precise_ = false;
  int x_, y_;
  Plane b1_, b2_, sum_;
};

/// Of any triangle, at any point of it.
class ExactWeights {
 public:
  ExactWeights(const Frame& frame, const DrawnTriangle& drawn);

  bool clockwise() const { return twice_area_ < 0; }

  /// Whether a point on the screen, in 1/256 pixel, lies in the triangle or on its border.
  bool holds(double x, double y) const;

  /// A weight that is linear on the screen, along a row: (start + i step) scale at point i, in
  /// double, rounded to float once. Exact before the scale if start and step are whole numbers.
  struct Steps {
    double start, step, scale;

    Batch at(const Batch& steps) const;
  };

  /// Point (x, y), in 1/256 pixel, and every 256 units to the right of it. Where the span has
  /// derivatives, at() also stores theirs, from its element `first` on.
  class Row {
   public:
    Row(const ExactWeights& weights, double x, double y, int first, FragmentSpan& span);

    Barycentric at(int i) const;
    Barycentric at(const Batch& steps) const;  // without derivatives

   private:
    const ExactWeights& weights_;
    int first_;
    FragmentSpan& span_;
    Steps linear_[3];
  };

 private:
  void store_derivatives(const Batch (&linear)[3], int at, FragmentSpan& span) const;

  /// The edge functions whose share of twice_area is the screen-linear weight of corner 1 and of
  /// corner 2. Exact where x and y are whole numbers: doubles hold them (see Viewport).
  double edge_1(double x, double y) const {
    const auto& [a, b, c] = drawn_.vertices;
    return double(a.y - c.y) * (x - c.x) - double(a.x - c.x) * (y - c.y);
  }
  double edge_2(double x, double y) const {
    const auto& [a, b, c] = drawn_.vertices;
    return double(b.y - a.y) * (x - a.x) - double(b.x - a.x) * (y - a.y);
  }

  const DrawnTriangle& drawn_;
  const ClippedTriangle* piece_;  // null where the triangle is whole
  double twice_area_;
  bool perspective_;
};

}  // namespace scanlit
