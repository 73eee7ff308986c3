// (8) The corners of a vector of triangles, and their edge functions.
#pragma once

#include <array>

#include "rasterizer/doubles.h"
#include "rasterizer/fragment_span.h"

namespace scanlit {

/// Element k of an edge function belongs to the edge opposite to corner k.
struct CornerVectors {
  static constexpr hn::RebindToSigned<Batch::Tag> ints{};
  using IntVector = hn::Vec<hn::RebindToSigned<Batch::Tag>>;

  IntVector x[3], y[3];  // 1/256 pixel
  Batch inv_w[3];        // all 1 without perspective

  /// Of triangles i, i + 1, ...
  CornerVectors(const ScreenVertex (&vertices)[3][FragmentSpan::padded], int i, bool perspective) {
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
      Batch::Vector vx, vy, depth, w;
      hn::LoadInterleaved4(Batch::tag, reinterpret_cast<const float*>(&vertices[k][i]), vx, vy,
                           depth, w);
      x[k] = hn::BitCast(ints, vx), y[k] = hn::BitCast(ints, vy);
      inv_w[k] = perspective ? Batch(w) : Batch(1);
    }
  }

  IntVector width() const { return hn::Sub(most(x), least(x)); }
  IntVector height() const { return hn::Sub(most(y), least(y)); }
  /// The pixel in the middle of the box.
  IntVector middle_column() const { return middle(x); }
  IntVector middle_row() const { return middle(y); }

  /// At the centres of pixels. Each is exact (see Viewport): as the third is not the difference of
  /// the others, it keeps its digits where it is small.
  std::array<Doubles, 3> edges_at(IntVector column, IntVector row) const {
    const Doubles dx[3] = {distance(x[0], column), distance(x[1], column), distance(x[2], column)};
    const Doubles dy[3] = {distance(y[0], row), distance(y[1], row), distance(y[2], row)};
    const auto edge = [&](int from, int to) { return dx[to] * dy[from] - dy[to] * dx[from]; };
    return {edge(1, 2), edge(2, 0), edge(0, 1)};
  }
  /// By how much one grows with the next pixel on the right, or below.
  Batch growth_right(int k) const { return per_pixel(y[(k + 2) % 3], y[(k + 1) % 3]); }
  Batch growth_below(int k) const { return per_pixel(x[(k + 1) % 3], x[(k + 2) % 3]); }

 private:
  static IntVector least(const IntVector (&v)[3]) { return hn::Min(v[0], hn::Min(v[1], v[2])); }
  static IntVector most(const IntVector (&v)[3]) { return hn::Max(v[0], hn::Max(v[1], v[2])); }
  static IntVector middle(const IntVector (&v)[3]) {
    return hn::ShiftRight<9>(hn::Add(least(v), most(v)));
  }
  static Doubles distance(IntVector corner, IntVector pixel) {
    const IntVector centre = hn::Add(hn::ShiftLeft<8>(pixel), hn::Set(ints, half_pixel));
    return Doubles::from(hn::Sub(corner, centre));
  }
  static Batch per_pixel(IntVector to, IntVector from) {
    return Batch(hn::ConvertTo(Batch::tag, hn::Sub(to, from))) * Batch(subpixel);
  }
};

}  // namespace scanlit
