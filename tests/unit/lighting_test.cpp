// Lights: what arrives at a point, against the lecture's equations in double.
#include "rasterizer/lighting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "tests/unit/lighting_studio.h"

namespace scanlit {
namespace {

using namespace test;

/// Every point under `source`, which arrives from direction l with irradiance(point).
template <class Direction, class Irradiance>
void expect_lit_by(const Light& source, Direction towards_light, Irradiance irradiance) {
  Studio studio;
  studio.scene.lights = {source};
  const glm::dvec3 colour(source.colour.r, source.colour.g, source.colour.b);
  const auto lit = studio.light(points);
  double brightest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [position, normal] = points[i];
    const glm::dvec3 v = glm::normalize(studio.camera.eye - position);
    const double e = irradiance(position);
    const Braces part = braces(normal, towards_light(position), v);
    expect_near(lit[i].diffuse, part.diffuse * e * colour, 1e-5 * source.intensity);
    expect_near(lit[i].glossy, part.glossy * e * colour, 1e-5 * source.intensity);
    brightest = std::max(brightest, lit[i].diffuse.r);
  }
  EXPECT_GT(brightest, 1e-3) << "the test looks at something";
}

// -------------------------------------------------------------------------------- kinds of light

TEST(Lighting, Directional) {
  const Light sun{.intensity = 2, .colour = {1, 0.5, 0.25}, .direction = {1, 2, 3}};
  expect_lit_by(
      sun, [&](const auto&) { return glm::normalize(sun.direction); },
      [](const auto&) { return 2.0; });
}

TEST(Lighting, PointWithEachFallOff) {
  for (const glm::dvec3& k : {glm::dvec3(1, 0, 0), {0, 0, 1}, {0.5, 0.25, 0.125}, {0, 2, 0}}) {
    const Light lamp{.kind = LightKind::point,
                     .intensity = 3,
                     .colour = {1, 0.5, 2},
                     .position = {1, 1, 2},
                     .constant = k.x,
                     .linear = k.y,
                     .quadratic = k.z};
    expect_lit_by(
        lamp, [&](const glm::dvec3& p) { return glm::normalize(lamp.position - p); },
        [&](const glm::dvec3& p) {
          const double d = glm::distance(lamp.position, p);
          return 3 / (k.x + k.y * d + k.z * d * d);
        });
  }
}

/// A spot light above a point, tilted by `angle_deg` away from it; the share of light it gets.
double share_of_spot(double angle_deg) {
  Studio studio;
  const double angle = glm::radians(angle_deg);
  studio.scene.lights = {{.kind = LightKind::spot,
                          .direction = 3.0 * glm::dvec3(std::sin(angle), 0, -std::cos(angle)),
                          .position = {0, 0, 2},
                          .inner_deg = 20,
                          .outer_deg = 40}};
  return studio.light({{{0, 0, 0}, {0, 0, 1}}})[0].diffuse.r / kd;
}

TEST(Lighting, SpotIsFullInsideDarkOutsideSmoothBetween) {
  for (const double angle_deg : {0.0, 10.0, 19.9}) EXPECT_NEAR(share_of_spot(angle_deg), 1, 1e-6);
  for (const double angle_deg : {40.1, 60.0, 90.0, 180.0}) EXPECT_EQ(share_of_spot(angle_deg), 0);
  // Smoothstep between the cosines of the two angles.
  const double inner = std::cos(glm::radians(20.0)), outer = std::cos(glm::radians(40.0));
  double previous = 1;
  for (double angle_deg = 20.5; angle_deg < 40; angle_deg += 0.5) {
    const double t = (std::cos(glm::radians(angle_deg)) - outer) / (inner - outer);
    EXPECT_NEAR(share_of_spot(angle_deg), t * t * (3 - 2 * t), 1e-5) << angle_deg;
    EXPECT_LT(share_of_spot(angle_deg), previous);
    previous = share_of_spot(angle_deg);
  }
}

TEST(Lighting, SpotFallsOffAsAPointLightDoes) {
  Light spot{.kind = LightKind::spot,
             .intensity = 5,
             .direction = {0, 0, -1},
             .position = {0.2, 0, 4},
             .constant = 0,
             .quadratic = 1,
             .inner_deg = 80,
             .outer_deg = 90};
  expect_lit_by(
      spot, [&](const glm::dvec3& p) { return glm::normalize(spot.position - p); },
      [&](const glm::dvec3& p) { return 5 / std::pow(glm::distance(spot.position, p), 2); });
}

TEST(Lighting, SeveralLightsAdd) {
  const std::vector<Light> lights = {
      {.direction = {0, 0, 1}},
      {.kind = LightKind::point, .intensity = 2, .colour = {1, 0, 0}, .position = {1, 0, 3}},
      {.kind = LightKind::spot,
       .colour = {0, 0, 1},
       .direction = {0, 0, -1},
       .position = {0, 0, 3}},
      {.intensity = 0, .direction = {1, 0, 1}}};
  Studio all;
  all.scene.lights = lights;
  std::vector<Lit> sum(points.size());
  for (const Light& light : lights) {
    Studio one;
    one.scene.lights = {light};
    const auto lit = one.light(points);
    for (std::size_t i = 0; i < points.size(); ++i)
      sum[i].diffuse += lit[i].diffuse, sum[i].glossy += lit[i].glossy;
  }
  const auto lit = all.light(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    expect_near(lit[i].diffuse, sum[i].diffuse, 1e-6);
    expect_near(lit[i].glossy, sum[i].glossy, 1e-6);
  }
  for (const Lit& dark : Studio().light(points))
    EXPECT_EQ(dark.diffuse + dark.glossy, glm::dvec3(0)) << "no light";
}

// -------------------------------------------------------------------------------- degenerate input

TEST(Lighting, LightAndEyeOnTheSurfaceAndNormalsOfNoLengthAreFinite) {
  for (const LightKind kind : {LightKind::point, LightKind::spot})
    for (const double constant : {1.0, 0.0}) {
      Studio studio;
      studio.camera.eye = {1, 1, 1};
      studio.scene.lights = {
          {.kind = kind, .position = {0, 0, 0}, .constant = constant, .quadratic = 1}};
      const auto lit = studio.light({{{0, 0, 0}, {0, 0, 1}},
                                     {{1, 1, 1}, {0, 0, 1}},
                                     {{0.5, 0, 0}, {0, 0, 0}},
                                     {{0, 0, 0}, {0, 0, 0}},
                                     {{1e-30, 0, 0}, {1e-25, 0, 0}},
                                     {{1e18, 0, 0}, {1e18, 0, 0}}});
      for (const Lit& at : lit)
        for (const glm::dvec3& part : {at.diffuse, at.glossy})
          for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(part[c]) && part[c] >= 0);
    }
}

TEST(Lighting, ANormalOfNoLengthFacesTheViewer) {
  Studio studio;
  studio.scene.lights = {{.direction = {0, 0, 1}}};
  studio.camera.eye = {0, 3, 4};
  EXPECT_NEAR(studio.light({{{0, 0, 0}, {0, 0, 0}}})[0].diffuse.r, kd * 0.8, 1e-6);
}

}  // namespace
}  // namespace scanlit
