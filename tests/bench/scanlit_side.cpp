#include "scanlit_side.h"

#include <algorithm>
#include <cstdio>
#include <numbers>

#include "models/registry.h"

namespace scanlit::bench {

namespace {

Material material(Shader shader, const glm::dvec3& base) {
  if (shader == Shader::cook_torrance) {
    const char* specification =
        "cook-torrance:D=beckmann,m=.3,G=vcavity,F=conductor,"
        "eta=.143/.375/1.442,k=3.983/2.386/1.603,kd=.3/.2/.05,ks=1";
    return {.model = models::make(specification).model, .ka = Rgb<double>(0.0)};
  }
  char specification[100];
  std::snprintf(specification, sizeof specification, "blinn-phong:kd=%g/%g/%g,ks=.3,n=32", base.x,
                base.y, base.z);
  return {.model = models::make(specification).model,
          .ka = {.05 * base.x, .05 * base.y, .05 * base.z}};
}

std::vector<Light> lights(const BenchScene& scene) {
  if (scene.shader != Shader::point_lights)
    // Models return pi f_r (n.l), and Cook-Torrance's scene is defined by irradiance 1.
    return {{.intensity = scene.shader == Shader::cook_torrance ? 1 / std::numbers::pi : 1,
             .direction = to_light(scene, 0)}};
  return scanlit_lights(16);
}

}  // namespace

ScanlitSide::ScanlitSide(int threads) {
  settings_.threads = threads;
  settings_.clamp_vertex_colours = true;
}

std::vector<Light> scanlit_lights(int count) {
  std::vector<Light> all;
  for (const PointLight& light : point_lights(count))
    all.push_back({.kind = LightKind::point,
                   .colour = {light.colour.x, light.colour.y, light.colour.z},
                   .position = light.position,
                   .constant = 0,
                   .quadratic = 1});
  return all;
}

Scene scanlit_scene(const BenchScene& scene) {
  Scene result;
  result.lights = lights(scene);
  // Objects of one colour share their material, as a program's would.
  const Material* shared = nullptr;
  const glm::dvec3* colour = nullptr;
  result.objects.reserve(scene.placements.size());
  for (const Placement& placement : scene.placements) {
    const bool same = shared && *colour == placement.base;
    result.objects.push_back(
        {.mesh = placement.mesh,
         .world_from_object = world_from_object(scene, placement, 0),
         .material = same ? *shared : material(scene.shader, placement.base),
         .shading = scene.shader == Shader::gouraud ? Shading::gouraud : Shading::phong,
         .sides = Sides::front,
         .name = {}});
    shared = &result.objects.back().material;
    colour = &placement.base;
  }
  return result;
}

Camera scanlit_camera(const BenchScene& scene) {
  return {.eye = scene.eye,
          .target = scene.eye + viewing_direction(scene, 0),
          .fov_deg = fov_deg,
          .near = near_distance,
          .far = far_distance};
}

void pose(const BenchScene& scene, int frame, Scene& posed, Camera& camera) {
  for (std::size_t i = 0; i < scene.placements.size(); ++i)
    posed.objects[i].world_from_object = world_from_object(scene, scene.placements[i], frame);
  if (scene.light_turns) posed.lights[0].direction = to_light(scene, frame);
  camera.target = scene.eye + viewing_direction(scene, frame);
}

void ScanlitSide::prepare(const BenchScene& scene, bool reuse) {
  scene_ = scanlit_scene(scene);
  camera_ = scanlit_camera(scene);
  settings_.reuse = reuse;
  renderer_ = Renderer();
}

void ScanlitSide::draw(const BenchScene& scene, int frame) {
  pose(scene, frame, scene_, camera_);
  stats_ = renderer_.render(scene_, camera_, settings_, framebuffer_);
}

}  // namespace scanlit::bench
