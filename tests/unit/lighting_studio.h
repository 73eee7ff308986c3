// A few points under lights, and the lecture's equation for them in double.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "models/registry.h"
#include "rasterizer/lighting.h"

namespace scanlit::test {

constexpr double kd = 0.5, ks = 0.25, n = 20;

struct Point {
  glm::dvec3 position, normal;  // object space = world space here
};

/// The three parts at one point, RGB.
struct Lit {
  glm::dvec3 ambient{0}, diffuse{0}, glossy{0};
};

/// A scene without a mesh: light() asks for points alone.
struct Studio {
  Scene scene;
  Camera camera{.eye = {1, 2, 5}};
  RenderSettings settings;

  Studio() {
    scene.objects.resize(1);
    material().model = models::make("blinn-phong:kd=.5,ks=.25,n=20").model;
  }
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  Material& material() { return scene.objects[0].material; }

  std::vector<Lit> light(const std::vector<Point>& points) const {
    const Frame frame{scene, camera, settings, {}, {}, {}, {}, {}, {}, {}, {}};
    Draw draw{};
    draw.object = &scene.objects[0];
    draw.normal_from_object = glm::mat3(1);
    draw.illumination = illuminate(frame, draw);
    SurfaceSpan surface;
    surface.size = int(points.size());
    for (int i = 0; i < surface.size; ++i)
      for (int c = 0; c < 3; ++c) {
        surface.position[c][i] = float(points[std::size_t(i)].position[c]);
        surface.normal[c][i] = float(points[std::size_t(i)].normal[c]);
      }
    LitSpan lit;
    FrameStats stats;
    scanlit::light(frame, draw, surface, lit, stats);
    std::vector<Lit> result(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        result[i].ambient[c] = double(lit.ambient[c][i]);
        result[i].diffuse[c] = double(lit.diffuse[c][i]);
        result[i].glossy[c] = double(lit.glossy[c][i]);
      }
    return result;
  }
};

inline const std::vector<Point> points = {
    {{0, 0, 0}, {0, 0, 1}},
    {{0.3, -0.2, 0.1}, glm::normalize(glm::dvec3(0.2, 0.1, 1))},
    {{-1, 0.5, 0}, glm::normalize(glm::dvec3(0.5, 0.5, 0.5))},
    {{0.5, 0.5, -1}, glm::normalize(glm::dvec3(-0.3, 0.4, 0.8))},
    {{2, 0, 1}, glm::normalize(glm::dvec3(0.9, 0, 0.1))}};

/// Kd (N.L) and Ks (N.H)^n, as the lecture writes them.
struct Braces {
  double diffuse, glossy;
};
inline Braces braces(const glm::dvec3& normal, const glm::dvec3& l, const glm::dvec3& v) {
  const double n_l = glm::dot(normal, l);
  if (n_l <= 0) return {0, 0};
  return {kd * n_l, ks * std::pow(std::max(glm::dot(normal, glm::normalize(l + v)), 0.0), n)};
}

inline void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance);
}

}  // namespace scanlit::test
