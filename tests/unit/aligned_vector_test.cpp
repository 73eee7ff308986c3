// Vectors that begin at a line of the cache, or at a huge page.
#include "rasterizer/aligned_vector.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <numeric>

#include "rasterizer/fragment_span.h"
#include "rasterizer/framebuffer.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

std::size_t beyond(const void* p, std::size_t unit) {
  return std::size_t(reinterpret_cast<std::uintptr_t>(p)) % unit;
}

TEST(AlignedVector, BeginsAtALineAndALargeOneAtAHugePage) {
  constexpr std::size_t huge_page = 2 << 20;
  for (const std::size_t size : {std::size_t(1), std::size_t(63), std::size_t(4097), huge_page - 1})
    EXPECT_EQ(beyond(AlignedVector<std::uint8_t>(size).data(), cache_line), 0u) << size;
  for (const std::size_t size : {huge_page, huge_page + 1, 5 * huge_page})
    EXPECT_EQ(beyond(AlignedVector<std::uint8_t>(size).data(), huge_page), 0u) << size;
}

TEST(AlignedVector, KeepsWhatItHoldsWhereItGrowsIntoAHugePage) {
  AlignedVector<std::uint32_t> numbers(1000);
  std::iota(numbers.begin(), numbers.end(), 7u);
  numbers.resize(1'000'000, 5u);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    ASSERT_EQ(numbers[i], i < 1000 ? 7u + unsigned(i) : 5u) << i;
}

// So that vectors do not lie in two lines: what is stored in vectors of 16 floats.
TEST(AlignedVector, SpansATilesRowsAndPicturesBeginAtLines) {
  const auto span = std::make_unique<FragmentSpan>();
  for (const void* array :
       {static_cast<const void*>(span->triangle), static_cast<const void*>(span->run),
        static_cast<const void*>(span->pixel), static_cast<const void*>(span->b1),
        static_cast<const void*>(span->planes.start[3]), static_cast<const void*>(span->dy.b2)})
    EXPECT_EQ(beyond(array, cache_line), 0u);
  VisibilityTile tile;
  tile.reset({0, 0, 37, 5}, {0, 0, 37, 5}, 4);
  for (int sample = 0; sample < 4; ++sample)
    for (int y = 0; y < 5; ++y) {
      EXPECT_EQ(beyond(&tile.depth[tile.row(sample, y)], 4 * std::size_t(Batch::lanes)), 0u);
      EXPECT_EQ(beyond(&tile.triangle[tile.row(sample, y)], 4 * std::size_t(Batch::lanes)), 0u);
    }
  const Framebuffer picture(640, 480, {.format = ColourFormat::srgb_8bit});
  EXPECT_EQ(beyond(picture.rgba8.data(), cache_line), 0u);
}

}  // namespace
}  // namespace scanlit
