// With RenderSettings::tolerance no pixel is off by more than it says: scenes made by chance, and
// climbed from there towards larger errors.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "models/registry.h"
#include "rasterizer/error.h"
#include "rasterizer/image/image_encoding.h"
#include "rasterizer/shapes.h"
#include "rasterizer/strides.h"
#include "tests/unit/test_scene.h"

namespace scanlit {
namespace {

using namespace test;

constexpr int width = 160, height = 120;

/// A scene is written in numbers from 0 to 1, so that it can be changed a little.
using Genes = std::vector<double>;
constexpr std::size_t gene_count = 60;

class Reader {
 public:
  explicit Reader(const Genes& genes) : genes_(genes) {}

  double between(double from, double to) { return from + (to - from) * genes_.at(next_++); }
  std::size_t below(std::size_t count) {
    return std::min(count - 1, std::size_t(between(0, double(count))));
  }
  glm::dvec3 vector() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }

 private:
  const Genes& genes_;
  std::size_t next_ = 0;
};

std::string specification(Reader& genes) {
  const auto number = [&](double from, double to) {
    return std::to_string(std::exp(genes.between(std::log(from), std::log(to))));
  };
  const std::string wide = number(.05, 1), sharp = number(1, 2000);
  const std::string all[] = {"lambert",
                             "phong:kd=.3,ks=.7,n=" + sharp,
                             "blinn-phong:kd=.2,ks=.8,n=" + sharp,
                             "blinn-phong:normalised=1,kd=.2,ks=.6,n=" + sharp,
                             "oren-nayar:sigma=" + wide,
                             "oren-nayar-full:sigma=" + wide,
                             "cook-torrance:F=silver,m=" + wide,
                             "cook-torrance:F=dielectric,D=ggx,G=smith,a=" + wide,
                             "torrance-sparrow:m=" + wide,
                             "torrance-sparrow:D=blinn,n=" + sharp,
                             "ashikhmin-shirley:nu=" + wide + ",nv=" + sharp,
                             "ward:kd=.2,ax=" + wide + ",ay=.1"};
  return all[genes.below(std::size(all))];
}

struct Written {
  Scene scene;
  Camera camera;
  std::string model;
};

Written scene_of(const Genes& genes) {
  Reader read(genes);
  Written all;
  const char* const shapes[] = {"cube",    "sphere:3", "sphere:6",  "icosphere:1",
                                "torus:6", "plane",    "sphere:16", "torus:24"};
  const auto mesh = std::make_shared<Mesh>(make_shape(shapes[read.below(std::size(shapes))]));
  // Normals that turn faster than the surface.
  const glm::vec3 bend(0.5 * read.vector());
  for (std::size_t i = 0; i < mesh->normals.size(); ++i)
    mesh->normals[i] = glm::normalize(mesh->normals[i] + bend * mesh->positions[i]);
  Object object;
  object.mesh = mesh;
  all.model = specification(read);
  object.material.model = models::make(all.model).model;
  object.material.ka = Rgb<double>(read.between(0, .1));
  object.sides = Sides::both;
  const double stretch = std::exp(read.between(-1, 1));
  object.world_from_object = glm::scale(glm::mat4(1), glm::vec3(1, 1, stretch));
  all.scene.objects.push_back(object);
  const std::size_t lights = 1 + read.below(4);
  for (std::size_t i = 0; i < lights; ++i) {
    const LightKind kinds[] = {LightKind::directional, LightKind::point, LightKind::spot};
    Light light{.kind = kinds[read.below(3)], .intensity = std::exp(read.between(-3, 2))};
    light.direction = read.vector() + glm::dvec3(1e-3);
    light.position = 3.0 * read.vector();
    if (light.kind == LightKind::spot) light.direction = -light.position - glm::dvec3(1e-3);
    light.quadratic = read.between(0, 1);
    all.scene.lights.push_back(light);
  }
  all.camera.eye = read.between(1.2, 4) * glm::normalize(read.vector() + glm::dvec3(1e-3));
  all.camera.target = 0.5 * read.vector();
  all.camera.up = {1e-3, 1, 2e-3};
  all.camera.fov_deg = read.between(10, 100);
  all.camera.viewer_at_infinity = read.below(3) == 0;
  return all;
}

double code(float linear, ColourFormat format) {
  const double c = std::max(double(linear), 0.0);
  if (format == ColourFormat::linear_8bit) return 255 * c;
  return 255 * (c <= .0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - .055);
}

struct Outcome {
  double worst = 0;  // in codes, before they are rounded
  double evaluated = 1;
};

Outcome compare(const Written& written, double tolerance, int samples) {
  Framebuffer pictures[2] = {{width, height}, {width, height}};
  FrameStats stats[2];
  for (int i = 0; i < 2; ++i) {
    const RenderSettings settings{
        .samples = samples, .threads = 1, .tolerance = i == 0 ? 0 : tolerance};
    stats[i] = render(written.scene, written.camera, settings, pictures[i]);
  }
  Outcome outcome;
  const auto &exact = pictures[0].colour, &near = pictures[1].colour;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const double a = code(exact[i], ColourFormat::linear_float),
                 b = code(near[i], ColourFormat::linear_float);
    outcome.worst = std::max(outcome.worst, std::abs(a - b));
  }
  outcome.evaluated =
      double(stats[1].evaluations) / double(std::max<std::int64_t>(1, stats[0].evaluations));
  return outcome;
}

Genes random_genes(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  Genes genes(gene_count);
  for (double& gene : genes) gene = unit(random);
  return genes;
}

TEST(Tolerance, HoldsInScenesMadeByChance) {
  std::mt19937 random(5);
  double evaluated = 0;
  constexpr int count = 150;
  for (int i = 0; i < count; ++i) {
    const Written written = scene_of(random_genes(random));
    const double tolerance = i % 3 == 0 ? .3 : i % 3 == 1 ? 1 : 4;
    const Outcome outcome = compare(written, tolerance, i % 4 == 0 ? 4 : 1);
    EXPECT_LE(outcome.worst, tolerance) << "scene " << i << ", " << written.model;
    evaluated += outcome.evaluated / count;
  }
  EXPECT_LT(evaluated, .95);  // many of the triangles are a few pixels small
}

// Small changes that make the error larger are kept, others not.
TEST(Tolerance, HoldsWhereErrorsAreSoughtOut) {
  constexpr double tolerance = 1;
  std::mt19937 random(11);
  std::normal_distribution<double> step(0, 1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int climb = 0; climb < 8; ++climb) {
    Genes best;
    double worst = -1;
    for (int i = 0; i < 80; ++i) {
      Genes genes = i < 20 ? random_genes(random) : best;
      const double size = std::pow(10.0, -3 * unit(random));
      for (double& gene : genes)
        if (i >= 20 && unit(random) < .15) gene = std::clamp(gene + size * step(random), 0.0, 1.0);
      const Written written = scene_of(genes);
      const double error = compare(written, tolerance, 1).worst;
      ASSERT_LE(error, tolerance) << "climb " << climb << ", step " << i << ", " << written.model;
      if (error > worst) worst = error, best = genes;
    }
  }
}

Scene lit_sphere() {
  Scene scene;
  Object object;
  object.mesh = std::make_shared<Mesh>(make_shape("sphere:12"));
  object.material.model = models::make("blinn-phong:n=30").model;
  scene.objects.push_back(object);
  scene.lights = {{.direction = {1, 1, 1}},
                  {.kind = LightKind::point, .intensity = 3, .position = {-2, 1, 3}}};
  return scene;
}

TEST(Tolerance, HoldsInTheOneChannelThatIsLit) {
  for (const Rgb<double> colour : {Rgb<double>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    Written written{
        .scene = lit_sphere(), .camera = {.target = {.4, .4, .8}, .fov_deg = 8}, .model = ""};
    for (Light& light : written.scene.lights) light.colour = colour;
    const Outcome outcome = compare(written, 1, 1);
    EXPECT_LE(outcome.worst, 1) << colour.r << colour.g << colour.b;
    EXPECT_LT(outcome.evaluated, .95);
  }
}

/// Of a wall whose normals lean one way, the more so the farther, so that a light sets across it.
double evaluated_where_a_light_sets(const glm::vec3& aside, float lean) {
  double evaluated = 0;
  for (int i = 0; i < 150; ++i) {
    const auto mesh = std::make_shared<Mesh>(make_shape("plane"));
    for (std::size_t k = 0; k < mesh->normals.size(); ++k) {
      const float along = glm::dot(mesh->positions[k], aside) + 0.01f * float(i - 75);
      mesh->normals[k] = glm::normalize(glm::vec3(0, 0, 1) + lean * along * aside);
    }
    Object object;
    object.mesh = mesh;
    object.material.model = models::make("lambert").model;
    object.material.ka = Rgb<double>(0);
    Written written{.scene = {}, .camera = {.eye = {0, 0, 2.2}}, .model = ""};
    written.scene.objects.push_back(object);
    written.scene.lights = {{.intensity = i % 3 == 0   ? .3
                                          : i % 3 == 1 ? .6
                                                       : 1.2,
                             .direction = aside}};
    const Outcome outcome = compare(written, 1, 1);
    EXPECT_LE(outcome.worst, 1) << aside.y << ' ' << i;
    evaluated += outcome.evaluated / 150;
  }
  return evaluated;
}

// A line from a cell to the next would be bounded by neither: not where one is straight and the
// other dark but for its first pixels. Nor is a cell like the one above it.
TEST(Tolerance, HoldsWhereALightSetsInALargeTriangle) {
  EXPECT_LT(evaluated_where_a_light_sets({1, 0, 0}, .02), .5);
  EXPECT_LT(evaluated_where_a_light_sets(glm::normalize(glm::vec3(1, 1, 0)), .1), .7);
}

TEST(Tolerance, SparesEvaluationsAndIsTheSameForAnyThreads) {
  Framebuffer full(800, 600), one(800, 600), three(800, 600);
  const FrameStats all = render(lit_sphere(), {}, {.threads = 1}, full);
  const FrameStats some = render(lit_sphere(), {}, {.threads = 1, .tolerance = 1}, one);
  render(lit_sphere(), {}, {.threads = 3, .tolerance = 1}, three);
  EXPECT_LT(some.evaluations, all.evaluations * 2 / 3);
  EXPECT_EQ(some.fragments, all.fragments);
  EXPECT_NE(one.colour, full.colour);
  EXPECT_EQ(one.colour, three.colour);
}

TEST(Tolerance, IsOfTheEightBitCodesOfTheFramebuffer) {
  for (const ColourFormat format : {ColourFormat::linear_8bit, ColourFormat::srgb_8bit}) {
    Framebuffer full(800, 600, {.format = format}), near(800, 600, {.format = format});
    render(lit_sphere(), {}, {}, full);
    render(lit_sphere(), {}, {.tolerance = 1}, near);
    int largest = 0;
    for (std::size_t i = 0; i < full.rgba8.size(); ++i)
      largest = std::max(largest, std::abs(int(full.rgba8[i]) - int(near.rgba8[i])));
    EXPECT_EQ(largest, 1);
  }
}

TEST(Tolerance, ChangesNothingWhereMoreThanColourIsAskedFor) {
  const Planes planes{.normal = true, .parts = true};
  Framebuffer full(200, 150, planes), near(200, 150, planes);
  render(lit_sphere(), {}, {}, full);
  render(lit_sphere(), {}, {.tolerance = 1}, near);
  EXPECT_EQ(full.colour, near.colour);
}

TEST(Tolerance, OutOfRangeIsAnError) {
  Framebuffer framebuffer(8, 8);
  for (const double tolerance : {-1.0, 256.0, std::nan("")})
    EXPECT_THROW(render(lit_sphere(), {}, {.tolerance = tolerance}, framebuffer), Error);
}

}  // namespace
}  // namespace scanlit
