// The comparison itself: what must fail, fails, and what must pass, passes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "rasterizer/error.h"
#include "rasterizer/image.h"
#include "tests/golden/golden.h"

namespace scanlit::golden {
namespace {

namespace fs = std::filesystem;

constexpr Planes all_planes{true, true, true, true};

Framebuffer picture(int width = 50, int height = 40) {
  Framebuffer framebuffer(width, height, all_planes);
  for (std::size_t i = 0; i < framebuffer.pixel_count(); ++i) {
    for (int c = 0; c < 3; ++c) {
      framebuffer.colour[4 * i + c] = 0.5f + 0.125f * float(c);
      framebuffer.normal[3 * i + c] = 0.5f;
      framebuffer.glossy[3 * i + c] = 0.25f;
    }
    framebuffer.colour[4 * i + 3] = 0.75f;
    framebuffer.depth[i] = 1 / float(i + 2);
    framebuffer.object_id[i] = 3;
    framebuffer.triangle_id[i] = (1u << 24) + std::uint32_t(i);
  }
  return framebuffer;
}

Tolerance tolerance(int pixels = 0) { return {1e-3f, 1e-3f, pixels, "test"}; }

std::vector<std::string> problems(const Framebuffer& actual, const Framebuffer& expected,
                                  int pixels = 0) {
  return compare(actual, expected, tolerance(pixels)).problems;
}

using Lines = std::vector<std::string>;

TEST(Compare, EqualPicturesPass) { EXPECT_EQ(problems(picture(), picture()), Lines{}); }

TEST(Compare, ColourWithinToleranceIsMeasuredAndPasses) {
  Framebuffer actual = picture();
  actual.colour[0] += 4e-4f;
  const Comparison comparison = compare(actual, picture(), tolerance());
  EXPECT_EQ(comparison.problems, Lines{});
  ASSERT_TRUE(comparison.colour);
  EXPECT_NEAR(comparison.colour->max, 4e-4, 1e-6);
  EXPECT_EQ(comparison.colour->pixels, 0);
}

TEST(Compare, EitherToleranceSuffices) {
  Framebuffer actual = picture(), expected = picture();
  expected.colour[0] = 1e-5f;  // 100 times as much, but absolutely little
  actual.colour[0] = 1e-3f;
  expected.colour[1] = 100;  // absolutely much, but a small share
  actual.colour[1] = 100.05f;
  EXPECT_EQ(problems(actual, expected), Lines{});
}

TEST(Compare, APixelBeyondToleranceFailsAndIsFound) {
  Framebuffer actual = picture();
  actual.colour[4 * (50 * 7 + 11) + 1] += 0.25f;
  EXPECT_EQ(problems(actual, picture()),
            Lines{"colour differs in 1 pixels by more than 0.001 and 0.1 %, where 0 may; most by "
                  "0.25 in G at (11, 7)"});
}

TEST(Compare, OnePixelTooManyFails) {
  Framebuffer actual = picture();
  const auto spoil = [&](std::size_t pixel) {
    for (int c = 0; c < 3; ++c) actual.colour[4 * pixel + c] += 0.1f;  // counts once
  };
  spoil(5);
  spoil(1999);
  EXPECT_EQ(problems(actual, picture(), 2), Lines{});
  spoil(100);
  EXPECT_EQ(problems(actual, picture(), 2).size(), 1u);
}

TEST(Compare, ACaseMayLetAThousandthOfItsPixelsDiffer) {
  EXPECT_EQ(problems(picture(), picture(), 2), Lines{});
  EXPECT_EQ(problems(picture(), picture(), 3),
            Lines{"the case lets 3 pixels differ, which is more than .1 % of them"});
}

TEST(Compare, NormalsAndPartsAreComparedToo) {
  Framebuffer actual = picture();
  actual.normal[4] += 0.1f;
  actual.glossy[5] += 0.1f;
  const Lines found = problems(actual, picture());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].find("normal differs in 1 pixels"), 0u);
  EXPECT_EQ(found[1].find("glossy differs in 1 pixels"), 0u);
}

TEST(Compare, CoverageDepthAndIdsAreExactWhateverTheTolerance) {
  Framebuffer actual = picture();
  actual.colour[4 * 3 + 3] = std::nextafter(0.75f, 1.0f);
  actual.depth[4] = std::nextafter(actual.depth[4], 1.0f);
  actual.object_id[51] = 4;
  actual.triangle_id[9] += 1;  // as a float it is the same number
  actual.triangle_id[10] = no_id;
  EXPECT_EQ(problems(actual, picture(), 2),
            (Lines{"coverage differs in 1 pixels; the first is (3, 0): 0.75000006 instead of 0.75",
                   "depth differs in 1 pixels; the first is (4, 0): 0.166666687 instead of "
                   "0.166666672",
                   "id.object differs in 1 pixels; the first is (1, 1): 4 instead of 3",
                   "id.triangle differs in 2 pixels; the first is (9, 0): 16777226 instead of "
                   "16777225"}));
}

TEST(Compare, NotANumberFailsEvenWhereTheReferenceHasOne) {
  Framebuffer actual = picture();
  actual.colour[4 * 52] = std::nanf("");
  EXPECT_EQ(problems(actual, actual), Lines{"colour is nan at (2, 1)"});
  actual = picture();
  actual.normal[0] = INFINITY;
  EXPECT_EQ(problems(actual, actual), Lines{"normal is inf at (0, 0)"});
}

TEST(Compare, SizesAndPlanesHaveToMatch) {
  EXPECT_EQ(problems(picture(50, 40), picture(40, 50)),
            Lines{"the picture is 50x40, its reference 40x50"});
  Framebuffer colour_only(50, 40);
  EXPECT_EQ(problems(colour_only, picture()).size(), 7u);
  EXPECT_EQ(problems(colour_only, picture())[0], "the picture has no depth");
  EXPECT_EQ(problems(picture(), colour_only)[0], "the reference has no depth");
}

class GoldenFiles : public testing::Test {
 protected:
  ~GoldenFiles() override { fs::remove_all(folder_); }
  static Case make_case(const std::string& name, const Framebuffer& framebuffer) {
    return {name, tolerance(), [framebuffer] { return framebuffer; }};
  }
  fs::path folder_ = fs::path(testing::TempDir()) / ("scanlit-golden-" + std::to_string(getpid()));
};

TEST_F(GoldenFiles, AMissingReferenceFails) {
  EXPECT_EQ(check(make_case("a", picture()), folder_).comparison.problems,
            Lines{"there is no reference a.exr"});
}

TEST_F(GoldenFiles, AnUnreadableReferenceFails) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "a.exr") << "not a picture";
  const Result result = check(make_case("a", picture()), folder_);
  ASSERT_EQ(result.comparison.problems.size(), 1u);
  EXPECT_NE(result.comparison.problems[0].find("cannot read the image"), std::string::npos);
}

TEST_F(GoldenFiles, ADrawingThatThrowsFails) {
  const Case throwing{"a", tolerance(), []() -> Framebuffer { throw Error("no such shape"); }};
  bless(make_case("a", picture()), folder_);
  EXPECT_EQ(check(throwing, folder_).comparison.problems, Lines{"drawing failed: no such shape"});
  EXPECT_THROW(bless(throwing, folder_), Error);
}

TEST_F(GoldenFiles, ABlessedPicturePassesAndAnotherFails) {
  bless(make_case("a", picture()), folder_);
  EXPECT_EQ(check(make_case("a", picture()), folder_).comparison.problems, Lines{});
  Framebuffer changed = picture();
  changed.colour[0] += 0.01f;
  EXPECT_FALSE(check(make_case("a", changed), folder_).passed());
}

TEST_F(GoldenFiles, BlessingTellsTheDifferenceBeforeAndAfter) {
  EXPECT_NE(bless(make_case("a", picture()), folder_).find("before:  there is no reference a.exr"),
            std::string::npos);
  Framebuffer changed = picture();
  changed.colour[0] += 0.25f;
  const std::string text = bless(make_case("a", changed), folder_);
  EXPECT_NE(text.find("before:  max 0.25, mean 4.16"), std::string::npos) << text;
  EXPECT_NE(text.find("; 1 of 2000 pixels beyond the tolerance"), std::string::npos) << text;
  const auto after = text.find("after:   max ");
  ASSERT_NE(after, std::string::npos) << text;
  EXPECT_NE(text.find("; 0 of 2000 pixels beyond the tolerance", after), std::string::npos);
}

TEST_F(GoldenFiles, NoReferenceHoldsANotANumber) {
  Framebuffer broken = picture();
  broken.colour[1] = std::nanf("");
  EXPECT_THROW(bless(make_case("a", broken), folder_), Error);
  EXPECT_FALSE(fs::exists(folder_ / "a.exr"));
}

TEST_F(GoldenFiles, ThePageShowsFailuresFirst) {
  bless(make_case("good", picture()), folder_);
  bless(make_case("bad", picture()), folder_);
  Framebuffer changed = picture();
  changed.colour[0] += 0.01f;
  const fs::path out = folder_ / "out";
  write_report(
      out, {check(make_case("good", picture()), folder_), check(make_case("bad", changed), folder_),
            check(make_case("small", picture(3, 3)), folder_)});
  std::ifstream in(out / "index.html");
  const std::string page((std::istreambuf_iterator<char>(in)), {});
  const auto at = [&](const std::string& text) { return page.find(text); };
  EXPECT_NE(at("2 failed, 1 passed"), std::string::npos);
  EXPECT_LT(at("bad failed"), at("small failed"));
  EXPECT_LT(at("small failed"), at("good passed"));
  EXPECT_LT(at("tests/bless bad"), at("tests/bless small"));
  EXPECT_EQ(at("tests/bless good"), std::string::npos);
  for (const char* file : {"bad-actual.png", "bad-expected.png", "bad-difference.png",
                           "good-actual.png", "small-actual.png"}) {
    EXPECT_NE(at(file), std::string::npos) << file;
    EXPECT_TRUE(fs::exists(out / file)) << file;
  }
  EXPECT_FALSE(fs::exists(out / "small-expected.png"));
}

TEST_F(GoldenFiles, TheDifferenceIsAmplifiedToWhiteAndMagenta) {
  bless(make_case("a", picture()), folder_);
  Framebuffer changed = picture();
  for (int c = 0; c < 3; ++c) changed.colour[c] += 0.01f;
  changed.triangle_id[1] += 1;
  write_report(folder_ / "out", {check(make_case("a", changed), folder_)});
  const Framebuffer difference = read_image(folder_ / "out/a-difference.png");
  const auto rgb = [&](int pixel) {
    const float* c = &difference.colour[4 * std::size_t(pixel)];
    return std::vector<float>{std::round(c[0]), std::round(c[1]), std::round(c[2])};
  };
  EXPECT_EQ(rgb(0), (std::vector<float>{1, 1, 1}));
  EXPECT_EQ(rgb(1), (std::vector<float>{1, 0, 1}));
  EXPECT_EQ(rgb(2), (std::vector<float>{0, 0, 0}));
}

TEST(Cases, HaveNamesAndReasonsOfTheirOwn) {
  std::vector<std::string> names;
  for (const Case& golden_case : cases()) {
    names.push_back(golden_case.name);
    EXPECT_FALSE(golden_case.tolerance.reason.empty()) << golden_case.name;
  }
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

}  // namespace
}  // namespace scanlit::golden
