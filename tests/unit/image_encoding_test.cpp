#include "rasterizer/image/image_encoding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scanlit {
namespace {

double srgb_code(double linear) {
  return 255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

TEST(EightBitEncoder, RoundsToTheNearestCodeOfTheSrgbCurve) {
  const EightBitEncoder encode(Encoding::srgb);
  for (int i = 0; i <= 1'000'000; ++i) {
    const float value = float(i) / 1'000'000;
    const double exact = srgb_code(value);
    // 0.5: rounded; 0.002: the standard's two pieces do not quite meet, at code 10.
    ASSERT_LE(std::abs(encode(value) - exact), 0.502) << value;
  }
}

TEST(EightBitEncoder, KnownCodes) {
  const EightBitEncoder srgb(Encoding::srgb), linear(Encoding::linear);
  EXPECT_EQ(srgb(0.0f), 0);
  EXPECT_EQ(srgb(0.18f), 118);  // 117.6
  EXPECT_EQ(srgb(0.5f), 188);   // 187.5
  EXPECT_EQ(srgb(1.0f), 255);
  EXPECT_EQ(linear(0.5f), 128);
  EXPECT_EQ(linear(0.25f), 64);
}

TEST(EightBitEncoder, OutOfRangeAndNotANumber) {
  const EightBitEncoder encode(Encoding::srgb);
  constexpr float inf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(encode(-1.0f), 0);
  EXPECT_EQ(encode(-inf), 0);
  EXPECT_EQ(encode(std::nanf("")), 0);
  EXPECT_EQ(encode(std::numeric_limits<float>::denorm_min()), 0);
  EXPECT_EQ(encode(std::nextafter(1.0f, 0.0f)), 255);
  EXPECT_EQ(encode(7.0f), 255);
  EXPECT_EQ(encode(inf), 255);
}

TEST(EightBitEncoder, EveryCodeSurvivesDecodingAndEncoding) {
  const EightBitEncoder encode(Encoding::srgb);
  for (int code = 0; code < 256; ++code)
    EXPECT_EQ(encode(float(linear_from_srgb(code / 255.0))), code);
}

TEST(EightBitEncoder, WhiteUpToRoundingIsNotClipped) {
  const EightBitEncoder encode(Encoding::srgb);
  EXPECT_FALSE(encode.clips(1.0f));
  EXPECT_FALSE(encode.clips(1.0001f));
  EXPECT_TRUE(encode.clips(1.01f));
}

}  // namespace
}  // namespace scanlit
