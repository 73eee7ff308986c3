// (8), (9) Attributes across a triangle: perspective-correct against a ray/plane evaluation in long
// double, screen-linear where asked for; and where flat, Gouraud and Phong evaluate the model.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

using Real = long double;
using Weights = std::array<Real, 3>;

constexpr int size = 32;

constexpr double near = 1e-4;

/// A front face before eye_at_origin(near), with what stages (3) and (5) make of its corners.
struct Case {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> texcoords;
  ScreenVertex screen[3];
  Real w[3];
};

Case random_case(std::mt19937_64& random, double w_decades) {
  Draw draw{};
  draw.clip_from_object = glm::mat4(clip_from_world(eye_at_origin(near), 1));
  std::uniform_real_distribution<double> on_screen(-2, 2), exponent(0, w_decades), uv(-1, 1);
  Case result;
  for (int i = 0; i < 3; ++i) {
    const double w = 0.01 * std::pow(10.0, exponent(random));
    const glm::vec3 p(on_screen(random) * w, on_screen(random) * w, -w);
    const ClipVertex clip = transform(draw, p);
    result.screen[i] = project(clip, {size, size});
    result.w[i] = clip.w;
    result.positions.push_back(p);
    result.texcoords.emplace_back(uv(random), uv(random));
  }
  if (screen_triangle(result.screen[0], result.screen[1], result.screen[2]).twice_area < 0) {
    // Its normal, +z, would be flipped, away from the light.
    std::swap(result.positions[1], result.positions[2]);
    std::swap(result.texcoords[1], result.texcoords[2]);
    std::swap(result.screen[1], result.screen[2]);
    std::swap(result.w[1], result.w[2]);
  }
  return result;
}

Real determinant(const Real (&a)[3], const Real (&b)[3], const Real (&c)[3]) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// The ray through a pixel's centre meets the plane through three points that lie at distances w on
/// the rays through the snapped vertices: Cramer's rule gives where, as weights of the three.
Weights ray_plane(const Case& c, int x, int y) {
  const Real ray[3] = {Real(x) * subpixel + half_pixel, Real(y) * subpixel + half_pixel, 1};
  Real p[3][3];
  for (int i = 0; i < 3; ++i) {
    p[i][0] = c.screen[i].x * c.w[i], p[i][1] = c.screen[i].y * c.w[i], p[i][2] = c.w[i];
  }
  const Real b[3] = {determinant(ray, p[1], p[2]), determinant(p[0], ray, p[2]),
                     determinant(p[0], p[1], ray)};
  const Real sum = b[0] + b[1] + b[2];
  return {b[0] / sum, b[1] / sum, b[2] / sum};
}

Weights screen_weights(const Case& c, int x, int y) {
  const Exact px = x * subpixel + half_pixel, py = y * subpixel + half_pixel;
  const auto& v = c.screen;
  const Exact e[3] = {exact_edge(v[1], v[2], px, py), exact_edge(v[2], v[0], px, py),
                      exact_edge(v[0], v[1], px, py)};
  const Real sum = Real(e[0] + e[1] + e[2]);
  return {Real(e[0]) / sum, Real(e[1]) / sum, Real(e[2]) / sum};
}

template <class Attribute>
Real mix(const Weights& b, const Attribute& attribute) {
  return b[0] * attribute(0) + b[1] * attribute(1) + b[2] * attribute(2);
}

/// Draws the case and compares position and texture coordinates at every pixel. `tolerance` is
/// relative to the attribute's largest magnitude at the corners.
template <class WeightsAt>
int require_attributes(const Case& c, Interpolation interpolation, const WeightsAt& weights_at,
                       double tolerance) {
  auto mesh = triangle_soup(c.positions);
  mesh->texcoords = c.texcoords;
  RenderSettings settings;
  settings.interpolation = interpolation;
  const Picture picture = picture_of(scene_of({object_of(mesh, ShowPoint())}), eye_at_origin(near),
                                     size, size, settings);
  int compared = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      if (picture.triangle(x, y) == no_id) continue;
      ++compared;
      const Weights b = weights_at(c, x, y);
      const std::size_t pixel = 3 * picture.index(x, y);
      const auto require = [&](float actual, const auto& attribute) {
        const double scale = double(
            std::max({std::abs(attribute(0)), std::abs(attribute(1)), std::abs(attribute(2))}));
        const double error = std::abs(actual - double(mix(b, attribute)));
        if (error > tolerance * scale)
          RC_FAIL("at (" + std::to_string(x) + ", " + std::to_string(y) + ") relative error " +
                  std::to_string(error / scale));
      };
      for (int k = 0; k < 3; ++k)
        require(picture.framebuffer.diffuse[pixel + std::size_t(k)],
                [&](int i) { return Real(c.positions[std::size_t(i)][k]); });
      for (int k = 0; k < 2; ++k)
        require(picture.framebuffer.glossy[pixel + std::size_t(k)],
                [&](int i) { return Real(c.texcoords[std::size_t(i)][k]); });
    }
  return compared;
}

TEST(Interpolation, PerspectiveEqualsRayAndPlane) {
  int compared = 0;
  EXPECT_TRUE(holds(800, [&] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    // Distances that differ by up to a million. Each weight passes six roundings to float.
    const Case c = random_case(random, *rc::gen::element(0.0, 1.0, 3.0, 6.0));
    compared += require_attributes(c, Interpolation::perspective, ray_plane, 1e-6);
  }));
  EXPECT_GT(compared, 10000);
}

TEST(Interpolation, ScreenLinearIsAffineOnTheScreen) {
  int compared = 0;
  EXPECT_TRUE(holds(300, [&] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    const Case c = random_case(random, 2);
    compared += require_attributes(c, Interpolation::screen_linear, screen_weights, 5e-7);
  }));
  EXPECT_GT(compared, 5000);
}

// What fragments are shaded by comes from planes over the screen where distances differ by less
// than a factor of 2, else from weights.
TEST(Interpolation, ColoursAndNormalsEqualRayAndPlane) {
  std::mt19937_64 random(20261122);
  std::uniform_real_distribution<float> unit(-1, 1);
  int compared = 0;
  for (int i = 0; i < 600; ++i) {
    const double decades[] = {0, 0.1, 0.3, 1};
    const Case c = random_case(random, decades[i % 4]);
    auto mesh = triangle_soup(c.positions);
    mesh->texcoords = c.texcoords;
    for (glm::vec3& n : mesh->normals) n = glm::normalize(glm::vec3(unit(random), unit(random), 1));
    const auto drawn = [&](Shading shading) {
      return picture_of(scene_of({object_of(mesh, ShowPoint(), shading)}), eye_at_origin(near),
                        size, size);
    };
    const Picture gouraud = drawn(Shading::gouraud), phong = drawn(Shading::phong);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        if (gouraud.triangle(x, y) == no_id) continue;
        ++compared;
        const Weights b = ray_plane(c, x, y);
        glm::dvec3 normal;
        for (int k = 0; k < 3; ++k) {
          const auto colour = [&](std::size_t v) {
            return Real(c.positions[v][k]) + (k < 2 ? Real(c.texcoords[v][k]) : 0);
          };
          const Real scale =
              std::max({std::abs(colour(0)), std::abs(colour(1)), std::abs(colour(2)), Real(0.01)});
          EXPECT_NEAR(double(gouraud.colour(x, y)[k] / scale), double(mix(b, colour) / scale), 2e-6)
              << i << ": " << x << ' ' << y;
          normal[k] = double(mix(b, [&](std::size_t v) { return Real(mesh->normals[v][k]); }));
        }
        normal = glm::normalize(normal);
        for (int k = 0; k < 3; ++k)
          EXPECT_NEAR(double(phong.framebuffer.normal[3 * phong.index(x, y) + std::size_t(k)]),
                      normal[k], 2e-6)
              << i << ": " << x << ' ' << y;
      }
  }
  EXPECT_GT(compared, 10000);
}

TEST(Interpolation, TheTwoDifferWhereDistancesDo) {
  // Half-way on the screen between distances 1 and 3 lies a quarter of the way in space.
  Case c;
  c.positions = {{-1, -1, -1}, {3, -3, -3}, {-1, 1, -1}};
  c.texcoords = {{0, 0}, {1, 0}, {0, 0}};
  const auto u_in_the_middle = [&](Interpolation interpolation) {
    auto mesh = triangle_soup(c.positions);
    mesh->texcoords = c.texcoords;
    RenderSettings settings;
    settings.interpolation = interpolation;
    const Picture picture = picture_of(scene_of({object_of(mesh, ShowPoint())}),
                                       eye_at_origin(near), 256, 256, settings);
    return picture.framebuffer.glossy[3 * picture.index(127, 254)];
  };
  EXPECT_NEAR(u_in_the_middle(Interpolation::screen_linear), 0.5, 0.003);
  EXPECT_NEAR(u_in_the_middle(Interpolation::perspective), 0.25, 0.003);
}

// ------------------------------------------------------------- where the model is evaluated

/// A model that is not linear over a triangle, so that the place of evaluation shows.
struct SquareOfX {
  template <class T>
  Reflection<T> operator()(const Cosines<T>&, const SurfacePoint<T>& p) const {
    const T x = p.object_position.x;
    return {.diffuse = Rgb<T>(x * x), .glossy = {}};
  }
};

/// A right-angled triangle with x from 0 to 64 over a picture of 64 pixels, y = 0 to 64 too.
Picture square_of_x(Shading shading, int samples = 1) {
  const auto mesh = triangle_soup(on_screen({{0, 0, 0.5f}, {0, 64, 0.5f}, {64, 0, 0.5f}}));
  return picture_of(scene_of({object_of(mesh, SquareOfX(), shading)}), pixel_camera(64, 64), 64, 64,
                    with_samples(samples));
}

TEST(Interpolation, FlatIsConstantAndEvaluatedAtTheCentroid) {
  const Picture picture = square_of_x(Shading::flat);
  EXPECT_EQ(picture.stats.evaluations, 1);
  const float expected = picture.colour(0, 0)[0];
  EXPECT_NEAR(expected, 64.0 * 64 / 9, 1e-3);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 63 - y; ++x) EXPECT_EQ(picture.colour(x, y)[0], expected);
}

TEST(Interpolation, GouraudInterpolatesTheVerticesColours) {
  const Picture picture = square_of_x(Shading::gouraud);
  EXPECT_EQ(picture.stats.evaluations, 3);
  for (int x = 0; x < 63; ++x) EXPECT_NEAR(picture.colour(x, 0)[0], (x + 0.5) * 64, 1e-3);
}

TEST(Interpolation, PhongEvaluatesAtEveryFragment) {
  const Picture picture = square_of_x(Shading::phong);
  EXPECT_EQ(picture.stats.evaluations, picture.stats.fragments);
  for (int x = 0; x < 63; ++x) EXPECT_NEAR(picture.colour(x, 0)[0], (x + 0.5) * (x + 0.5), 1e-3);
}

TEST(Interpolation, GouraudSharesVertexEvaluationsBetweenTriangles) {
  auto mesh =
      triangle_soup(on_screen({{0, 0, 0.5f}, {0, 64, 0.5f}, {64, 0, 0.5f}, {64, 64, 0.5f}}));
  mesh->indices = {0, 1, 2, 3, 2, 1};
  const Picture picture = picture_of(scene_of({object_of(mesh, SquareOfX(), Shading::gouraud)}),
                                     pixel_camera(64, 64), 64, 64);
  EXPECT_EQ(picture.stats.evaluations, 4);
  EXPECT_EQ(picture.stats.covered_pixels, 64 * 64);
}

}  // namespace
}  // namespace scanlit
