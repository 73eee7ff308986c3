#include "rasterizer/framebuffer.h"

#include <gtest/gtest.h>

#include <utility>

#include "rasterizer/error.h"

namespace scanlit {
namespace {

TEST(Framebuffer, HoldsWhatIsAskedForAndIsClear) {
  const Framebuffer framebuffer(3, 2, {.depth = true, .ids = true});
  EXPECT_EQ(framebuffer.planes(), (Planes{.depth = true, .ids = true}));
  EXPECT_EQ(framebuffer.colour, std::vector<float>(24));
  EXPECT_EQ(framebuffer.depth, std::vector<float>(6));
  EXPECT_EQ(framebuffer.triangle_id, std::vector<std::uint32_t>(6, no_id));
}

TEST(Framebuffer, RefusesSizes) {
  for (const auto& [width, height] : {std::pair{1, 1}, {16384, 1}, {1, 16384}})
    EXPECT_NO_THROW(Framebuffer(width, height));
  for (const auto& [width, height] : {std::pair{0, 1}, {1, 0}, {-5, 5}, {16385, 1}, {1, 16385}})
    EXPECT_THROW(Framebuffer(width, height), Error);
}

}  // namespace
}  // namespace scanlit
