#include "rasterizer/edge_functions.h"

#include <bit>

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

  Corners(const FragmentSpan& span, int r, bool perspective) {
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
      Batch::Vector vx, vy, depth, w;
      hn::LoadInterleaved4(Batch::tag, reinterpret_cast<const float*>(&span.corners[k][r]), vx, vy,
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
  /// Where distances differ by more than a factor of 2, or a coordinate by more than 4 over the
  /// width of the triangle's box, rounding errors grow as much.
  Batch::Mask imprecise(const Doubles& twice_area) const {
    const auto& [a, b, c] = inv_w;
    const auto in_float = [](IntVector v) { return Batch(hn::ConvertTo(Batch::tag, v)); };
    const Batch growth = in_float(extent(x)) * in_float(extent(y));
    return (max(a, max(b, c)) > Batch(2) * min(a, min(b, c))) |
           (growth > Batch(4) * abs(twice_area.rounded()));
  }
};

EdgeFunctions::EdgeFunctions(const Frame& frame, FragmentSpan& span) {
  const bool perspective = frame.settings.interpolation == Interpolation::perspective;
  const float front = span.draw->mirrored ? -1 : 1;
  for (int r = 0; r < span.run_count; r += Batch::lanes) {
    const Corners corners(span, r, perspective);
    const Doubles twice_area = put_functions(corners, r, span);
    select(twice_area.rounded() < Batch(0), -front, front).store(span.facing + r);
    unsigned imprecise = bits_of(corners.imprecise(twice_area)) & ~bits_of(corners.small());
    for (; imprecise != 0; imprecise &= imprecise - 1)
      if (const int lane = std::countr_zero(imprecise); r + lane < span.run_count)
        imprecise_[imprecise_count_++] = std::uint16_t(r + lane);
  }
}

/// Returns the sums of the three functions.
Doubles EdgeFunctions::put_functions(const Corners& corners, int r, const FragmentSpan& span) {
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
  Doubles sum = 0;
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k) {
    const int from = (k + 1) % 3, to = (k + 2) % 3;
    const Doubles edge = x[to] * y[from] - y[to] * x[from];
    sum = sum + edge;
    edge.rounded().store(first_[k] + r);
    const Batch per_unit = hn::ConvertTo(Batch::tag, hn::Sub(corners.y[to], corners.y[from]));
    (per_unit * Batch(subpixel)).store(per_pixel_[k] + r);
    corners.inv_w[k].store(inv_w_[k] + r);
  }
  return sum;
}

}  // namespace scanlit
