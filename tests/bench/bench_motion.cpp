// What a bench scene looks like in each of its frames.
#include <cmath>
#include <cstdlib>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "bench_scenes.h"

namespace scanlit::bench {

namespace {

/// rad. To and fro: 0, 1, ... 5, 4, ... -5, -4, ... steps.
double turned(bool turns, bool to_and_fro, int frame) {
  const int swing = std::abs((frame + 15) % 20 - 10) - 5;
  return turns ? .01 * (to_and_fro ? swing : frame) : 0;
}

glm::dvec3 turned(const glm::dvec3& direction, double angle) {
  return glm::dmat3(glm::rotate(glm::dmat4(1), angle, glm::dvec3(0, 1, 0))) * direction;
}

}  // namespace

glm::mat4 world_from_object(const BenchScene& scene, const Placement& placement, int frame) {
  const double angle = placement.angle + turned(placement.turns, scene.to_and_fro, frame);
  glm::dmat4 m = glm::translate(glm::dmat4(1), placement.centre);
  m = glm::rotate(m, angle, glm::dvec3(0, 1, 0));
  return glm::mat4(glm::scale(m, placement.scale));
}

glm::dvec3 viewing_direction(const BenchScene& scene, int frame) {
  return turned({0, 0, -1}, turned(scene.camera_turns, scene.to_and_fro, frame));
}

glm::dvec3 to_light(const BenchScene& scene, int frame) {
  return turned(glm::normalize(glm::dvec3(1)), turned(scene.light_turns, scene.to_and_fro, frame));
}

std::vector<PointLight> point_lights(int count) {
  constexpr double pi = std::numbers::pi;
  std::vector<PointLight> lights;
  for (int k = 0; k < count; ++k) {
    const double t = 2 * pi * k / count;
    PointLight& light = lights.emplace_back();
    light.position = {3 * std::cos(t), 3 * std::sin(t), 2};
    for (int c = 0; c < 3; ++c) light.colour[c] = 1 + std::cos(t - 2 * pi * c / 3);
  }
  return lights;
}

}  // namespace scanlit::bench
