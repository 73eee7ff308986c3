// load_quads: from places in any order, one of them twice.
#include "rasterizer/quads.h"

#include <gtest/gtest.h>

namespace scanlit {
namespace {

TEST(Quads, EachLaneHasTheNumbersOfItsPlace) {
  float numbers[4 * Batch::lanes];
  for (int i = 0; i < 4 * Batch::lanes; ++i) numbers[i] = float(i);
  const auto place = [](int lane) { return lane == 0 ? 1 : (5 * lane + 2) % Batch::lanes; };
  Batch v[4];
  load_quads([&](int lane) { return numbers + 4 * place(lane); }, v);
  for (int c = 0; c < 4; ++c) {
    float lanes[Batch::lanes];
    v[c].store(lanes);
    for (int lane = 0; lane < Batch::lanes; ++lane)
      EXPECT_EQ(lanes[lane], float(4 * place(lane) + c)) << "lane " << lane << " number " << c;
  }
}

}  // namespace
}  // namespace scanlit
