// What is said of the comparison's targets: the worst scene counts, and what was not measured or
// differs does not.
#include <gtest/gtest.h>

#include "tests/bench/versus_targets.h"

namespace scanlit::bench {
namespace {

SceneResult result(const std::string& scene, int threads, double scanlit_ms, double llvmpipe_ms) {
  SceneResult r{.scene = scene,
                .peer = {},
                .threads = threads,
                .scanlit = {scanlit_ms, scanlit_ms / 2},
                .buffer = {llvmpipe_ms, llvmpipe_ms},
                .framebuffer_object = {},
                .yardstick = {},
                .difference = {},
                .stages = {}};
  r.same = true;
  return r;
}

const TargetResult* find(const std::vector<TargetResult>& all, const std::string& what) {
  for (const TargetResult& target : all)
    if (target.what == what) return &target;
  return nullptr;
}

TEST(BenchTargets, TheWorstSceneCounts) {
  const std::vector<TargetResult> reached =
      targets({result("S5F", 2, 10, 200), result("S5B", 2, 12, 600), result("S5M", 2, 15, 600)},
              {.scanlit_ms = 20, .compiling_ms = 80, .cached_ms = 60});
  const TargetResult* const least = find(reached, "S5F, S5B, S5M");
  ASSERT_TRUE(least);
  EXPECT_EQ(least->worst, "S5F");
  EXPECT_DOUBLE_EQ(least->by_median, 20);
  EXPECT_DOUBLE_EQ(least->by_least, 40);
  EXPECT_TRUE(least->met());

  const TargetResult* const order = find(reached, "S5B, S5M over S5F");
  ASSERT_TRUE(order);
  EXPECT_EQ(order->worst, "S5M");
  EXPECT_DOUBLE_EQ(order->by_median, 1.5);
  EXPECT_FALSE(order->met());  // at most 1.3

  const TargetResult* const first = find(reached, "first frame, S2");
  ASSERT_TRUE(first);
  EXPECT_DOUBLE_EQ(first->by_median, 4);
  EXPECT_FALSE(first->met());
}

TEST(BenchTargets, OnlyWhatWasMeasuredCounts) {
  SceneResult s9 = result("S9", 2, 1, 20);
  s9.same = false;
  const std::vector<TargetResult> reached =
      targets({s9, result("S2", 1, 18, 20), result("S2", 2, 10, 20)}, {1, 1, 1});
  EXPECT_FALSE(find(reached, "S9"));
  EXPECT_FALSE(find(reached, "geometric mean of S1 to S8P"));
  EXPECT_FALSE(find(reached, "S0 over a memset of the colours"));
  const TargetResult* const scaling = find(reached, "one thread over two, S2 to S6");
  ASSERT_TRUE(scaling);
  EXPECT_DOUBLE_EQ(scaling->by_median, 1.8);
}

TEST(BenchTargets, TheMeanIsGeometric) {
  std::vector<SceneResult> results;
  for (const char* scene : {"S1", "S2", "S3", "S4", "S5F", "S5B", "S5M", "S6", "S7", "S8G"})
    results.push_back(result(scene, 2, 1, 4));
  results.push_back(result("S8P", 2, 1, 4 * 2048));  // 2^11: doubles the mean of eleven
  const auto reached = targets(results, {1, 1, 1});
  const TargetResult* const mean = find(reached, "geometric mean of S1 to S8P");
  ASSERT_TRUE(mean);
  EXPECT_NEAR(mean->by_median, 8, 1e-12);
  EXPECT_NEAR(mean->by_least, 16, 1e-12);
}

}  // namespace
}  // namespace scanlit::bench
