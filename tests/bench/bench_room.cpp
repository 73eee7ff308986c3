#include "bench_room.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <random>

#include "bench_shapes.h"
#include "rasterizer/shapes.h"

namespace scanlit::bench {

namespace {

constexpr double half_room = 40, height = 8, thickness = .5;
constexpr double teapot_gap = .1;  // between a teapot and what is next to it

std::vector<Placement> boxes() {
  const auto cube = std::make_shared<Mesh>(unit_cube());
  std::vector<Placement> all;
  const auto add = [&](const glm::dvec3& centre, const glm::dvec3& size, const glm::dvec3& base) {
    all.push_back({.mesh = cube, .scale = size, .centre = centre, .turns = false, .base = base});
  };
  // A wall that the z axis (or else the x axis) meets at `distance`.
  const auto wall = [&](bool meets_z, double distance, double begin, double end) {
    const double middle = (begin + end) / 2, length = end - begin;
    if (meets_z)
      add({middle, height / 2, distance}, {length, height, thickness}, {.6, .6, .45});
    else
      add({distance, height / 2, middle}, {thickness, height, length}, {.45, .6, .6});
  };
  const double width = 2 * half_room;
  for (const double y : {-thickness / 2, height + thickness / 2})
    add({0, y, 0}, {width, thickness, width}, {.3, .35, .4});
  for (const bool meets_z : {false, true})
    for (const double side : {-1.0, 1.0}) {
      wall(meets_z, side * (half_room + thickness / 2), -half_room, half_room);
      wall(meets_z, side * 12, -30, -3);
      wall(meets_z, side * 12, 3, 30);
    }
  for (int i = -4; i < 4; ++i)
    for (int j = -4; j < 4; ++j)
      add({10 * i + 5, height / 2, 10 * j + 5}, {1, height, 1}, {.8, .75, .6});
  return all;
}

/// Seen from above.
bool touches(const Placement& box, const glm::dvec2& centre, double radius) {
  const glm::dvec2 half(box.scale.x / 2, box.scale.z / 2), middle(box.centre.x, box.centre.z);
  const glm::dvec2 outside = glm::max(glm::abs(centre - middle) - half, glm::dvec2(0));
  const bool stands_on_floor = box.centre.y > 0 && box.centre.y < height;
  return stands_on_floor && glm::length(outside) < radius + teapot_gap;
}

std::vector<Placement> teapots(const std::vector<Placement>& obstacles) {
  const auto mesh = std::make_shared<Mesh>(make_shape("teapot:8"));
  double base = 0;  // of the shape, below its centre
  for (const glm::vec3& position : mesh->positions) base = std::max(base, -double(position.y));

  std::mt19937 random(9);
  const auto between = [&](double least, double largest) {  // the same with every library
    return least + (largest - least) * (double(random()) / 4294967296.0);
  };
  const auto place = [&](double x, double z, double size, double angle) {
    return Placement{.mesh = mesh,
                     .scale = glm::dvec3(size),
                     .centre = {x, base * size + .02, z},
                     .angle = angle};
  };
  std::vector<Placement> all = {place(0, -5, 1, 0)};
  while (int(all.size()) < teapot_count) {
    const double x = between(-half_room, half_room), z = between(-half_room, half_room);
    const double size = between(.5, 1), angle = between(0, 2 * std::numbers::pi);
    const bool near_camera = std::hypot(x, z) < 3;
    const auto other = [&](const Placement& teapot) {
      return std::hypot(x - teapot.centre.x, z - teapot.centre.z) <
             size + teapot.scale.x + teapot_gap;
    };
    const auto box = [&](const Placement& b) { return touches(b, {x, z}, size); };
    const bool beyond = std::max(std::abs(x), std::abs(z)) + size + teapot_gap > half_room;
    if (!near_camera && !beyond && std::ranges::none_of(obstacles, box) &&
        std::ranges::none_of(all, other))
      all.push_back(place(x, z, size, angle));
  }
  return all;
}

}  // namespace

BenchScene teapots_in_a_room(const std::string& name) {
  BenchScene scene{.name = name, .placements = boxes(), .eye = {0, 2, 0}};
  const std::vector<Placement> all = teapots(scene.placements);
  const std::size_t first = scene.placements.size();
  scene.placements.insert(scene.placements.end(), all.begin(), all.end());
  scene.camera_turns = name == "S9";
  scene.light_turns = name == "S10L";
  scene.reuse = name != "S9";
  for (std::size_t i = first; i < scene.placements.size(); ++i)
    scene.placements[i].turns = name == "S9" || (name == "S10M" && i == first);
  return scene;
}

}  // namespace scanlit::bench
