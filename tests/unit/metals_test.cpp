// Metals: their colours, and the fit that draws them.
#include "models/metals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "models/fresnel.h"
#include "rasterizer/error.h"
#include "tests/unit/batch_lanes.h"

namespace scanlit::models {
namespace {

static_assert(std::is_trivially_copyable_v<MetalFresnel>);

const double cos_75 = std::cos(75 * std::numbers::pi / 180);

void expect_colour(const Rgb<double>& colour, const Rgb<double>& expected, double tolerance) {
  EXPECT_NEAR(colour.r, expected.r, tolerance);
  EXPECT_NEAR(colour.g, expected.g, tolerance);
  EXPECT_NEAR(colour.b, expected.b, tolerance);
}

Rgb<double> clamped(const Rgb<double>& c) {
  return {std::clamp(c.r, 0.0, 1.0), std::clamp(c.g, 0.0, 1.0), std::clamp(c.b, 0.0, 1.0)};
}

double largest_difference(const Rgb<double>& a, const Rgb<double>& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// The largest difference of a Fresnel function from a metal's spectral colour, clamped, over all
/// angles; those near grazing are sampled most densely.
template <class Fresnel>
double worst_error(const Metal& metal, const Fresnel& fresnel) {
  double worst = 0;
  for (int i = 0; i <= 200; ++i) {
    const double c = i / 200.0 * (i / 200.0);
    const Rgb<double> exact = clamped(spectral_rgb(metal, c));
    worst = std::max(worst, test::or_infinity(largest_difference(fresnel(c), exact)));
  }
  return worst;
}

// ---------------------------------------------------------------------------------------- the data

TEST(Metals, TablesAreInOrderAndCoverTheVisible) {
  for (const Metal& metal : metals()) {
    SCOPED_TRACE(metal.name);
    EXPECT_LE(metal.table.front().wavelength_nm, first_wavelength_nm);
    EXPECT_GE(metal.table.back().wavelength_nm, last_wavelength_nm);
    EXPECT_TRUE(std::ranges::is_sorted(metal.table, std::ranges::less_equal{},
                                       &OpticalConstants::wavelength_nm));
    for (const OpticalConstants& m : metal.table) EXPECT_TRUE(m.n > 0 && m.k > 0);
    EXPECT_FALSE(metal.source.empty());
  }
  EXPECT_TRUE(std::ranges::is_sorted(metal_names()));
}

TEST(Metals, InterpolateLinearlyAndAreConstantBeyondTheTable) {
  const Metal& copper = find_metal("copper");
  EXPECT_EQ(copper.at(582.1).n, 0.70);
  EXPECT_EQ(copper.at(582.1).k, 2.704);
  EXPECT_NEAR(copper.at((582.1 + 616.8) / 2).n, 0.50, 1e-12);
  EXPECT_NEAR(copper.at((582.1 + 616.8) / 2).k, (2.704 + 3.205) / 2, 1e-12);
  EXPECT_EQ(copper.at(100).n, copper.table.front().n);
  EXPECT_EQ(copper.at(5000).k, copper.table.back().k);
}

TEST(Metals, AnUnknownNameIsRefusedWithTheNearest) {
  const auto message = [](const char* name) -> std::string {
    try {
      metal(name);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message("coper"), "unknown metal 'coper'; did you mean 'copper'?");
  EXPECT_EQ(message("wood"),
            "unknown metal 'wood'; there are: aluminium, chromium, copper, gold, iron, nickel, "
            "silver, titanium");
}

// ----------------------------------------------------------------------------------------- colours

TEST(Metals, ReflectanceAtOneWavelength) {
  const Metal& copper = find_metal("copper");
  EXPECT_EQ(reflectance(copper, 582.1, 0.5), conductor_reflectance(0.5, 0.70, 2.704));
  EXPECT_GT(reflectance(copper, 650, 1), 0.9);
  EXPECT_LT(reflectance(copper, 500, 1), 0.6);
  EXPECT_EQ(reflectance(copper, 500, 0), 1);
}

// The colours here were computed independently, from tables that end at 397 and 705 nm, hence the
// tolerance.
TEST(Metals, ColoursUnderDaylight) {
  expect_colour(spectral_rgb(find_metal("copper"), 1), {0.927, 0.624, 0.522}, 0.003);
  EXPECT_NEAR(spectral_rgb(find_metal("gold"), 1).r, 1.033, 0.003);
}

TEST(Metals, ColoursUnderEqualEnergy) {
  const auto colour = [](const char* name, double cos_theta) {
    return spectral_rgb(find_metal(name), cos_theta, Illuminant::equal_energy);
  };
  expect_colour(colour("copper", 1), {0.952, 0.630, 0.519}, 0.003);
  expect_colour(colour("copper", cos_75), {0.941, 0.676, 0.597}, 0.003);
  expect_colour(colour("gold", 1), {1.063, 0.737, 0.363}, 0.003);
  expect_colour(colour("silver", 1), {0.990, 0.984, 0.977}, 0.003);
  expect_colour(colour("aluminium", 1), {0.907, 0.916, 0.922}, 0.003);
}

// ----------------------------------------------------------------------------------------- the fit

TEST(MetalFresnel, StatedErrorOverAllMetalsAndAngles) {
  for (const Metal& m : metals()) EXPECT_LE(worst_error(m, metal(m.name)), 2e-4) << m.name;
}

TEST(MetalFresnel, FloatAndBatchAreAsDouble) {
  for (const std::string& name : metal_names())
    for (int i = 0; i <= 1000; ++i) {
      const auto c = float(i) / 1000;
      const Rgb<double> exact = metal(name)(double(c));
      const Rgb<float> single = metal(name)(c);
      const Rgb<Batch> batch = metal(name)(Batch(c));
      ASSERT_LE(largest_difference({single.r, single.g, single.b}, exact), 1e-5) << name;
      ASSERT_LE(largest_difference({test::lanes_of(batch.r)[0], test::lanes_of(batch.g)[0],
                                    test::lanes_of(batch.b)[0]},
                                   exact),
                1e-5)
          << name;
    }
}

TEST(MetalFresnel, IsOneAtGrazingAndNeverBeyond0And1) {
  for (const std::string& name : metal_names()) {
    EXPECT_EQ(metal(name)(0.0), Rgb<double>(1.0)) << name;
    EXPECT_EQ(metal(name)(0.0f), Rgb<float>(1.0f)) << name;
    for (int i = 0; i <= 1000; ++i) {
      const Rgb<float> f = metal(name)(float(i) / 1000);
      const auto [least, most] = std::minmax({f.r, f.g, f.b});
      ASSERT_TRUE(least >= 0 && most <= 1) << name << ' ' << i;
    }
  }
  EXPECT_EQ(metal("gold")(1.0).r, 1) << "gold's red, 1.035, is outside sRGB";
}

TEST(MetalFresnel, CopperGetsLessRedBeforeItGetsWhite) {
  const auto red = [](double degrees) {
    return metal("copper")(std::cos(degrees * std::numbers::pi / 180)).r;
  };
  EXPECT_LT(red(68), red(0) - 0.01);
  EXPECT_GT(red(85), red(0) + 0.03);
  // Down, then up, without the wiggles of a careless fit.
  for (int degrees = 0; degrees < 60; degrees += 5)
    EXPECT_GT(red(degrees) + 1e-4, red(degrees + 5));
  for (int degrees = 70; degrees < 90; degrees += 5) EXPECT_LT(red(degrees), red(degrees + 5));
}

// ------------------------------------------------------------------ what the usual shortcuts cost

TEST(MetalShortcuts, SchlickMissesTheDipOfMetals) {
  const auto error = [](const char* name) {
    const Metal& m = find_metal(name);
    return worst_error(m, SchlickFresnel<>{.f0 = clamped(spectral_rgb(m, 1))});
  };
  EXPECT_NEAR(error("copper"), 0.043, 0.005);
  EXPECT_NEAR(error("aluminium"), 0.126, 0.005);
  EXPECT_NEAR(error("chromium"), 0.200, 0.005);
}

TEST(MetalShortcuts, ADielectricOfTheSameF0IsNoMetal) {
  const auto error = [](const char* name) {
    const Metal& m = find_metal(name);
    const Rgb<double> f0 = clamped(spectral_rgb(m, 1));
    const auto eta = [](double f) { return (1 + std::sqrt(f)) / (1 - std::sqrt(f)); };
    return worst_error(m, [&](double c) -> Rgb<double> {
      return {dielectric_reflectance(c, eta(f0.r)), dielectric_reflectance(c, eta(f0.g)),
              dielectric_reflectance(c, eta(f0.b))};
    });
  };
  EXPECT_NEAR(error("copper"), 0.49, 0.02);
  EXPECT_NEAR(error("aluminium"), 0.47, 0.02);
  EXPECT_NEAR(error("nickel"), 0.30, 0.02);
}

}  // namespace
}  // namespace scanlit::models
