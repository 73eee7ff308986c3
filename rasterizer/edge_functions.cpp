#include "rasterizer/edge_functions.h"

#include "rasterizer/corner_vectors.h"

namespace scanlit {

namespace {

using Unsigned = hn::RebindToUnsigned<Batch::Tag>;
constexpr auto ints = CornerVectors::ints;

/// At most 16 pixels wide and high: edge functions are whole numbers of at most 2^24 in it, which
/// float holds.
hn::Mask<hn::RebindToSigned<Batch::Tag>> small(const CornerVectors& corners) {
  return hn::Lt(hn::Max(corners.width(), corners.height()), hn::Set(ints, 16 * subpixel + 1));
}

}  // namespace

EdgeFunctions::EdgeFunctions(const Frame& frame, const FragmentSpan& span) {
  const bool perspective = frame.settings.interpolation == Interpolation::perspective;
  for (int r = 0; r < span.run_count; ++r) {
    const DrawnTriangle& drawn = *span.runs[r].drawn;
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) vertices_[k][r] = drawn.vertices[k];
  }
  for (int r = 0; r < span.run_count; r += Batch::lanes)
    put_functions(CornerVectors(vertices_, r, perspective), r, span);
}

void EdgeFunctions::put_functions(const CornerVectors& corners, int r, const FragmentSpan& span) {
  const auto packed = hn::LoadU(Unsigned(), span.first_pixel + r);
  const auto begin = hn::And(hn::BitCast(ints, packed), hn::Set(ints, 0xffff));
  const auto row = hn::BitCast(ints, hn::ShiftRight<16>(packed));
  // Where rounding is to be seen, not where the run begins: that depends on what hides it, and on
  // tiles. From the triangle's middle column products are smallest, and so is what they lose.
  const auto column = hn::IfThenElse(small(corners), begin, corners.middle_column());
  Batch(hn::ConvertTo(Batch::tag, column)).store(column_ + r);
  const std::array<Doubles, 3> edges = corners.edges_at(column, row);
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k) {
    edges[std::size_t(k)].rounded().store(first_[k] + r);
    corners.growth_right(k).store(per_pixel_[k] + r);
    corners.inv_w[k].store(inv_w_[k] + r);
  }
}

}  // namespace scanlit
