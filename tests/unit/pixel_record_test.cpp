// The record of a pixel gives the picture's floats, to the bit.
#include "rasterizer/pixel_record.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "rasterizer/error.h"
#include "rasterizer/shapes.h"
#include "tests/unit/test_scene.h"
#include "tests/unit/tested_models.h"

namespace scanlit {
namespace {

using namespace test;

constexpr int width = 60, height = 44;

/// What models of every kind look at: texture coordinates, tangents, vertex colours.
std::shared_ptr<Mesh> coloured(Mesh mesh, std::mt19937& random) {
  std::uniform_real_distribution<float> unit(0, 1);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.colours.emplace_back(unit(random), unit(random), unit(random));
  return std::make_shared<Mesh>(std::move(mesh));
}

Light light_of(LightKind kind, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  Light light{.kind = kind,
              .intensity = 0.5 + unit(random),
              .colour = {unit(random), unit(random), unit(random)},
              .direction = {unit(random) - 0.5, unit(random) - 0.5, 1},
              .position = {2 * unit(random) - 1, 2 * unit(random) - 1, 2.5},
              .quadratic = unit(random)};
  if (kind == LightKind::spot) light.direction = -light.position;
  return light;
}

/// Two bodies through one another, before a background, so that pixels are mixed.
Scene scene_with(const std::string& model, Shading shading, LightKind kind, std::mt19937& random) {
  Scene scene;
  for (const char* shape : {"sphere:7", "torus:9"}) {
    Object object;
    object.mesh = coloured(make_shape(shape), random);
    object.material.model = models::make(model).model;
    object.material.ka = {0.1, 0.2, 0.15};
    object.material.ambient_share = random() % 2 ? 0.15 : 0;
    object.material.form = random() % 2 ? ColourForm::tinted : ColourForm::plastic;
    object.material.object_colour = {0.9, 0.5, 0.3};
    object.shading = shading;
    object.sides = random() % 2 ? Sides::automatic : Sides::both;
    scene.objects.push_back(object);
  }
  scene.objects[1].world_from_object[3] = {0.2, 0.1, -0.2, 1};
  scene.lights.push_back(light_of(kind, random));
  for (std::size_t i = random() % 3; i > 0; --i)
    scene.lights.push_back(light_of(LightKind(random() % 3), random));
  scene.background = {0.02, 0.3, 0.6};
  return scene;
}

std::string bits_of(const float* rgba) {
  std::string text;
  for (int c = 0; c < 4; ++c) {
    char number[40];
    std::snprintf(number, sizeof number, "%a ", double(rgba[c]));
    text += number;
  }
  return text;
}

void expect_near(const Rgb<float>& actual, const Rgb<float>& expected) {
  EXPECT_NEAR(actual.r, expected.r, 1e-5f * std::abs(expected.r) + 1e-30f);
  EXPECT_NEAR(actual.g, expected.g, 1e-5f * std::abs(expected.g) + 1e-30f);
  EXPECT_NEAR(actual.b, expected.b, 1e-5f * std::abs(expected.b) + 1e-30f);
}

/// The lights' shares, in another order than the engine's sum, make up the point's parts.
void expect_complete(const PointRecord& point, const Scene& scene) {
  EXPECT_EQ(point.lights.size(), scene.lights.size());
  Rgb<float> diffuse{}, glossy{};
  for (const LightRecord& light : point.lights) {
    diffuse = diffuse + light.radiance.diffuse, glossy = glossy + light.radiance.glossy;
    expect_near(light.radiance.diffuse, light.braces.diffuse * (light.diffuse_light * light.share));
    expect_near(light.radiance.glossy, light.braces.glossy * (light.glossy_light * light.share));
  }
  expect_near(point.diffuse, diffuse), expect_near(point.glossy, glossy);
  EXPECT_EQ(point.colour, point.ambient + (point.diffuse + point.glossy));
}

void expect_same(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                 std::mt19937& random) {
  Framebuffer picture(width, height, {.ids = true});
  render(scene, camera, settings, picture);
  for (int k = 0; k < 2;) {
    const int x = int(random() % width), y = int(random() % height);
    const std::size_t at = std::size_t(y) * width + std::size_t(x);
    const float* drawn = &picture.colour[4 * at];
    if (drawn[3] == 0) continue;
    ++k;
    SCOPED_TRACE("pixel " + std::to_string(x) + "," + std::to_string(y));
    const PixelRecord record = record_pixel(scene, camera, settings, width, height, x, y);
    EXPECT_EQ(bits_of(record.colour), bits_of(drawn));
    EXPECT_EQ(bits_of(record.drawn), bits_of(drawn));
    const auto& layers = record.samples[0].layers;
    EXPECT_EQ(layers.empty() ? no_id : layers[0].triangle, picture.triangle_id[at]);
    for (const FragmentRecord& fragment : record.fragments) {
      if (scene.objects[fragment.object].shading != Shading::gouraud) {
        EXPECT_EQ(fragment.colour, fragment.points[0].colour);
      }
      if (settings.clamp_vertex_colours) continue;
      for (const PointRecord& point : fragment.points) expect_complete(point, scene);
    }
  }
}

class PixelRecords : public testing::TestWithParam<std::string> {};

TEST_P(PixelRecords, AreThePicturesFloatsToTheBit) {
  const std::string name = GetParam();
  std::seed_seq seed(name.begin(), name.end());
  std::mt19937 random(seed);
  const std::vector<std::string> specifications = tested(name).specifications;
  for (int run = 0; run < 36; ++run) {  // every shading with every sample count and kind of light
    const auto shading = Shading(run % 3);
    const int samples = run / 3 % 4 ? 2 << (run / 3 % 4) : 1;
    const auto kind = LightKind(run / 12);
    const std::string& model = specifications[random() % specifications.size()];
    SCOPED_TRACE(model + ", shading " + std::to_string(int(shading)) + ", " +
                 std::to_string(samples) + " samples, light " + std::to_string(int(kind)));
    const Scene scene = scene_with(model, shading, kind, random);
    Camera camera{.eye = {0.6, 0.8, 2.6}};
    camera.viewer_at_infinity = random() % 2;
    camera.near = random() % 3 ? 0.1 : 2;  // cuts the bodies open
    RenderSettings settings = with_samples(samples);
    settings.clamp_vertex_colours = random() % 2;
    settings.interpolation = Interpolation(random() % 2);
    expect_same(scene, camera, settings, random);
  }
}

TEST(PixelRecord, HidesWhatLiesBehindNearestFirst) {
  // Three layers, the nearest drawn second, at the whole picture's pixels.
  std::vector<glm::vec3> corners;
  for (const float z : {0.25f, 0.75f, 0.5f})
    for (const glm::vec3& corner : {glm::vec3(-20, -20, z), {-20, 60, z}, {60, -20, z}})
      corners.push_back(corner);
  const Scene scene = scene_of({object_of(triangle_soup(on_screen(corners)))});
  const PixelRecord record = record_pixel(scene, pixel_camera(16, 16), {}, 16, 16, 3, 4);
  ASSERT_EQ(record.samples.size(), 1u);
  std::vector<std::uint32_t> triangles;
  for (const LayerRecord& layer : record.samples[0].layers) triangles.push_back(layer.triangle);
  EXPECT_EQ(triangles, (std::vector<std::uint32_t>{1, 2, 0}));
  EXPECT_FLOAT_EQ(record.samples[0].layers[0].depth, 0.75f);
  ASSERT_EQ(record.fragments.size(), 1u);
  EXPECT_EQ(record.fragments[0].triangle, 1u);
  EXPECT_EQ(record.fragments[0].weight, 1);
  EXPECT_THROW(record_pixel(scene, pixel_camera(16, 16), {}, 16, 16, 16, 4), Error);
  EXPECT_THROW(record_pixel(scene, pixel_camera(16, 16), {}, 16, 16, 0, -1), Error);
}

INSTANTIATE_TEST_SUITE_P(AllModels, PixelRecords, testing::ValuesIn(names_of(models::Kind::model)),
                         word);

}  // namespace
}  // namespace scanlit
