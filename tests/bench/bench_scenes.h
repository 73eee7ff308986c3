// The scenes of the comparison with another renderer, defined to the last number, so that two
// renderers draw the same picture and anybody's figures can be set beside anybody else's.
//
//   S0         nothing: clearing the picture
//   S1         sphere of 2,000 triangles                    Gouraud
//   S2         the same                                     Phong
//   S3         the same                                     Cook-Torrance per fragment
//   S4         sphere of 1,000,000 triangles                Phong
//   S5F  S5B   64 spheres of 2,000 triangles, each hiding   Phong
//              the next: front to back and back to front
//   S5M        the same in one mesh, back to front          Phong
//   S6         sphere of 2,000 triangles                    Phong, 16 point lights
//   S7         sphere of 10,000,000 triangles               Gouraud
//   S8G  S8P   torus of 100,000 triangles                   Gouraud and Phong
//   S9         1,000 teapots in a room (bench_room.h)       Phong
//   S10L       S9, in which only the light turns            Phong; what stands from the last
//   S10M       S9, in which only one teapot turns           frame may be reused, in these three
//   S10N       S9, in which nothing moves                   alone
//
// 1920x1080 pixels with centres at half-integers, 8 bits each of linear RGBA, values clamped to
// [0, 1] and rounded to nearest, alpha 1 where covered, all 0 elsewhere. Back faces are culled.
// From frame to frame what moves turns by .01 rad about the vertical axis: the object in S1 to S8;
// in S9 the teapots and the camera; in S10L the light. With n = normalize of the interpolated
// normal, v towards the eye, h = normalize(l + v) and the light l = normalize(1,1,1):
//
//   Phong           .05 b + b max(n.l, 0) + .3 max(n.h, 0)^32 [n.l > 0],  b = (.7, .3, .2)
//   Gouraud         the same at the vertices, clamped to [0, 1] there
//   Cook-Torrance   (n.l) (kd / pi + F D G / (4 (n.l)(n.v))) [n.l > 0]: D of Beckmann, m = .3; G of
//                   V-cavities; F exact, of a conductor; kd = (.3, .2, .05), eta = (.143, .375,
//                   1.442), k = (3.983, 2.386, 1.603)
//   point lights    .05 b, and for each light its colour / d^2 times the rest of Phong
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "rasterizer/mesh.h"

namespace scanlit::bench {

constexpr int picture_width = 1920, picture_height = 1080;
constexpr double fov_deg = 45, near_distance = 1, far_distance = 100;

enum class Shader { gouraud, phong, cook_torrance, point_lights };

/// One draw: a mesh scaled, turned about the vertical axis, and moved.
struct Placement {
  std::shared_ptr<const Mesh> mesh;
  glm::dvec3 scale{1}, centre{0};
  double angle = 0;  // rad, in frame 0
  bool turns = true;
  glm::dvec3 base{.7, .3, .2};  // b
};

struct BenchScene {
  std::string name;
  Shader shader = Shader::phong;
  std::vector<Placement> placements;  // one draw each, in this order
  glm::dvec3 eye{0, 0, 4.15};         // looks along -z in frame 0, +y up
  bool camera_turns = false, light_turns = false;
  // S5M turns about the eye, so that its spheres go on hiding each other; to and fro, so that they
  // stay in the picture.
  bool to_and_fro = false;
  bool reuse = false;  // S10
};

const std::vector<std::string>& scene_names();

/// `name` is one of scene_names().
BenchScene make_bench_scene(const std::string& name);

// In frame 0, 1, 2, ...
glm::mat4 world_from_object(const BenchScene& scene, const Placement& placement, int frame);
glm::dvec3 viewing_direction(const BenchScene& scene, int frame);  // unit
glm::dvec3 to_light(const BenchScene& scene, int frame);           // unit; no point lights

struct PointLight {
  glm::dvec3 position, colour;
};
/// `count` lights on a circle of radius 3 at z = 2; their colours go once round the hues.
std::vector<PointLight> point_lights(int count = 16);

}  // namespace scanlit::bench
