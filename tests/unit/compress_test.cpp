// compressed: of every mask, its lanes in order.
#include "rasterizer/compress.h"

#include <gtest/gtest.h>

#include <vector>

namespace scanlit {
namespace {

TEST(Compressed, BringsTheLanesOfEveryMaskTogether) {
  constexpr hn::RebindToSigned<Batch::Tag> ints;
  for (unsigned bits = 0; bits < 1u << Batch::lanes; ++bits) {
    std::int32_t in_mask[Batch::lanes], whole[Batch::lanes];
    float part[Batch::lanes];
    std::vector<int> expected;
    for (int lane = 0; lane < Batch::lanes; ++lane) {
      in_mask[lane] = int(bits >> lane & 1);
      if (in_mask[lane]) expected.push_back(lane);
    }
    const auto mask = hn::Eq(hn::LoadU(ints, in_mask), hn::Set(ints, 1));
    const auto lanes = hn::Iota(ints, 0);
    hn::StoreU(compressed(lanes, mask), ints, whole);
    const auto halves = Batch::iota(0) * Batch(0.5f);
    Batch(compressed(halves.raw, hn::RebindMask(Batch::tag, mask))).store(part);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(whole[i], expected[i]) << "mask " << bits;
      ASSERT_EQ(part[i], 0.5f * float(expected[i])) << "mask " << bits;
    }
  }
}

}  // namespace
}  // namespace scanlit
