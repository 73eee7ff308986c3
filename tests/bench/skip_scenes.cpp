#include "skip_scenes.h"

#include <map>

#include "scanlit_side.h"

namespace scanlit::bench {

namespace {

/// Where a scene of this benchmark's own starts from.
const std::map<std::string, std::string>& sources() {
  static const std::map<std::string, std::string> names = {
      {"spots", "S9"}, {"far", "S6"}, {"ambient", "S4"}, {"inside", "S4"}, {"msaa4", "S8P"}};
  return names;
}

std::vector<Light> spot_lights() {
  std::vector<Light> lights;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      lights.push_back({.kind = LightKind::spot,
                        .intensity = 60,
                        .direction = {0, -1, 0},
                        .position = {12 * i - 18, 7.5, 12 * j - 18},
                        .constant = 0,
                        .quadratic = 1,
                        .outer_deg = 40});
  return lights;
}

}  // namespace

const std::vector<std::string>& skip_scene_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all(scene_names().begin() + 1, scene_names().end());  // not S0
    all.insert(all.end(), {"spots", "far", "ambient", "inside", "msaa4"});
    return all;
  }();
  return names;
}

SkipScene make_skip_scene(const std::string& name, int threads) {
  const auto source = sources().find(name);
  SkipScene result;
  result.bench = make_bench_scene(source == sources().end() ? name : source->second);
  result.bench.name = name;
  if (name == "inside") result.bench.eye = {0, 0, .5};
  result.scene = scanlit_scene(result.bench);
  result.camera = scanlit_camera(result.bench);
  result.settings = {.threads = threads, .clamp_vertex_colours = true, .reuse = result.bench.reuse};

  if (name == "spots") result.scene.lights = spot_lights();
  if (name == "far") {
    result.camera.projection = Projection::orthographic;
    for (Light& light : result.scene.lights)
      light = {.intensity = 1 / 16.0, .colour = light.colour, .direction = light.position};
  }
  if (name == "ambient") result.scene.lights.clear();
  if (name == "inside") {
    result.scene.objects[0].sides = Sides::both;
    result.camera.near = .1;
  }
  if (name == "msaa4") result.settings.samples = 4;
  return result;
}

}  // namespace scanlit::bench
