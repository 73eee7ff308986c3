// (8) Barycentric coordinates: where in its triangle a fragment lies.
//
// Two ways, chosen by the triangle alone, so that a fragment's coordinates do not depend on where
// its run begins:
//   edge functions  (edge_functions.h) in float, for vectors of runs, then of fragments: most
//                   triangles, where more is interpolated than what has planes (planes.h)
//   ExactWeights    all in double, run by run: cut triangles, strong perspective, slivers,
//                   centroids of samples, and where derivatives are wanted
#pragma once

#include "rasterizer/batch.h"
#include "rasterizer/fragment_span.h"

namespace scanlit {

/// Fills b1 and b2 of all fragments where they are needed; else, where anything varies over a
/// triangle, of those of exact runs, to which it adds the centroids'.
void put_barycentric(const Frame& frame, FragmentSpan& span);

/// Those of a vector of fragments, of corners 1 and 2 of the mesh's triangle.
struct Barycentric {
  Batch b1, b2;
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

  /// Point (x, y), in 1/256 pixel, and those so many pixels to the right of it.
  class Row {
   public:
    Row(const ExactWeights& weights, double x, double y);

    Barycentric at(const Batch& pixels) const;
    /// By how much they grow: a vector, from element `first` of the span's derivatives on.
    void store_derivatives(const Batch& pixels, int first, FragmentSpan& span) const;

   private:
    const ExactWeights& weights_;
    Steps linear_[3];
  };

 private:
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
