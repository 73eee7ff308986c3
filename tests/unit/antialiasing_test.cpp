// Anti-aliasing: exact coverage at every sample, shading once per triangle in a pixel and never
// outside it, resolved in linear light. And framebuffers of extreme shapes.
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "rasterizer/error.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

class Antialiasing : public testing::TestWithParam<int> {
 protected:
  int samples() const { return GetParam(); }
  RenderSettings settings() const { return with_samples(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Samples, Antialiasing, testing::Values(1, 4, 8, 16));

TEST_P(Antialiasing, SamplesShareNoRowAndNoColumnAndSurroundTheCentre) {
  const auto offsets = sample_offsets(samples());
  ASSERT_EQ(offsets.size(), std::size_t(samples()));
  std::set<int> columns, rows;
  for (const auto& [x, y] : offsets) {
    columns.insert(x), rows.insert(y);
    EXPECT_TRUE(x >= -half_pixel && x < half_pixel && y >= -half_pixel && y < half_pixel);
  }
  EXPECT_EQ(columns.size(), offsets.size());
  EXPECT_EQ(rows.size(), offsets.size());
  // A triangle that covers all samples covers the centre: resolve.h relies on it.
  for (double angle = 0; angle < 6.3; angle += 0.01)
    EXPECT_TRUE(std::ranges::any_of(offsets, [&](const SampleOffset& o) {
      return o.x * std::cos(angle) + o.y * std::sin(angle) >= 0;
    })) << angle;
}

/// A triangle with corners in 1/256 pixel, and a picture of it; both are exact.
struct Drawn {
  ScreenTriangle triangle;
  Picture picture;
};

constexpr int size = 16;

Drawn draw(const std::vector<glm::ivec2>& corners, const RenderSettings& settings) {
  std::vector<glm::vec3> positions;
  for (const glm::ivec2& c : corners) positions.emplace_back(glm::vec2(c) / 256.0f, 0.5f);
  const auto v = [&](std::size_t i) { return ScreenVertex{corners[i].x, corners[i].y, 0.5f, 1}; };
  Scene scene = scene_of({object_of(triangle_soup(on_screen(positions)), ShowPoint())});
  scene.lights.push_back(scene.lights[0]);  // whichever way it faces
  scene.lights[1].direction = {0, 0, -1};
  return {screen_triangle(v(0), v(1), v(2)),
          picture_of(scene, pixel_camera(size, size), size, size, settings)};
}

std::vector<glm::ivec2> random_corners(std::mt19937_64& random) {
  // Often no wider than a sample's distance from the next, often through sample positions.
  std::uniform_int_distribution<int> anywhere(-2 * subpixel, (size + 2) * subpixel);
  std::uniform_int_distribution<int> near(-40, 40), kind(0, 3);
  const auto corner = [&] { return glm::ivec2(anywhere(random), anywhere(random)); };
  std::vector<glm::ivec2> corners = {corner(), corner(), corner()};
  if (kind(random) == 0) corners[2] = corners[1] + glm::ivec2(near(random), near(random));
  if (kind(random) == 0)
    for (glm::ivec2& c : corners) c = c / 16 * 16;
  if (kind(random) == 0)
    for (glm::ivec2& c : corners) c = corners[0] + glm::ivec2(near(random), near(random)) * 8;
  return corners;
}

/// Of a pixel's samples, those that exact arithmetic finds covered; and where shading belongs.
struct ExactPixel {
  int count = 0;
  bool centre = false;
  glm::dvec2 point{0};  // in pixels: the centre, where covered, else the samples' centroid
};

ExactPixel exact_pixel(const ScreenTriangle& triangle, int samples, int x, int y) {
  ExactPixel result;
  const int centre_x = x * subpixel + half_pixel, centre_y = y * subpixel + half_pixel;
  for (const auto& [dx, dy] : sample_offsets(samples))
    if (exactly_covers(triangle, centre_x + dx, centre_y + dy))
      ++result.count, result.point += glm::dvec2(dx, dy);
  int inside = 0;
  for (int i = 0; i < 3; ++i)
    inside += exact_edge(triangle.vertices[i], triangle.vertices[(i + 1) % 3], centre_x, centre_y) *
                  exact_sign(triangle) >=
              0;
  result.centre = inside == 3;
  const glm::dvec2 from_centre =
      result.centre ? glm::dvec2(0) : result.point / double(result.count);
  result.point = (glm::dvec2(centre_x, centre_y) + from_centre) / double(subpixel);
  return result;
}

TEST_P(Antialiasing, AlphaIsTheShareOfCoveredSamplesAndShadingIsAtTheCentreOrTheirCentroid) {
  EXPECT_TRUE(holds(400, [&] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    const auto corners = random_corners(random);
    for (const glm::ivec2& c : corners) RC_LOG() << c.x << ' ' << c.y << '\n';
    const auto [triangle, picture] = draw(corners, settings());
    int fragments = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const ExactPixel exact = exact_pixel(triangle, samples(), x, y);
        const float alpha = picture.colour(x, y)[3];
        RC_ASSERT(alpha == float(exact.count) / float(samples()));
        if (exact.count == 0) continue;
        ++fragments;
        const float* sum = &picture.framebuffer.diffuse[3 * picture.index(x, y)];
        RC_ASSERT(std::abs(sum[0] / alpha - exact.point.x) < 1e-5);
        RC_ASSERT(std::abs(-sum[1] / alpha - exact.point.y) < 1e-5);
      }
    RC_ASSERT(picture.stats.fragments == fragments);
    RC_ASSERT(picture.stats.covered_pixels == fragments);
  }));
}

TEST_P(Antialiasing, AttributesStayWithinTheTrianglesRange) {
  const Camera camera = eye_at_origin(1e-4);
  EXPECT_TRUE(holds(1000, [&] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    std::uniform_real_distribution<double> on_screen(-1.2, 1.2), decades(0, 6);
    std::uniform_int_distribution<int> kind(0, 2);
    std::vector<glm::vec3> positions;
    for (int i = 0; i < 3; ++i) {
      const double w = 0.01 * std::pow(10.0, decades(random));
      positions.emplace_back(on_screen(random) * w, on_screen(random) * w, -w);
    }
    // A sliver: two corners in nearly the same direction, at very different distances.
    if (kind(random) == 0)
      positions[2] = positions[1] / positions[1].z * positions[2].z * glm::vec3(1.001f, 0.999f, 1);
    auto mesh = triangle_soup(positions);
    mesh->texcoords = {{0, 1}, {1, 0}, {0, 0}};
    Scene scene = scene_of({object_of(mesh, ShowPoint())});
    scene.lights.push_back(scene.lights[0]);
    scene.lights[1].direction = {0, 0, -1};
    const Picture picture = picture_of(scene, camera, size, size, settings());
    for (std::size_t i = 0; i < picture.framebuffer.pixel_count(); ++i) {
      const float alpha = picture.framebuffer.colour[4 * i + 3];
      for (std::size_t c = 0; c < 2 && alpha > 0; ++c) {
        const float value = picture.framebuffer.glossy[3 * i + c] / alpha;
        RC_ASSERT(value >= -1e-6f && value <= 1 + 1e-6f);  // but for float's last place
      }
    }
  }));
}

TEST_P(Antialiasing, APixelThatOneTriangleFillsIsShadedOnce) {
  const auto mesh = triangle_soup(on_screen({{-1, -1, 0.5f}, {-1, 99, 0.5f}, {99, -1, 0.5f}}));
  const Picture picture =
      picture_of(scene_of({object_of(mesh)}), pixel_camera(size, size), size, size, settings());
  EXPECT_EQ(picture.stats.evaluations, size * size);
  EXPECT_EQ(picture.stats.fragments, size * size);
  for (std::size_t i = 0; i < picture.framebuffer.pixel_count(); ++i)
    EXPECT_EQ(picture.framebuffer.colour[4 * i + 3], 1.0f);
}

/// A square [x0, x1) x [0, size) of constant radiance.
Object wall(float x0, float x1, float depth, double radiance) {
  const float s = float(size);
  Object object = object_of(triangle_soup(on_screen({{x0, 0, depth},
                                                     {x0, s, depth},
                                                     {x1, 0, depth},
                                                     {x1, 0, depth},
                                                     {x0, s, depth},
                                                     {x1, s, depth}})));
  object.material.form = ColourForm::plastic;
  object.material.object_colour = Rgb<double>(radiance);
  return object;
}

TEST_P(Antialiasing, ResolvesInLinearLightOverTheBackground) {
  // A vertical edge half-way through column 4 and another through column 8.
  Scene scene = scene_of({wall(0, 4.5f, 0.5f, 1), wall(4.5f, 8.5f, 0.5f, 0.25)});
  scene.background = Rgb<double>(0.5);
  const Picture picture = picture_of(scene, pixel_camera(size, size), size, size, settings());
  int left = 0;  // samples left of a pixel's centre
  for (const SampleOffset& offset : sample_offsets(samples())) left += offset.x < 0;
  const float share = float(left) / float(samples());
  for (int y = 0; y < size; ++y) {
    EXPECT_EQ(picture.colour(3, y)[0], 1.0f);
    EXPECT_FLOAT_EQ(picture.colour(4, y)[0], share * 1 + (1 - share) * 0.25f);
    EXPECT_EQ(picture.colour(5, y)[0], 0.25f);
    EXPECT_FLOAT_EQ(picture.colour(8, y)[0], share * 0.25f + (1 - share) * 0.5f);
    EXPECT_EQ(picture.colour(8, y)[3], share);
    EXPECT_EQ(picture.colour(9, y)[0], 0.5f);
    EXPECT_EQ(picture.colour(9, y)[3], 0.0f);
  }
}

TEST_P(Antialiasing, TheNearestIsKeptPerSample) {
  const Picture picture = picture_of(scene_of({wall(0, 16, 0.25f, 1), wall(0, 4.5f, 0.75f, 0.5)}),
                                     pixel_camera(size, size), size, size, settings());
  int left = 0;
  for (const SampleOffset& offset : sample_offsets(samples())) left += offset.x < 0;
  const float share = float(left) / float(samples());
  for (int y = 0; y < size; ++y)
    EXPECT_FLOAT_EQ(picture.colour(4, y)[0], share * 0.5f + (1 - share));
}

// --------------------------------------------------------------------- framebuffers at the limits

TEST_P(Antialiasing, FramebuffersOfExtremeShapes) {
  for (const auto& [width, height] : {std::pair(1, 1), {16384, 4}, {4, 16384}, {16384, 1}}) {
    const float w = float(width), h = float(height);
    // Both triangles of the whole picture: every pixel, one of the two.
    const std::vector<glm::vec3> corners = {{0, 0, 0.5f}, {0, h, 0.5f}, {w, 0, 0.5f},
                                            {w, 0, 0.5f}, {0, h, 0.5f}, {w, h, 0.5f}};
    const Picture picture = picture_of(scene_of({object_of(triangle_soup(on_screen(corners)))}),
                                       pixel_camera(width, height), width, height, settings());
    EXPECT_EQ(picture.stats.covered_pixels, std::int64_t(width) * height);
    const ScreenTriangle first =
        screen_triangle(at_pixel(0, 0), at_pixel(0, height), at_pixel(width, 0));
    const SampleOffset offset = sample_offsets(samples())[0];
    int wrong = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const bool in_first = exactly_covers(first, x * subpixel + half_pixel + offset.x,
                                             y * subpixel + half_pixel + offset.y);
        wrong += picture.triangle(x, y) != (in_first ? 0u : 1u);
        wrong += picture.colour(x, y)[3] != 1.0f || picture.colour(x, y)[0] != 1.0f;
      }
    EXPECT_EQ(wrong, 0) << width << 'x' << height;
  }
}

TEST(Framebuffers, SizesOutOfRangeAreRefused) {
  for (const auto& [width, height] :
       {std::pair(0, 1), {1, 0}, {-1, 5}, {16385, 1}, {1, 16385}, {2147483647, 2147483647}}) {
    EXPECT_THROW(validate_size(width, height), Error);
    EXPECT_THROW(Framebuffer(width, height), Error);
  }
  EXPECT_NO_THROW(validate_size(16384, 16384));
  Framebuffer never_sized;
  EXPECT_THROW(render(scene_of({}), Camera(), {}, never_sized), Error);
}

}  // namespace
}  // namespace scanlit
