#include "bench_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/ext/matrix_transform.hpp>
#include <numbers>

namespace scanlit::bench {

namespace {

using std::numbers::pi;

/// Unit sphere about the origin; seam and poles repeat their vertices. 2 slices (stacks - 1)
/// triangles.
Mesh sphere(int stacks, int slices) {
  Mesh mesh;
  mesh.closed = true;
  for (int i = 0; i <= stacks; ++i)
    for (int j = 0; j <= slices; ++j) {
      const double theta = pi * i / stacks, phi = 2 * pi * j / slices;
      mesh.positions.emplace_back(std::sin(theta) * std::sin(phi), std::cos(theta),
                                  std::sin(theta) * std::cos(phi));
    }
  mesh.normals = mesh.positions;
  for (int i = 0; i < stacks; ++i)
    for (int j = 0; j < slices; ++j) {
      const auto a = std::uint32_t(i * (slices + 1) + j), b = a + std::uint32_t(slices) + 1;
      if (i != stacks - 1) mesh.indices.insert(mesh.indices.end(), {a, b, b + 1});
      if (i != 0) mesh.indices.insert(mesh.indices.end(), {a, b + 1, a + 1});
    }
  return mesh;
}

/// Major radius .7, minor .3, its axis z turned about x by -40 degrees. 2 around tube triangles.
Mesh torus(int around, int tube) {
  Mesh mesh;
  mesh.closed = true;
  const double tilt = -40 * pi / 180;
  const auto tilted = [&](double x, double y, double z) {
    return glm::vec3(x, y * std::cos(tilt) - z * std::sin(tilt),
                     y * std::sin(tilt) + z * std::cos(tilt));
  };
  for (int j = 0; j <= tube; ++j)
    for (int i = 0; i <= around; ++i) {
      const double u = 2 * pi * i / around, v = 2 * pi * j / tube, radius = .7 + .3 * std::cos(v);
      mesh.positions.push_back(
          tilted(radius * std::cos(u), radius * std::sin(u), .3 * std::sin(v)));
      mesh.normals.push_back(
          tilted(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)));
    }
  for (int j = 0; j < tube; ++j)
    for (int i = 0; i < around; ++i) {
      const auto a = std::uint32_t(j * (around + 1) + i), d = a + std::uint32_t(around) + 1;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, d + 1, a, d + 1, d});
    }
  return mesh;
}

/// 64 spheres that grow with their distance from an eye at the origin: equal silhouettes, .95 of
/// the picture's height, and surfaces that do not meet.
std::vector<Placement> nested_spheres() {
  std::vector<Placement> spheres;
  for (int i = 0; i < 64; ++i) {
    const double scale = 1 + .05 * i;
    spheres.push_back({scale, {0, 0, -2.73 * scale}});
  }
  return spheres;
}

Mesh merged(const Mesh& mesh, const std::vector<Placement>& placements) {
  Mesh all;
  all.closed = true;
  for (const Placement& placement : placements) {
    const auto first = std::uint32_t(all.positions.size());
    for (const glm::vec3& position : mesh.positions)
      all.positions.emplace_back(glm::dvec3(position) * placement.scale + placement.centre);
    all.normals.insert(all.normals.end(), mesh.normals.begin(), mesh.normals.end());
    for (const std::uint32_t index : mesh.indices) all.indices.push_back(first + index);
  }
  return all;
}

BenchScene nested(BenchScene scene) {
  Mesh mesh = sphere(26, 40);
  scene.eye = {0, 0, 0};
  scene.placements = nested_spheres();
  if (scene.name != "S5F") std::ranges::reverse(scene.placements);
  if (scene.name == "S5M") {
    mesh = merged(mesh, scene.placements);
    scene.placements = {Placement{}};
    scene.to_and_fro = true;
  }
  scene.mesh = std::make_shared<Mesh>(std::move(mesh));
  return scene;
}

}  // namespace

const std::vector<std::string>& scene_names() {
  static const std::vector<std::string> names = {"S0",  "S1",  "S2", "S3", "S4",  "S5F",
                                                 "S5B", "S5M", "S6", "S7", "S8G", "S8P"};
  return names;
}

BenchScene make_bench_scene(const std::string& name) {
  BenchScene scene{.name = name, .mesh = {}, .placements = {Placement{}}};
  if (name.starts_with("S5")) return nested(scene);

  if (name == "S1" || name == "S7" || name == "S8G") scene.shader = Shader::gouraud;
  if (name == "S3") scene.shader = Shader::cook_torrance;
  if (name == "S6") scene.shader = Shader::point_lights;
  if (name == "S0") scene.placements.clear();
  scene.mesh = std::make_shared<Mesh>(name == "S4"             ? sphere(501, 1000)
                                      : name == "S7"           ? sphere(2001, 2500)
                                      : name.starts_with("S8") ? torus(500, 100)
                                                               : sphere(26, 40));
  return scene;
}

glm::mat4 world_from_object(const BenchScene& scene, const Placement& placement, int frame) {
  // 0, 1, ... 5, 4, ... -5, -4, ... in steps of one
  const int swing = std::abs((frame + 15) % 20 - 10) - 5;
  const double angle = .01 * (scene.to_and_fro ? swing : frame);
  glm::dmat4 m = glm::translate(glm::dmat4(1), placement.centre);
  m = glm::scale(m, glm::dvec3(placement.scale));
  return glm::mat4(glm::rotate(m, angle, glm::dvec3(0, 1, 0)));
}

std::vector<PointLight> point_lights() {
  std::vector<PointLight> lights;
  for (int k = 0; k < 16; ++k) {
    const double t = 2 * pi * k / 16;
    PointLight& light = lights.emplace_back();
    light.position = {3 * std::cos(t), 3 * std::sin(t), 2};
    for (int c = 0; c < 3; ++c) light.colour[c] = 1 + std::cos(t - 2 * pi * c / 3);
  }
  return lights;
}

}  // namespace scanlit::bench
