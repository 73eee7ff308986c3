#include "bench_scenes.h"

#include <algorithm>

#include "bench_room.h"
#include "bench_shapes.h"

namespace scanlit::bench {

namespace {

/// 64 spheres that grow with their distance from an eye at the origin: equal silhouettes, .95 of
/// the picture's height, and surfaces that do not meet.
std::vector<Placement> nested_spheres() {
  const auto mesh = std::make_shared<Mesh>(sphere(26, 40));
  std::vector<Placement> spheres;
  for (int i = 0; i < 64; ++i) {
    const double scale = 1 + .05 * i;
    spheres.push_back({.mesh = mesh, .scale = glm::dvec3(scale), .centre = {0, 0, -2.73 * scale}});
  }
  return spheres;
}

Mesh merged(const std::vector<Placement>& placements) {
  Mesh all;
  all.closed = true;
  for (const Placement& placement : placements) {
    const Mesh& mesh = *placement.mesh;
    const auto first = std::uint32_t(all.positions.size());
    for (const glm::vec3& position : mesh.positions)
      all.positions.emplace_back(glm::dvec3(position) * placement.scale + placement.centre);
    all.normals.insert(all.normals.end(), mesh.normals.begin(), mesh.normals.end());
    for (const std::uint32_t index : mesh.indices) all.indices.push_back(first + index);
  }
  return all;
}

BenchScene nested(const std::string& name) {
  BenchScene scene{.name = name, .placements = nested_spheres(), .eye = {0, 0, 0}};
  if (name != "S5F") std::ranges::reverse(scene.placements);
  if (name == "S5M") {
    scene.placements = {{.mesh = std::make_shared<Mesh>(merged(scene.placements))}};
    scene.to_and_fro = true;
  }
  return scene;
}

}  // namespace

const std::vector<std::string>& scene_names() {
  static const std::vector<std::string> names = {"S0",  "S1",   "S2",   "S3",  "S4",  "S5F",
                                                 "S5B", "S5M",  "S6",   "S7",  "S8G", "S8P",
                                                 "S9",  "S10L", "S10M", "S10N"};
  return names;
}

BenchScene make_bench_scene(const std::string& name) {
  if (name.starts_with("S5")) return nested(name);
  if (name == "S9" || name.starts_with("S10")) return teapots_in_a_room(name);

  BenchScene scene{.name = name, .placements = {}};
  if (name == "S0") return scene;
  if (name == "S1" || name == "S7" || name == "S8G") scene.shader = Shader::gouraud;
  if (name == "S3") scene.shader = Shader::cook_torrance;
  if (name == "S6") scene.shader = Shader::point_lights;
  scene.placements = {{.mesh = std::make_shared<Mesh>(name == "S4"             ? sphere(501, 1000)
                                                      : name == "S7"           ? sphere(2001, 2500)
                                                      : name.starts_with("S8") ? torus(500, 100)
                                                                               : sphere(26, 40))}};
  return scene;
}

}  // namespace scanlit::bench
