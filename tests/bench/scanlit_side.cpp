#include "scanlit_side.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <numbers>

#include "models/registry.h"
#include "rasterizer/batch.h"

namespace scanlit::bench {

namespace {

using Clock = std::chrono::steady_clock;

Material material(Shader shader) {
  if (shader == Shader::cook_torrance) {
    const char* specification =
        "cook-torrance:D=beckmann,m=.3,G=vcavity,F=conductor,"
        "eta=.143/.375/1.442,k=3.983/2.386/1.603,kd=.3/.2/.05,ks=1";
    return {.model = models::make(specification).model, .ka = Rgb<double>(0.0)};
  }
  return {.model = models::make("blinn-phong:kd=.7/.3/.2,ks=.3,n=32").model,
          .ka = {.05 * .7, .05 * .3, .05 * .2}};
}

std::vector<Light> lights(Shader shader) {
  // Models return pi f_r (n.l), and Cook-Torrance's scene is defined by irradiance 1.
  if (shader == Shader::cook_torrance)
    return {{.intensity = 1 / std::numbers::pi, .direction = {1, 1, 1}}};
  if (shader != Shader::point_lights) return {{.direction = {1, 1, 1}}};
  std::vector<Light> all;
  for (const PointLight& light : point_lights())
    all.push_back({.kind = LightKind::point,
                   .colour = {light.colour.x, light.colour.y, light.colour.z},
                   .position = light.position,
                   .constant = 0,
                   .quadratic = 1});
  return all;
}

}  // namespace

void to_rgba8(const Framebuffer& framebuffer, int threads, std::uint8_t* rgba) {
  // Powers of two, so that a piece is whole vectors but for the picture's last one.
  const std::size_t count = framebuffer.colour.size(), piece = 1 << 17;
  const auto lanes = std::size_t(Batch::lanes);
  const hn::Rebind<std::uint8_t, Batch::Tag> bytes;
  const auto convert = [&](const float* values) {
    return hn::DemoteTo(bytes, hn::NearestInt((Batch::load(values) * 255.0f).raw));  // saturates
  };
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_for(std::size_t(0), (count + piece - 1) / piece, [&](std::size_t k) {
      const float* const values = framebuffer.colour.data();
      const std::size_t end = std::min(count, (k + 1) * piece), whole = end / lanes * lanes;
      for (std::size_t i = k * piece; i < whole; i += lanes)
        hn::StoreU(convert(values + i), bytes, rgba + i);
      float rest[Batch::lanes] = {};
      std::uint8_t codes[Batch::lanes];
      std::copy(values + whole, values + end, rest);
      hn::StoreU(convert(rest), bytes, codes);
      std::copy_n(codes, end - whole, rgba + whole);
    });
  });
}

ScanlitSide::ScanlitSide(int threads) {
  settings_.threads = threads;
  settings_.clamp_vertex_colours = true;
}

void ScanlitSide::prepare(const BenchScene& scene) {
  scene_ = {};
  scene_.lights = lights(scene.shader);
  const Material shared = material(scene.shader);
  for (std::size_t i = 0; i < scene.placements.size(); ++i)
    scene_.objects.push_back(
        {.mesh = scene.mesh,
         .material = shared,
         .shading = scene.shader == Shader::gouraud ? Shading::gouraud : Shading::phong,
         .name = {}});
  camera_ = {.eye = scene.eye,
             .target = scene.eye - glm::dvec3(0, 0, 1),
             .fov_deg = fov_deg,
             .near = near_distance,
             .far = far_distance};
}

void ScanlitSide::draw(const BenchScene& scene, int frame) {
  for (std::size_t i = 0; i < scene.placements.size(); ++i)
    scene_.objects[i].world_from_object = world_from_object(scene, scene.placements[i], frame);
  stats_ = renderer_.render(scene_, camera_, settings_, framebuffer_);
  const auto start = Clock::now();
  to_rgba8(framebuffer_, settings_.threads, picture_.data());
  conversion_seconds_ = std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace scanlit::bench
