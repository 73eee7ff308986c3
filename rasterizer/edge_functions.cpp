#include "rasterizer/edge_functions.h"

#include <hwy/cache_control.h>

#include <algorithm>

#include "rasterizer/doubles.h"

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

  /// edge_function(a, b, p), in doubles, which hold it exactly (see Viewport).
  Doubles edge(int a, int b, IntVector px, IntVector py) const {
    return Doubles::from(hn::Sub(y[b], y[a])) * Doubles::from(hn::Sub(px, x[a])) -
           Doubles::from(hn::Sub(x[b], x[a])) * Doubles::from(hn::Sub(py, y[a]));
  }
  Doubles twice_area() const { return edge(0, 1, x[2], y[2]); }

  static IntVector least(const IntVector (&v)[3]) { return hn::Min(v[0], hn::Min(v[1], v[2])); }
  static IntVector most(const IntVector (&v)[3]) { return hn::Max(v[0], hn::Max(v[1], v[2])); }
  static IntVector extent(const IntVector (&v)[3]) { return hn::Sub(most(v), least(v)); }
  IntVector middle_column() const { return hn::ShiftRight<9>(hn::Add(least(x), most(x))); }
  /// At most 16 pixels wide and high: edge functions are whole numbers of at most 2^24 in it, which
  /// float holds.
  hn::Mask<Ints> small() const {
    return hn::Lt(hn::Max(extent(x), extent(y)), hn::Set(ints, 16 * subpixel + 1));
  }
  /// Where distances differ by more than a factor of 2, or a coordinate by more than 4 over the
  /// width of the triangle's box, rounding errors grow as much.
  Batch::Mask imprecise() const {
    const auto& [a, b, c] = inv_w;
    const auto in_float = [](IntVector v) { return Batch(hn::ConvertTo(Batch::tag, v)); };
    const Batch growth = in_float(extent(x)) * in_float(extent(y));
    return (max(a, max(b, c)) > Batch(2) * min(a, min(b, c))) |
           (growth > Batch(4) * abs(twice_area().rounded()));
  }
};

EdgeFunctions::EdgeFunctions(const Frame& frame, FragmentSpan& span) {
  const bool perspective = frame.settings.interpolation == Interpolation::perspective;
  for (int r = 0; r < span.run_count; r += Batch::lanes) {
    const Corners corners(span, r, perspective);
    put_functions(corners, r, span);
    put_sides(frame, corners, r, span);
  }
}

void EdgeFunctions::put_functions(const Corners& corners, int r, const FragmentSpan& span) {
  std::uint32_t pixel[max_lanes];
  for (int i = 0; i < Batch::lanes; ++i)
    pixel[i] = span.pixel[span.runs[std::min(r + i, span.run_count - 1)].first];
  const auto packed = hn::LoadU(hn::RebindToUnsigned<Batch::Tag>(), pixel);
  const IntVector begin = hn::And(hn::BitCast(ints, packed), hn::Set(ints, 0xffff));
  const IntVector row = hn::BitCast(ints, hn::ShiftRight<16>(packed));
  // Where rounding is to be seen, not where the run begins: that depends on what hides it, and on
  // tiles. From the triangle's middle column products are smallest, and so is what they lose.
  const IntVector column = hn::IfThenElse(corners.small(), begin, corners.middle_column());
  Batch(hn::ConvertTo(Batch::tag, column)).store(column_ + r);

  const Doubles edge_1 = corners.edge(2, 0, centre(column), centre(row));
  const Doubles edge_2 = corners.edge(0, 1, centre(column), centre(row));
  // That of corner 0 too is exact: a difference in float would lose its digits where it is small.
  (corners.twice_area() - edge_1 - edge_2).rounded().store(first_[0] + r);
  edge_1.rounded().store(first_[1] + r);
  edge_2.rounded().store(first_[2] + r);
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k) {
    const int from = (k + 1) % 3, to = (k + 2) % 3;
    const Batch per_unit = hn::ConvertTo(Batch::tag, hn::Sub(corners.y[to], corners.y[from]));
    (per_unit * Batch(subpixel)).store(per_pixel_[k] + r);
    corners.inv_w[k].store(inv_w_[k] + r);
  }
}

void EdgeFunctions::put_sides(const Frame& frame, const Corners& corners, int r,
                              FragmentSpan& span) {
  const unsigned small = bits_of(Batch::Mask{hn::RebindMask(Batch::tag, corners.small())});
  const unsigned imprecise = bits_of(corners.imprecise()) & ~small;
  const float front = span.draw->mirrored ? -1 : 1;
  select(corners.twice_area().rounded() < Batch(0), -front, front).store(span.facing + r);
  const int end = std::min(Batch::lanes, span.run_count - r);
  for (int i = 0; i < end; ++i) {
    const DrawnTriangle& drawn = *span.runs[r + i].drawn;
    const bool cut = drawn.piece != DrawnTriangle::not_cut;
    if ((imprecise >> i & 1) || cut || span.with_derivatives)
      others_[other_count_++] = std::uint16_t(r + i);
    // Shading asks for them next.
    if (span.draw->object->shading == Shading::gouraud) {
      const Chunk& chunk = frame.chunks[drawn.chunk];
      hwy::Prefetch(&chunk.lit.corners[3 * chunk.number_of(drawn)]);
    } else {
      hwy::Prefetch(&span.draw->mesh->indices[3 * std::size_t(drawn.triangle)]);
    }
  }
}

}  // namespace scanlit
