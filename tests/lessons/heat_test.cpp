// False colours: which band a value falls into, and what a picture of them shows.
#include "lessons/studio/drawing/heat.h"

#include <gtest/gtest.h>

namespace scanlit::studio {
namespace {

TEST(HeatScale, AValueBelongsToTheFirstBandThatReachesIt) {
  const HeatScale scale = count_scale();
  const std::vector<double> values = {0, 1, 2, 3, 4, 5, 64, 65, 1e9};
  const std::vector<std::size_t> bands = {0, 1, 2, 3, 3, 4, 7, 8, 8};
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_EQ(scale.colour(values[i]), scale.colour_of_band(bands[i])) << values[i];
  EXPECT_EQ(scale.bands()[3].label, "3-4");
}

TEST(HeatScale, MoreIsLighter) {
  const HeatScale scale = count_scale();
  const auto grey = [&](std::size_t band) {
    const Rgb<double> c = scale.colour_of_band(band);
    return .2126 * c.r + .7152 * c.g + .0722 * c.b;
  };
  // The dark blue of 1 is no lighter than the dark grey of 0.
  for (std::size_t band = 2; band < HeatScale::most_bands; ++band)
    EXPECT_GT(grey(band), grey(band - 1)) << band;
}

TEST(HeatScale, TheLastBandOfAShortScaleHasNoEnd) {
  const HeatScale scale = count_scale(3);
  ASSERT_EQ(scale.bands().size(), 3u);
  EXPECT_EQ(scale.colour(1000), scale.colour_of_band(2));
}

TEST(HeatScale, ShowsPixelsThatHaveAValue) {
  const HeatScale scale = count_scale();
  const Framebuffer picture = scale.draw({-1, 0, 5}, 3, 1);
  EXPECT_NE(picture.colour[0], picture.colour[4]) << "nothing is not 0";
  EXPECT_EQ(picture.colour[8], float(scale.colour(5).r));
  EXPECT_EQ(picture.colour[11], 1);
}

}  // namespace
}  // namespace scanlit::studio
