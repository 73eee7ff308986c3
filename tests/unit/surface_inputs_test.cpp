// (8), (9) What a model is given of the surface: points whole and in every shading, parameters once
// for a span, derivatives of the texture coordinates; and nothing that it does not ask for.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/shapes.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

constexpr int size = 64;

/// A model that shows six numbers a point, and counts how it is called.
class Probe : public ReflectionModel {
 public:
  using Show = std::function<std::array<float, 6>(const DirectionSpan&, std::size_t)>;

  Probe(const Needs& needs, Show show) : needs_(needs), show_(std::move(show)) {}

  Needs needs() const override { return needs_; }

  /// Parameter k of point i is its number k's share: position plus k.
  void evaluate_parameters(const PointSpan& points, float* const* parameters) const override {
    ++parameter_calls;
    for (std::size_t k = 0; k < needs_.parameters; ++k)
      for (std::size_t i = 0; i < (points.size + max_lanes - 1) / max_lanes * max_lanes; ++i)
        parameters[k][i] = points.object_position[0][i] + float(k);
  }

  void evaluate(const DirectionSpan& in, const ReflectionSpan& out) const override {
    ++calls;
    for (std::size_t i = 0; i < in.size; ++i) {
      const std::array<float, 6> shown = show_(in, i);
      for (std::size_t c = 0; c < 3; ++c)
        out.diffuse[c][i] = shown[c], out.glossy[c][i] = shown[3 + c];
    }
  }
  Reflection<double> evaluate(const Vec3<double>&, const Vec3<double>&,
                              const SurfacePoint<double>&) const override {
    return {};
  }
  Reflection<float> evaluate(const Vec3<float>&, const Vec3<float>&,
                             const SurfacePoint<float>&) const override {
    return {};
  }

  mutable std::atomic<int> calls = 0, parameter_calls = 0;

 private:
  Needs needs_;
  Show show_;
};

Object object_of(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Probe> probe,
                 Shading shading = Shading::phong) {
  Object object = test::object_of(std::move(mesh), White(), shading);
  object.material.model = std::move(probe);
  return object;
}

/// The six numbers at a pixel.
std::array<float, 6> shown(const Picture& picture, int x, int y) {
  const float* diffuse = &picture.framebuffer.diffuse[3 * picture.index(x, y)];
  const float* glossy = &picture.framebuffer.glossy[3 * picture.index(x, y)];
  return {diffuse[0], diffuse[1], diffuse[2], glossy[0], glossy[1], glossy[2]};
}

/// A square that fills the picture of pixel_camera(size, size).
std::shared_ptr<Mesh> square() {
  auto mesh = triangle_soup(
      on_screen({{0, 0, 0.5f}, {0, size, 0.5f}, {size, 0, 0.5f}, {size, size, 0.5f}}));
  mesh->indices = {0, 1, 2, 3, 2, 1};
  return mesh;
}

const Camera camera = pixel_camera(size, size);

// ------------------------------------------------------------------------------------- points

TEST(SurfaceInputs, NothingIsGivenThatIsNotAskedFor) {
  const auto probe = std::make_shared<Probe>(Needs{}, [](const DirectionSpan& in, std::size_t) {
    return std::array<float, 6>{float(in.points != nullptr),
                                float(in.tangent[0] != nullptr),
                                float(in.parameters != nullptr),
                                1,
                                0,
                                0};
  });
  for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong})
    EXPECT_EQ(shown(picture_of(scene_of({object_of(square(), probe, shading)}), camera, size, size),
                    5, 5),
              (std::array<float, 6>{0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(probe->parameter_calls, 0);
}

TEST(SurfaceInputs, PointsHoldNormalTangentAndTransform) {
  const auto probe = std::make_shared<Probe>(
      Needs{.frame = true, .surface_point = true}, [](const DirectionSpan& in, std::size_t i) {
        const PointSpan& p = *in.points;
        float differences = 0;
        for (int c = 0; c < 3; ++c)
          differences += std::abs(p.normal[c][i] - in.normal[c][i]) +
                         std::abs(p.tangent[c][i] - in.tangent[c][i]);
        return std::array<float, 6>{p.normal[2][i],
                                    p.tangent[0][i],
                                    p.world_from_object[1][0],
                                    p.world_from_object[2][2],
                                    differences,
                                    float(p.texcoord_dx[0] != nullptr)};
      });
  Object object = object_of(square(), probe);
  object.world_from_object[1][0] = 0.25f;  // a shear: x grows with y
  object.world_from_object[2][2] = 0.5f;
  const Picture picture = picture_of(scene_of({object}), camera, size, size);
  EXPECT_EQ(shown(picture, 1, 1), (std::array<float, 6>{1, 1, 0.25f, 0.5f, 0, 0}));
}

TEST(SurfaceInputs, TexcoordsAndColoursOfMeshesWithoutThemAreZeroAndWhite) {
  const Needs needs{.surface_point = true, .texcoord_derivatives = true};
  const auto show = [](const DirectionSpan& in, std::size_t i) {
    const PointSpan& p = *in.points;
    float growth = 0;
    for (int c = 0; c < 2; ++c)
      if (p.texcoord_dx[c]) growth += std::abs(p.texcoord_dx[c][i]) + std::abs(p.texcoord_dy[c][i]);
    return std::array<float, 6>{p.texcoord[0][i],      p.texcoord[1][i],      p.vertex_colour[0][i],
                                p.vertex_colour[1][i], p.vertex_colour[2][i], growth};
  };
  const auto probe = std::make_shared<Probe>(needs, show);
  // First an object that has them, on the left, then one that has not: spans are used again.
  auto with = square(), without = square();
  for (glm::vec3& p : with->positions) p.x *= 0.5f;
  with->texcoords = {{3, 4}, {5, 4}, {3, 8}, {5, 8}};
  with->colours.assign(4, {0.25f, 0.5f, 0.75f});
  for (glm::vec3& p : without->positions) p.x = size / 2.0f + p.x / 2;
  without->texcoords.clear();
  for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
    const Picture picture =
        picture_of(scene_of({object_of(with, probe, shading), object_of(without, probe, shading)}),
                   camera, size, size);
    const auto left = shown(picture, 3, 3), right = shown(picture, size - 3, 3);
    EXPECT_GE(left[0], 3);
    EXPECT_NEAR(left[2], 0.25, 1e-6);
    EXPECT_NEAR(left[3], 0.5, 1e-6);
    EXPECT_NEAR(left[4], 0.75, 1e-6);
    EXPECT_EQ(left[5] > 0, shading == Shading::phong);  // vertices and faces are no pixels
    EXPECT_EQ(right, (std::array<float, 6>{0, 0, 1, 1, 1, 0}));
  }
}

TEST(SurfaceInputs, VertexColoursAreInterpolated) {
  const auto probe = std::make_shared<Probe>(
      Needs{.surface_point = true}, [](const DirectionSpan& in, std::size_t i) {
        const auto& c = in.points->vertex_colour;
        return std::array<float, 6>{c[0][i], c[1][i], c[2][i], 0, 0, 0};
      });
  auto mesh = square();  // red grows to the right, green downwards
  mesh->colours = {{0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}};
  for (const Shading shading : {Shading::gouraud, Shading::phong}) {
    const Picture picture =
        picture_of(scene_of({object_of(mesh, probe, shading)}), camera, size, size);
    for (const int x : {0, 10, 63})
      for (const int y : {0, 31, 60}) {
        const auto c = shown(picture, x, y);
        EXPECT_NEAR(c[0], (x + 0.5) / size, 1e-6);
        EXPECT_NEAR(c[1], (y + 0.5) / size, 1e-6);
        EXPECT_NEAR(c[2], 1, 1e-6);
      }
  }
  const Picture flat =
      picture_of(scene_of({object_of(mesh, probe, Shading::flat)}), camera, size, size);
  EXPECT_NEAR(shown(flat, 1, 1)[0], 1.0 / 3, 1e-6);
}

// --------------------------------------------------------------------------------- parameters

TEST(SurfaceInputs, ParametersAreEvaluatedOnceForASpanWhateverTheLights) {
  const auto probe =
      std::make_shared<Probe>(Needs{.parameters = 5}, [](const DirectionSpan& in, std::size_t i) {
        const auto& p = in.parameters;
        return std::array<float, 6>{p[0][i], p[1][i], p[2][i], p[3][i], p[4][i], 0};
      });
  for (const Shading shading : {Shading::phong, Shading::gouraud}) {
    probe->calls = probe->parameter_calls = 0;
    Scene scene = scene_of({object_of(square(), probe, shading)});
    scene.lights.resize(3);
    for (Light& light : scene.lights) light.intensity = 1.0 / 3;
    const Picture picture = picture_of(scene, camera, size, size);
    EXPECT_GT(probe->parameter_calls, 0);
    EXPECT_EQ(probe->calls, 3 * probe->parameter_calls);
    for (const int x : {0, 17, 63})
      for (std::size_t k = 0; k < 5; ++k)
        EXPECT_NEAR(shown(picture, x, 40)[k], x + 0.5 + double(k), 1e-4);
  }
}

TEST(SurfaceInputs, ModelsOfMoreAndFewerParametersShareTheArrays) {
  const auto probe_of = [](std::size_t count) {
    return std::make_shared<Probe>(
        Needs{.parameters = count}, [count](const DirectionSpan& in, std::size_t i) {
          return std::array<float, 6>{in.parameters[count - 1][i], 0, 0, 0, 0, 0};
        });
  };
  std::vector<Object> objects;
  for (const std::size_t count : {std::size_t(30), std::size_t(1), std::size_t(7)}) {
    auto strip = square();
    for (glm::vec3& p : strip->positions)
      p.y = -(16.0f * float(objects.size()) - p.y / 4);  // one below the other
    objects.push_back(object_of(strip, probe_of(count)));
  }
  const Picture picture = picture_of(scene_of(objects), camera, size, size);
  EXPECT_NEAR(shown(picture, 9, 8)[0], 9.5 + 29, 1e-4);
  EXPECT_NEAR(shown(picture, 9, 24)[0], 9.5, 1e-4);
  EXPECT_NEAR(shown(picture, 9, 40)[0], 9.5 + 6, 1e-4);
}

// -------------------------------------------------------------------------------- derivatives

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
      picture_of(scene_of({object_of(mesh, growth_probe())}), eye_at_origin(0.25), size, size);
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
  auto mesh = square();
  const float u = 1000, du = 1.0f / 1024;
  mesh->texcoords = {{u, 0}, {u, du}, {u + du, 0}, {u + du, du}};
  for (const Interpolation interpolation :
       {Interpolation::perspective, Interpolation::screen_linear}) {
    RenderSettings settings;
    settings.interpolation = interpolation;
    const Picture picture =
        picture_of(scene_of({object_of(mesh, growth_probe())}), camera, size, size, settings);
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
  const Picture picture = picture_of(scene_of({object_of(mesh, growth_probe())}), eye_at_origin(),
                                     size, size, settings);
  for (const int x : {1, 20, 40}) {
    const auto g = shown(picture, x, 60);
    EXPECT_NEAR(g[0], 1.0 / size, 1e-7);
    EXPECT_NEAR(g[2], 0, 1e-7);
    EXPECT_NEAR(g[3], -1.0 / size, 1e-7);
  }
}

TEST(TexcoordDerivatives, AreThoseOfAPixelWhateverTheSamples) {
  // Of back faces too.
  auto mesh = square();
  mesh->texcoords = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
  std::reverse(mesh->indices.begin(), mesh->indices.end());
  const Picture picture =
      picture_of(scene_of({object_of(mesh, growth_probe())}), camera, size, size, with_samples(4));
  for (int i = 0; i < size; ++i) {  // through the diagonal's split pixels
    EXPECT_NEAR(shown(picture, i, 30)[0], 1.0 / size, 1e-7);
    EXPECT_NEAR(shown(picture, i, 30)[3], 1.0 / size, 1e-7);
  }
}

}  // namespace
}  // namespace scanlit
