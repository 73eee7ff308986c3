// From spectrum to linear sRGB: white, and colours known from elsewhere.
#include "models/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scanlit::models {
namespace {

TEST(Spectrum, APerfectMirrorIsWhite) {
  for (const Illuminant light : {Illuminant::d65, Illuminant::equal_energy})
    for (const double grey : {1.0, 0.5, 0.0}) {
      const Rgb<double> rgb = linear_srgb([=](double) { return grey; }, light);
      // 1e-14: sRGB's matrix times its white is 1 up to rounding.
      EXPECT_NEAR(rgb.r, grey, 1e-14);
      EXPECT_NEAR(rgb.g, grey, 1e-14);
      EXPECT_NEAR(rgb.b, grey, 1e-14);
    }
}

TEST(Spectrum, TheFitsOwnWhiteIsCloseToTheStandards) {
  const Chromaticity daylight = white_point(Illuminant::d65);
  EXPECT_NEAR(daylight.x, 0.3127, 5e-4);
  EXPECT_NEAR(daylight.y, 0.3290, 5e-4);
  const Chromaticity equal_energy = white_point(Illuminant::equal_energy);
  EXPECT_NEAR(equal_energy.x, 1.0 / 3, 5e-4);
  EXPECT_NEAR(equal_energy.y, 1.0 / 3, 5e-4);
}

TEST(Spectrum, IsLinearInTheReflectance) {
  const auto ramp = [](double nm) { return (nm - 380) / 400; };
  const Rgb<double> up = linear_srgb(ramp);
  const Rgb<double> down = linear_srgb([&](double nm) { return 1 - ramp(nm); });
  EXPECT_NEAR(up.r + down.r, 1, 1e-13);
  EXPECT_NEAR(up.g + down.g, 1, 1e-13);
  EXPECT_NEAR(up.b + down.b, 1, 1e-13);
  EXPECT_GT(up.r, up.g);
  EXPECT_GT(up.g, up.b);
}

TEST(Spectrum, PureColoursLeaveTheGamut) {
  const auto band = [](double from, double to) {
    return linear_srgb([=](double nm) { return nm >= from && nm <= to ? 1.0 : 0.0; });
  };
  EXPECT_LT(band(480, 520).r, 0) << "cyan-green: sRGB has no such red";
  const Rgb<double> yellow_and_red = band(560, 780);
  EXPECT_GT(yellow_and_red.r, 1) << "orange: redder than sRGB's white is";
  EXPECT_LT(yellow_and_red.b, 0.02);
}

TEST(Spectrum, BrightnessIsThatOfTheLuminousEfficiency) {
  // Y of sRGB: IEC 61966-2-1. Most of the light is seen around 555 nm, none at the ends.
  const auto luminance = [](double from, double to) {
    const Rgb<double> c =
        linear_srgb([=](double nm) { return nm >= from && nm <= to ? 1.0 : 0.0; });
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
  };
  EXPECT_NEAR(luminance(380, 780), 1, 1e-3);
  EXPECT_GT(luminance(500, 620), 0.85);
  EXPECT_LT(luminance(380, 430) + luminance(700, 780), 0.01);
}

}  // namespace
}  // namespace scanlit::models
