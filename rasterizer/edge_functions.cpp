#include "rasterizer/edge_functions.h"

namespace scanlit {

namespace {

using Ints = hn::RebindToSigned<Batch::Tag>;
using IntVector = hn::Vec<Ints>;
constexpr Ints ints;

IntVector centre(IntVector pixel) {
  return hn::Add(hn::ShiftLeft<8>(pixel), hn::Set(ints, half_pixel));
}

}  // namespace

/// Of the triangles of a vector of runs.
struct EdgeFunctions::Corners {
  IntVector x[3], y[3];
  Batch inv_w[3];

  Corners(const ScreenVertex (&vertices)[3][FragmentSpan::padded], int r, bool perspective) {
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
      Batch::Vector vx, vy, depth, w;
      hn::LoadInterleaved4(Batch::tag, reinterpret_cast<const float*>(&vertices[k][r]), vx, vy,
                           depth, w);
      x[k] = hn::BitCast(ints, vx), y[k] = hn::BitCast(ints, vy);
      inv_w[k] = perspective ? Batch(w) : Batch(1);
    }
  }

  static IntVector least(const IntVector (&v)[3]) { return hn::Min(v[0], hn::Min(v[1], v[2])); }
  static IntVector most(const IntVector (&v)[3]) { return hn::Max(v[0], hn::Max(v[1], v[2])); }
  static IntVector extent(const IntVector (&v)[3]) { return hn::Sub(most(v), least(v)); }
  IntVector middle_column() const { return hn::ShiftRight<9>(hn::Add(least(x), most(x))); }
  /// At most 16 pixels wide and high: edge functions are whole numbers of at most 2^24 in it, which
  /// float holds.
  Batch::Mask small() const {
    return {hn::RebindMask(
        Batch::tag, hn::Lt(hn::Max(extent(x), extent(y)), hn::Set(ints, 16 * subpixel + 1)))};
  }
};

EdgeFunctions::EdgeFunctions(const Frame& frame, const FragmentSpan& span) {
  const bool perspective = frame.settings.interpolation == Interpolation::perspective;
  for (int r = 0; r < span.run_count; ++r) {
    const DrawnTriangle& drawn = *span.runs[r].drawn;
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) vertices_[k][r] = drawn.vertices[k];
  }
  for (int r = 0; r < span.run_count; r += Batch::lanes)
    put_functions(Corners(vertices_, r, perspective), r, span);
}

void EdgeFunctions::put_functions(const Corners& corners, int r, const FragmentSpan& span) {
  const auto packed = hn::LoadU(hn::RebindToUnsigned<Batch::Tag>(), span.first_pixel + r);
  const IntVector begin = hn::And(hn::BitCast(ints, packed), hn::Set(ints, 0xffff));
  const IntVector row = hn::BitCast(ints, hn::ShiftRight<16>(packed));
  // Where rounding is to be seen, not where the run begins: that depends on what hides it, and on
  // tiles. From the triangle's middle column products are smallest, and so is what they lose.
  const auto small = hn::RebindMask(ints, corners.small().raw);
  const IntVector column = hn::IfThenElse(small, begin, corners.middle_column());
  Batch(hn::ConvertTo(Batch::tag, column)).store(column_ + r);

  // From the pixel's centre to the corners. Each function is exact (see Viewport): as the third is
  // not the difference of the others, it keeps its digits where it is small.
  const auto distance = [](const IntVector(&corner)[3], IntVector pixel, int k) {
    return Doubles::from(hn::Sub(corner[k], centre(pixel)));
  };
  const Doubles x[3] = {distance(corners.x, column, 0), distance(corners.x, column, 1),
                        distance(corners.x, column, 2)};
  const Doubles y[3] = {distance(corners.y, row, 0), distance(corners.y, row, 1),
                        distance(corners.y, row, 2)};
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k) {
    const int from = (k + 1) % 3, to = (k + 2) % 3;
    const Doubles edge = x[to] * y[from] - y[to] * x[from];
    edge.rounded().store(first_[k] + r);
    const Batch per_unit = hn::ConvertTo(Batch::tag, hn::Sub(corners.y[to], corners.y[from]));
    (per_unit * Batch(subpixel)).store(per_pixel_[k] + r);
    corners.inv_w[k].store(inv_w_[k] + r);
  }
}

}  // namespace scanlit
