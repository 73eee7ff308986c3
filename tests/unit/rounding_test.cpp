// The build's flags keep what IEEE arithmetic promises: pictures agree between builds only if they
// do.
#include <gtest/gtest.h>

namespace scanlit {
namespace {

struct Four {
  double x, y, z, w;
};

// Seen alone (noipa), or the compiler would evaluate it for its arguments, and rightly.
[[gnu::noipa]] Four through_float(const Four& a) {
  const float x = float(a.x), y = float(a.y), z = float(a.z), w = float(a.w);
  return {x, y, z, w};
}

[[gnu::noipa]] float multiply_add(float a, float b, float c) { return a * b + c; }

TEST(Rounding, ADoubleTurnedToFloatAndBackIsRounded) {
  const Four rounded = through_float({0.1, 0.2, 0.3, 0.4});
  EXPECT_EQ(rounded.x, double(0.1f));
  EXPECT_EQ(rounded.y, double(0.2f));
  EXPECT_EQ(rounded.z, double(0.3f));
  EXPECT_EQ(rounded.w, double(0.4f));
}

TEST(Rounding, AProductIsRoundedBeforeItIsAdded) {
  // (1 + 2^-12)^2 = 1 + 2^-11 + 2^-24: rounded to float the last term is lost, fused it is not.
  const float a = 1 + 0x1p-12f;
  EXPECT_EQ(multiply_add(a, a, -(1 + 0x1p-11f)), 0.0f);
}

}  // namespace
}  // namespace scanlit
