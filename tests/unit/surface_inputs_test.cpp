// (8), (9) What a model is given of the surface: points whole and in every shading, parameters once
// for a span; and nothing that it does not ask for.
#include <cmath>

#include "tests/unit/probe.h"

namespace scanlit {
namespace {

using namespace test;

constexpr int size = 64;
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
    EXPECT_EQ(shown(picture_of(scene_of({probed_object(square(size), probe, shading)}), camera,
                               size, size),
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
  Object object = probed_object(square(size), probe);
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
  auto with = square(size), without = square(size);
  for (glm::vec3& p : with->positions) p.x *= 0.5f;
  with->texcoords = {{3, 4}, {5, 4}, {3, 8}, {5, 8}};
  with->colours.assign(4, {0.25f, 0.5f, 0.75f});
  for (glm::vec3& p : without->positions) p.x = size / 2.0f + p.x / 2;
  without->texcoords.clear();
  for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
    const Picture picture = picture_of(
        scene_of({probed_object(with, probe, shading), probed_object(without, probe, shading)}),
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
  auto mesh = square(size);  // red grows to the right, green downwards
  mesh->colours = {{0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}};
  for (const Shading shading : {Shading::gouraud, Shading::phong}) {
    const Picture picture =
        picture_of(scene_of({probed_object(mesh, probe, shading)}), camera, size, size);
    for (const int x : {0, 10, 63})
      for (const int y : {0, 31, 60}) {
        const auto c = shown(picture, x, y);
        EXPECT_NEAR(c[0], (x + 0.5) / size, 1e-6);
        EXPECT_NEAR(c[1], (y + 0.5) / size, 1e-6);
        EXPECT_NEAR(c[2], 1, 1e-6);
      }
  }
  const Picture flat =
      picture_of(scene_of({probed_object(mesh, probe, Shading::flat)}), camera, size, size);
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
    Scene scene = scene_of({probed_object(square(size), probe, shading)});
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
    auto strip = square(size);
    for (glm::vec3& p : strip->positions)
      p.y = -(16.0f * float(objects.size()) - p.y / 4);  // one below the other
    objects.push_back(probed_object(strip, probe_of(count)));
  }
  const Picture picture = picture_of(scene_of(objects), camera, size, size);
  EXPECT_NEAR(shown(picture, 9, 8)[0], 9.5 + 29, 1e-4);
  EXPECT_NEAR(shown(picture, 9, 24)[0], 9.5, 1e-4);
  EXPECT_NEAR(shown(picture, 9, 40)[0], 9.5 + 6, 1e-4);
}

}  // namespace
}  // namespace scanlit
