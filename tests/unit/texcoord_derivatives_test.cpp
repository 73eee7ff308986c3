// (8), (9) Derivatives of the texture coordinates, from pixel to pixel, against exact perspective.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <string>
#include <vector>

#include "tests/unit/probe.h"

namespace scanlit {
namespace {

using namespace test;

constexpr int size = 64;
const Camera camera = pixel_camera(size, size);

std::shared_ptr<Probe> growth_probe() {
  return std::make_shared<Probe>(
      Needs{.surface_point = true, .texcoord_derivatives = true},
      [](const DirectionSpan& in, std::size_t i) {
        const PointSpan& p = *in.points;
        return std::array<float, 6>{p.texcoord_dx[0][i], p.texcoord_dx[1][i], p.texcoord_dy[0][i],
                                    p.texcoord_dy[1][i], p.texcoord[0][i],    p.texcoord[1][i]};
      });
}

using Real = long double;

/// Where the ray through a point of the screen, in pixels, meets a triangle's plane: the weights of
/// its corners, exactly (Cramer's rule), from the positions before the eye at the origin. What the
/// engine snaps to 1/256 pixel is not snapped here.
std::array<Real, 3> ray_weights(const std::vector<glm::vec3>& p, Real x, Real y) {
  const glm::vec<3, Real> ray(x * 2 / size - 1, 1 - y * 2 / size, -1);
  const auto determinant = [](const auto& a, const auto& b, const auto& c) {
    return glm::dot(a, glm::cross(b, c));
  };
  const glm::vec<3, Real> a(p[0]), b(p[1]), c(p[2]);
  const Real w[3] = {determinant(ray, b, c), determinant(a, ray, c), determinant(a, b, ray)};
  const Real sum = w[0] + w[1] + w[2];
  return {w[0] / sum, w[1] / sum, w[2] / sum};
}

/// A front face that covers much of the picture, its corners at distances up to `ratio` from each
/// other, often behind the eye: then it is clipped.
std::vector<glm::vec3> random_triangle(std::mt19937_64& random, double ratio, bool clipped) {
  std::uniform_real_distribution<double> side(-2.5, 2.5), exponent(0, std::log(ratio));
  while (true) {
    std::vector<glm::vec3> p;
    for (int i = 0; i < 3; ++i) {
      // On the grid of 1/256 pixel of a picture of 64 pixels: x / w in 128ths of a pixel.
      const double w = std::exp2(std::round(std::log2(std::exp(exponent(random)))));
      p.emplace_back(std::round(side(random) * 4096) / 4096 * w,
                     std::round(side(random) * 4096) / 4096 * w, -w);
    }
    if (clipped) p[0].z = 0.5f * std::abs(p[0].z);
    const glm::dvec3 normal = glm::cross(glm::dvec3(p[1] - p[0]), glm::dvec3(p[2] - p[0]));
    const double facing = -glm::dot(normal, glm::dvec3(p[0])) / glm::length(normal);
    if (facing < 0) std::swap(p[1], p[2]);
    if (std::abs(facing) > 0.2) return p;
  }
}

/// Compares the derivatives at every pixel with central differences of the exact interpolation.
int require_growth(const std::vector<glm::vec3>& positions, double tolerance) {
  auto mesh = triangle_soup(positions);
  mesh->texcoords = {{0.1f, 0.9f}, {2.5f, -0.3f}, {-1.2f, 0.4f}};
  const Picture picture =
      picture_of(scene_of({probed_object(mesh, growth_probe())}), eye_at_origin(0.25), size, size);
  const Real step = 1e-4L;
  int compared = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      if (picture.triangle(x, y) == no_id) continue;
      ++compared;
      const auto actual = shown(picture, x, y);
      const auto growth = [&](Real dx, Real dy, int k) {
        const auto after = ray_weights(positions, x + 0.5L + dx * step, y + 0.5L + dy * step);
        const auto before = ray_weights(positions, x + 0.5L - dx * step, y + 0.5L - dy * step);
        Real sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
          sum += (after[i] - before[i]) * Real(mesh->texcoords[i][k]);
        return sum / (2 * step);
      };
      Real expected[4], largest = 0;
      for (int i = 0; i < 4; ++i) {
        expected[i] = growth(i < 2, i >= 2, i % 2);
        largest = std::max(largest, std::abs(expected[i]));
      }
      for (std::size_t i = 0; i < 4; ++i) {
        const double error = std::abs(double(expected[i]) - double(actual[i]));
        if (!(error <= tolerance * double(largest)))
          RC_FAIL("at (" + std::to_string(x) + ", " + std::to_string(y) + ") " +
                  std::to_string(actual[i]) + " instead of " + std::to_string(double(expected[i])));
      }
    }
  return compared;
}

TEST(TexcoordDerivatives, EqualDifferencesOfExactPerspective) {
  int compared = 0;
  EXPECT_TRUE(holds(200, [&] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    compared += require_growth(random_triangle(random, 16, false), 2e-5);
  }));
  EXPECT_GT(compared, 50000);
}

TEST(TexcoordDerivatives, EqualDifferencesOfExactPerspectiveInClippedPieces) {
  // Cut at the near plane: the cut points are snapped to 1/256 pixel, which the ray is not.
  int compared = 0;
  EXPECT_TRUE(holds(200, [&] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    std::vector<glm::vec3> p = random_triangle(random, 4, true);
    p[0].z = 0.5f;  // behind the eye
    const glm::dvec3 normal = glm::cross(glm::dvec3(p[1] - p[0]), glm::dvec3(p[2] - p[0]));
    const double facing = -glm::dot(normal, glm::dvec3(p[0])) / glm::length(normal);
    RC_PRE(std::abs(facing) > 0.2);
    compared += require_growth(p, 2e-3);
  }));
  EXPECT_GT(compared, 20000);
}

TEST(TexcoordDerivatives, AreExactUnderGreatMagnification) {
  // A thousandth of a texel to a pixel: a difference of two coordinates would be nothing but
  // rounding.
  auto mesh = square(size);
  const float u = 1000, du = 1.0f / 1024;
  mesh->texcoords = {{u, 0}, {u, du}, {u + du, 0}, {u + du, du}};
  for (const Interpolation interpolation :
       {Interpolation::perspective, Interpolation::screen_linear}) {
    RenderSettings settings;
    settings.interpolation = interpolation;
    const Picture picture =
        picture_of(scene_of({probed_object(mesh, growth_probe())}), camera, size, size, settings);
    for (const int x : {0, 13, 63}) {
      const auto g = shown(picture, x, 20);
      EXPECT_NEAR(g[0], du / size, 1e-7 * du);
      EXPECT_NEAR(g[1], 0, 1e-7 * du);
      EXPECT_NEAR(g[2], 0, 1e-7 * du);
      EXPECT_NEAR(g[3], du / size, 1e-7 * du);
    }
  }
}

TEST(TexcoordDerivatives, AreConstantWhereInterpolationIsLinearOnTheScreen) {
  auto mesh = triangle_soup({{-1, -1, -1}, {3, -3, -3}, {-1, 1, -1}});
  mesh->texcoords = {{0, 0}, {1, 0}, {0, 1}};
  RenderSettings settings;
  settings.interpolation = Interpolation::screen_linear;
  const Picture picture = picture_of(scene_of({probed_object(mesh, growth_probe())}),
                                     eye_at_origin(), size, size, settings);
  for (const int x : {1, 20, 40}) {
    const auto g = shown(picture, x, 60);
    EXPECT_NEAR(g[0], 1.0 / size, 1e-7);
    EXPECT_NEAR(g[2], 0, 1e-7);
    EXPECT_NEAR(g[3], -1.0 / size, 1e-7);
  }
}

TEST(TexcoordDerivatives, AreThoseOfAPixelWhateverTheSamples) {
  // Of back faces too.
  auto mesh = square(size);
  mesh->texcoords = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
  std::reverse(mesh->indices.begin(), mesh->indices.end());
  Scene scene = scene_of({probed_object(mesh, growth_probe())});
  scene.lights[0].direction = {0, 0, -1};  // onto the side that is seen by its flipped normal
  const Picture picture = picture_of(scene, camera, size, size, with_samples(4));
  for (int i = 0; i < size; ++i) {  // through the diagonal's split pixels
    EXPECT_NEAR(shown(picture, i, 30)[0], 1.0 / size, 1e-7);
    EXPECT_NEAR(shown(picture, i, 30)[3], 1.0 / size, 1e-7);
  }
}

}  // namespace
}  // namespace scanlit
