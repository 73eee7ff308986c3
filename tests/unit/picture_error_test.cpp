// Errors of pictures: pictures whose errors are known.
#include "rasterizer/reference/picture_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rasterizer/reference/flip.h"

namespace scanlit::test {
namespace {

/// Everywhere one colour, of one object 5 units away.
ExactPicture plain(int width, int height, const Rgb<double>& colour) {
  ExactPicture picture(width, height, colour);
  picture.object.assign(picture.pixel_count(), 0);
  picture.triangle.assign(picture.pixel_count(), 0);
  picture.distance.assign(picture.pixel_count(), 5);
  picture.normal.assign(picture.pixel_count(), {0, 0, 1});
  return picture;
}

TEST(PictureError, OfAKnownDifference) {
  const ExactPicture reference = plain(4, 2, Rgb<double>(0.5));
  ExactPicture picture = reference;
  picture.colour[3].g += 0.01;      // 2.55 steps
  picture.colour[5].b -= 0.001;     // .255 steps: from code 127.5 to 127.245
  picture.colour[6] = {2, .5, .5};  // clamped to 1
  const PictureError error = compare(reference, picture, Encoding::linear);
  EXPECT_EQ(error.interior.pixels, 8);
  EXPECT_EQ(error.silhouette.pixels, 0);
  EXPECT_EQ(error.interior.differing, 3);
  EXPECT_DOUBLE_EQ(error.interior.max_linear, 1.5);
  EXPECT_DOUBLE_EQ(error.interior.max_steps, 127.5);
  EXPECT_NEAR(error.interior.rms_linear, std::sqrt((1e-4 + 1e-6 + 2.25) / 24), 1e-15);
  EXPECT_NEAR(error.interior.rms_steps, std::sqrt((2.55 * 2.55 + .255 * .255 + 127.5 * 127.5) / 24),
              1e-12);
  EXPECT_DOUBLE_EQ(error.peak, 0.5);
}

// sRGB of .5 is .735357, of .51 .741905: IEC 61966-2-1.
TEST(PictureError, InStepsOfTheEncoding) {
  EXPECT_NEAR(encoded(0.5, Encoding::srgb), 0.735357, 1e-6);
  EXPECT_NEAR(encoded(0.002, Encoding::srgb), 0.02584, 1e-12);
  EXPECT_EQ(encoded(-1, Encoding::srgb), 0);
  EXPECT_EQ(encoded(7, Encoding::linear), 1);
  const PictureError error =
      compare(plain(1, 1, Rgb<double>(0.5)), plain(1, 1, Rgb<double>(0.51)), Encoding::srgb);
  EXPECT_NEAR(error.interior.max_steps, 255 * (0.741905 - 0.735357), 1e-3);
}

TEST(PictureError, KeepsSilhouettesApartAndCountsIds) {
  const ExactPicture reference = plain(8, 8, Rgb<double>(0.5));
  ExactPicture picture = reference;
  picture.object[0] = picture.triangle[0] = no_id;  // coverage differs: never interior
  picture.colour[0] = Rgb<double>(0);
  picture.triangle[20] = 7;
  const PictureError error = compare(reference, picture, Encoding::linear);
  EXPECT_EQ(error.different_ids, 2);
  EXPECT_EQ(error.silhouette.pixels, 1);
  EXPECT_DOUBLE_EQ(error.silhouette.max_linear, 0.5);
  EXPECT_EQ(error.interior.max_linear, 0);
}

TEST(PictureError, SilhouettesAreWhereDistancesLeapAndNormalsTurn) {
  const Camera camera{.fov_deg = 90};  // a pixel at distance 5 is 10 / 8 wide
  ExactPicture a = plain(8, 8, Rgb<double>(0.5));
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) a.distance[std::size_t(8 * y + x)] = x < 4 ? 5 : 5 + 12;
  EXPECT_EQ(silhouettes(a, a, camera), std::vector<bool>(64));  // less than 10 widths
  for (double& d : a.distance) d = d > 5 ? 18 : 5;
  const auto edge = silhouettes(a, a, camera);
  for (std::size_t i = 0; i < 64; ++i) EXPECT_EQ(edge[i], i % 8 == 3 || i % 8 == 4) << i;
  // Where two pictures see surfaces far apart, too.
  ExactPicture b = plain(8, 8, Rgb<double>(0.5));
  EXPECT_FALSE(silhouettes(b, a, camera)[7]);
  for (double& d : a.distance) d = d > 5 ? 70 : 5;
  EXPECT_TRUE(silhouettes(b, a, camera)[7]);
  EXPECT_FALSE(silhouettes(b, a, camera)[0]);
  b.normal[0] = {0, 0.6, 0.8};
  EXPECT_TRUE(silhouettes(b, b, camera)[9]);
  EXPECT_FALSE(silhouettes(b, b, camera)[10]);
}

TEST(Flip, OfPlainColoursIsThatOfThePaper) {
  const auto of = [](const Rgb<double>& a, const Rgb<double>& b) {
    return mean_flip(plain(24, 16, a), plain(24, 16, b));
  };
  EXPECT_NEAR(of(Rgb<double>(0.3), Rgb<double>(0.3)), 0, 1e-6);
  // The two colours of a screen that lie farthest apart.
  EXPECT_NEAR(of({0, 1, 0}, {0, 0, 1}), 1, 1e-3);
  // Black and white: L* differs by 100; 100^.7 = 25.12 of at most 41.28, beyond the knee.
  EXPECT_NEAR(of(Rgb<double>(0), Rgb<double>(1)), 0.96738, 1e-3);
  EXPECT_LT(of(Rgb<double>(0.5), Rgb<double>(0.51)), of(Rgb<double>(0.5), Rgb<double>(0.55)));
}

// Stripes as wide as a pixel are not seen from .7 m away, nor told from their mean; from near by
// they are.
TEST(Flip, FinePatternsAreNotSeenFromFar) {
  const ExactPicture mean = plain(64, 64, Rgb<double>(0.5));
  ExactPicture stripes = mean;
  for (std::size_t i = 0; i < stripes.pixel_count(); ++i)
    stripes.colour[i] = Rgb<double>(i % 2 ? 0.52 : 0.48);
  const auto middle = [&](double pixels_per_degree) {
    return flip(mean, stripes, pixels_per_degree)[32 * 64 + 32];
  };
  EXPECT_LT(middle(flip_pixels_per_degree), 0.02);
  EXPECT_GT(middle(8), 3 * middle(flip_pixels_per_degree));
}

// An edge that is there in one picture alone is noticed more than the same difference of colour
// without one.
TEST(Flip, EdgesCountForMore) {
  const ExactPicture plain_grey = plain(64, 64, Rgb<double>(0.4));
  ExactPicture edge = plain_grey, lighter = plain_grey;
  for (std::size_t i = 0; i < edge.pixel_count(); ++i) {
    lighter.colour[i] = Rgb<double>(0.45);
    if (i % 64 >= 32) edge.colour[i] = Rgb<double>(0.45);
  }
  const std::size_t beside = 32 * 64 + 34;
  EXPECT_GT(flip(plain_grey, edge)[beside], 1.2 * flip(plain_grey, lighter)[beside]);
}

}  // namespace
}  // namespace scanlit::test
