// scanlit reflect --plot spectrum: a metal's Fresnel reflectance.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lessons/studio/reflect/metal_curves.h"
#include "lessons/studio/reflect/query.h"
#include "models/registry.h"
#include "rasterizer/error.h"
#include "tests/cli/output_text.h"
#include "tests/cli/refusal.h"

namespace scanlit::test {
namespace {

TEST(SpectrumPlot, HasACurveForEachAngleEachWavelengthAndEachChannelTwice) {
  const Folder folder;
  for (const auto& [arguments, angles] :
       {std::pair{"fresnel:F=copper", 6u}, {"cook-torrance:F=gold --angles 0,45", 2u}}) {
    const Outcome outcome =
        folder.run(std::string("reflect ") + arguments + " --plot spectrum -o metal.svg");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "metal.svg: spectrum plot\n");
    EXPECT_EQ(count_of(folder.read("metal.svg"), "class=\"curve\""), angles + 5 + 2 * 3);
  }
  const std::string svg = folder.read("metal.svg");
  for (const char* part :
       {"Fresnel reflectance of gold", "Johnson and Christy 1972", "θ = 45°", "700 nm", "D65"})
    EXPECT_NE(svg.find(part), svg.npos) << part;
}

TEST(SpectrumPlot, RefusesWhatHasNoSpectrum) {
  const Folder folder;
  struct Bad {
    const char *arguments, *message;
  };
  for (const auto& [arguments, message] :
       {Bad{"fresnel:F=coper", "did you mean 'copper'?"},
        Bad{"lambert", "no spectrum is known of 'lambert'; of these it is: "},
        Bad{"fresnel:F=schlick", "fresnel:F=METAL"}, Bad{"fresnel:F=conductor", "copper, gold"},
        Bad{"fresnel fresnel", "spectrum wants one model, not 2"},
        Bad{"fresnel --log", "--log: has no meaning to the plot 'spectrum'"},
        Bad{"fresnel --angles 0,90", "--angles: 90 is out of range"}}) {
    expect_refusal(
        folder.run(std::string("reflect ") + arguments + " --plot spectrum -o metal.svg"), message);
    EXPECT_EQ(folder.files(), std::vector<std::string>{}) << arguments;
  }
  expect_refusal(folder.run("reflect fresnel --plot spectrum -o metal.png"), "is an .svg file");
}

const models::Metal& copper() { return models::find_metal("copper"); }

TEST(SpectrumPlot, CurvesAreTheMetalsReflectance) {
  const auto by_angle = studio::curves_over_angle(copper());
  const double nm[] = {450, 500, 550, 600, 700};
  ASSERT_EQ(by_angle.curves.size(), std::size(nm));
  for (std::size_t i = 0; i < std::size(nm); ++i) {
    EXPECT_EQ(by_angle.curves[i].points.back().x, 90);
    EXPECT_NEAR(by_angle.curves[i].points.back().y, 1, 1e-12) << "all of it at grazing";
    for (const studio::PlotPoint& p : by_angle.curves[i].points)
      EXPECT_NEAR(p.y, models::reflectance(copper(), nm[i], std::cos(studio::radians_of(p.x))),
                  1e-12);
  }
  const auto by_wavelength = studio::curves_over_wavelength(copper(), {0, 89});
  for (const studio::PlotPoint& p : by_wavelength.curves[0].points)
    EXPECT_EQ(p.y, models::reflectance(copper(), p.x, 1));
  EXPECT_EQ(by_wavelength.curves[0].points.front().x, 380);
  EXPECT_EQ(by_wavelength.curves[0].points.back().x, 780);
}

/// What the plot is there to show.
TEST(SpectrumPlot, CopperDipsInTheRedAndTurnsWhite) {
  const studio::PlotPoint dip = studio::lowest(studio::curves_over_angle(copper()).curves.back());
  EXPECT_GT(dip.x, 65);
  EXPECT_LT(dip.x, 80);
  const studio::MetalColours colours(copper());
  EXPECT_LT(dip.y, models::reflectance(copper(), 700, 1) - 0.005);
  EXPECT_LT(colours.spectrum(70).r, colours.spectrum(0).r - 0.005);
  EXPECT_EQ(colours.schlick(0), colours.spectrum(0)) << "the same at normal incidence";
  EXPECT_GT(colours.schlick(70).r, colours.schlick(0).r) << "Schlick's never falls";
  EXPECT_GT(colours.spectrum(0).r - colours.spectrum(0).b, 0.3) << "red";
  EXPECT_LT(colours.spectrum(89.5).r - colours.spectrum(89.5).b, 0.05) << "white";
}

TEST(SpectrumPlot, TheFitsErrorIsWhatItsHeaderSays) {
  for (const models::Metal& metal : models::metals()) {
    const studio::MetalColours colours(metal);
    EXPECT_GT(colours.fit_error, 0) << metal.name;
    EXPECT_LT(colours.fit_error, 2e-4) << metal.name;
  }
}

TEST(SpectrumPlot, HuesAreInTheOrderOfTheRainbow) {
  double before = -1;
  for (double nm = 700; nm >= 440; nm -= 5) {  // red 0, green 120, blue 240 degrees
    const Rgb<double> c = studio::hue(nm);
    for (const double channel : {c.r, c.g, c.b}) {
      EXPECT_GE(channel, 0) << nm;
      EXPECT_LE(channel, 1) << nm;
    }
    const double angle = std::atan2(std::sqrt(3.0) * (c.g - c.b), 2 * c.r - c.g - c.b);
    const double degrees = angle < -1e-12 ? angle * 57.3 + 360 : angle * 57.3;
    EXPECT_GE(degrees, before - 1e-9) << nm;
    before = degrees;
  }
  EXPECT_EQ(studio::hue(780), studio::hue(650)) << "red to the end";
  EXPECT_EQ(studio::hue(380), studio::hue(440)) << "violet to the end";
}

TEST(SpectrumPlot, ScreenColoursAreEncodedAndClamped) {
  EXPECT_EQ(studio::screen_colour({1, 0, 0.21586}), "#FF0080");
  EXPECT_EQ(studio::screen_colour({1.035, -0.2, 0}), "#FF0000");
}

}  // namespace
}  // namespace scanlit::test
