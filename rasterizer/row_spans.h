// (6), (7) The spans of a triangle, for a vector of rows at a time.
#pragma once

#include <limits>

#include "rasterizer/doubles.h"
#include "rasterizer/scan_conversion.h"

namespace scanlit {

/// Finds what for_each_span emits, and the depth at each span's first pixel. Where that calls for
/// ceil(N / D) in whole numbers, here is the same in double: N and D are exact there, and N / D, if
/// it is not whole, lies at least 1 / D from the next whole number. Rounding takes it less far: by
/// 2^-53 N / D at most, where N < 2^52. The triangle has an area.
class RowSpans {
 public:
  RowSpans(const ScreenTriangle& triangle, const DepthPlane& plane) : depth_(plane) {
    const auto& [a, b, c] = triangle.vertices;
    const ScreenVertex edges[3][2] = {{a, b}, {b, c}, {c, a}};
    for (const auto& [from, to] : edges) {
      if (from.y == to.y) continue;
      // Going around a front face with y down, left edges run down and right edges run up.
      const bool runs_down = to.y > from.y;
      const double height = std::abs(double(to.y) - from.y);
      const double run = runs_down ? double(to.x) - from.x : double(from.x) - to.x;
      edges_[count_++] = {
          .numerator = (from.x - half_pixel) * height + (double(half_pixel) - from.y) * run,
          .per_row = run * subpixel,
          .divisor = height * subpixel,
          .left = runs_down == (triangle.twice_area > 0)};
    }
  }

  /// Pixels [begin, end) of each row, none where begin >= end; and the depth of the first.
  struct Rows {
    std::int32_t begin[max_lanes], end[max_lanes];
    float depth[max_lanes];
  };
  /// Of as many rows as a vector has lanes.
  Rows from(int first_row) const {
    const hn::RebindToSigned<Batch::Tag> ints;
    const Doubles row = Doubles::from(hn::Iota(ints, first_row));
    Doubles begin = -infinity, end = infinity;
    for (int i = 0; i < count_; ++i) {
      const Edge& edge = edges_[i];
      const Doubles crossing =
          ceil((Doubles(edge.numerator) + row * Doubles(edge.per_row)) / Doubles(edge.divisor));
      if (edge.left)
        begin = max(begin, crossing);
      else
        end = min(end, crossing);
    }
    Rows rows;
    hn::StoreU(begin.ints(), ints, rows.begin);
    hn::StoreU(end.ints(), ints, rows.end);
    depth_.at(begin, row).rounded().store(rows.depth);
    return rows;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Of its crossing with the rows' centre lines: see EdgeWalker.
  struct Edge {
    double numerator, per_row, divisor;  // numerator: in row 0
    bool left;
  };

  Edge edges_[3];
  int count_ = 0;
  DepthPlane::Rows depth_;
};

}  // namespace scanlit
