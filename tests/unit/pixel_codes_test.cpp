// 8-bit framebuffers: the codes that a float picture would have been written with.
#include "rasterizer/pixel_codes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "rasterizer/image/image_encoding.h"
#include "rasterizer/shapes.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

constexpr ColourFormat formats[] = {ColourFormat::linear_8bit, ColourFormat::srgb_8bit};

EightBitEncoder encoder_of(ColourFormat format) {
  return EightBitEncoder(format == ColourFormat::srgb_8bit ? Encoding::srgb : Encoding::linear);
}

/// The least value of a code, by bisection of the floats.
float threshold(const EightBitEncoder& encoder, int code) {
  float below = 0, above = 1;
  for (float middle = 0.5f; middle > below && middle < above; middle = (below + above) / 2)
    (encoder(middle) < code ? below : above) = middle;
  return above;
}

void expect_codes_of(std::vector<float> values, ColourFormat format) {
  const EightBitEncoder reference = encoder_of(format);
  const PixelEncoder encoder(format);
  const PixelEncoder::Tag tag;
  values.resize((values.size() + max_lanes - 1) / max_lanes * max_lanes);
  for (std::size_t i = 0; i < values.size(); i += Batch::lanes) {
    const Batch v = Batch::load(&values[i]);
    std::uint32_t pixels[Batch::lanes];
    hn::StoreU(encoder.opaque(v, Batch(0), v), tag, pixels);
    for (std::size_t k = 0; k < std::size_t(Batch::lanes); ++k) {
      const std::uint32_t code = reference(values[i + k]);
      ASSERT_EQ(pixels[k], code | code << 16 | 0xff000000u) << values[i + k];
    }
  }
}

TEST(PixelCodes, EncodingKeepsToItsError) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> linear(0, 1);
  for (int round = 0; round < 200000; ++round) {
    float x = linear(random), lanes[Batch::lanes];
    if (round % 4 == 0) x *= 0.01f;
    if (round < 2) x = float(round);
    srgb_from_linear(Batch(x)).store(lanes);
    const double a = double(x),
                 exact = a <= .0031308 ? 12.92 * a : 1.055 * std::pow(a, 1 / 2.4) - .055;
    ASSERT_NEAR(double(lanes[0]), exact, 5e-7) << x;
  }
}

double exact_code(ColourFormat format, double x) {
  if (format == ColourFormat::linear_8bit) return 255 * x;
  return 255 * (x <= .0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - .055);
}

TEST(PixelCodes, NearOnesAreNear) {
  for (const ColourFormat format : formats) {
    const PixelEncoder encoder(format, true);
    double furthest = 0;
    for (int i = 0; i <= 400000; ++i) {
      const float x = float(std::pow(i / 400000.0, 3));
      std::uint32_t pixels[Batch::lanes];
      hn::StoreU(encoder.opaque(Batch(x), Batch(0), Batch(x)), PixelEncoder::Tag(), pixels);
      const double off = std::abs(double(pixels[0] & 255) - exact_code(format, double(x))) - .5;
      furthest = std::max(furthest, off);
      ASSERT_EQ(pixels[0] & 255, pixels[0] >> 16 & 255);
      ASSERT_EQ(pixels[0] & 0xff00ff00u, 0xff000000u);
    }
    EXPECT_LE(furthest, near_codes);
  }
}

TEST(PixelCodes, AreTheEncodersNextToEveryThreshold) {
  for (const ColourFormat format : formats) {
    const EightBitEncoder encoder = encoder_of(format);
    std::vector<float> values;
    for (int code = 1; code <= 255; ++code) {
      float value = threshold(encoder, code);
      for (int i = 0; i < 4; ++i) value = std::nextafter(value, 0.0f);
      for (int i = 0; i < 9; ++i, value = std::nextafter(value, 2.0f)) values.push_back(value);
    }
    expect_codes_of(values, format);
  }
}

TEST(PixelCodes, AreTheEncodersForRandomAndUnusualValues) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(-0.1f, 1.1f);
  std::vector<float> values = {0,
                               -0.0f,
                               1,
                               1e-30f,
                               -1e30f,
                               1e30f,
                               std::numeric_limits<float>::infinity(),
                               -std::numeric_limits<float>::infinity(),
                               std::numeric_limits<float>::quiet_NaN(),
                               std::numeric_limits<float>::denorm_min(),
                               0.5f,
                               0.0031308f};
  for (int i = 0; i < 200'000; ++i) values.push_back(unit(random));
  for (int i = 0; i < 50'000; ++i) values.push_back(std::exp(10 * unit(random) - 10));
  for (const ColourFormat format : formats) expect_codes_of(values, format);
}

TEST(PixelCodes, OfAPictureAreThoseOfItsFloats) {
  Scene scene = scene_of(
      {object_of(std::make_shared<Mesh>(make_shape("sphere:9")), CosineOnly()),
       object_of(std::make_shared<Mesh>(make_shape("cube")), CosineOnly(), Shading::gouraud)});
  scene.objects[1].world_from_object[3] = {0.7f, 0.2f, 0.3f, 1};
  for (const Rgb<double>& background : {Rgb<double>(0.0), Rgb<double>(0.1, 0.5, 2)})
    for (const int samples : {1, 4})
      for (const ColourFormat format : formats) {
        scene.background = background;
        const RenderSettings settings = with_samples(samples);
        Framebuffer floats(97, 61), codes(97, 61, {.format = format});
        // Whatever they held is replaced.
        std::ranges::fill(floats.colour, 77.0f), std::ranges::fill(codes.rgba8, 77);
        render(scene, Camera(), settings, floats);
        render(scene, Camera(), settings, codes);
        AlignedVector<std::uint8_t> expected(floats.colour.size());
        PixelEncoder(format).row(floats.colour, expected.data());
        EXPECT_EQ(codes.rgba8, expected) << samples << ' ' << int(format);
        const EightBitEncoder encoder = encoder_of(format);
        const std::size_t middle = 4 * (30 * 97 + 48);
        EXPECT_EQ(codes.rgba8[middle], encoder(floats.colour[middle]));
        EXPECT_EQ(codes.rgba8[middle + 3], 255);
        EXPECT_EQ(codes.rgba8[3], 0);
      }
}

}  // namespace
}  // namespace scanlit
