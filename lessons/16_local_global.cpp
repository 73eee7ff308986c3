// New idea: local reflection asks the lamps alone; in truth every surface is a lamp for all others.
// Builds on: lesson 13, shading. The models are those of the lessons that follow.
// Try: --bounces 0; --bounces 1; --paths 4: what does each bounce add, and what do few paths cost?
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/rays/rays.h"
#include "lessons/studio/reflect/sheet_layout.h"

using namespace scanlit;
using glm::dvec3, studio::Hit, studio::Random, studio::Ray, studio::Rays;

constexpr double lamp_radius = .12;

// new idea
/// The light that comes along a ray, against its direction: what the surface that it hits reflects
/// of the lamps' light, if nothing stands between, and of the light that comes from one other
/// direction, drawn at random. What comes from there? The same question again.
Rgb<double> light_along(const Ray& ray, const Rays& rays, const Scene& scene, int bounces,
                        Random& random) {
  const Hit hit = rays.first_hit(ray);
  if (!hit.object) return scene.background;
  const dvec3 V = -ray.direction, N = hit.normal;
  Rgb<double> light(0);
  for (const Light& lamp : scene.lights) {
    const dvec3 point = lamp.position + lamp_radius * studio::in_ball(random);
    if (!rays.free(hit.position, point)) continue;
    const dvec3 way = point - hit.position, L = glm::normalize(way);
    light = light + reflected(hit, L, V) * (lamp.intensity / glm::dot(way, way));
  }
  if (bounces == 0) return light;
  const dvec3 L = studio::diffuse_direction(N, random);  // with the density (N.L) / pi, so that
  return light + light_along({hit.position, L}, rays, scene, bounces - 1, random) *
                     (reflected(hit, L, V) * (1 / glm::dot(N, L)));  // f_r (N.L) is divided by it
}
// end of new idea

/// A room without ceiling and front, a lamp near its middle, a teapot and a ball.
Scene make_room() {
  const auto placed = [](const std::string& shape, const std::string& model, const dvec3& at,
                         const dvec3& scale, double angle = 0, const dvec3& axis = {0, 1, 0}) {
    Object object = studio::make_object(shape, model);
    object.material.ambient_share = .12;  // a guess of what comes from the other walls
    object.world_from_object = glm::mat4(glm::rotate(
        glm::scale(glm::translate(glm::dmat4(1), at), scale), glm::radians(angle), axis));
    return object;
  };
  const std::string white = "lambert:kd=.75", orange = "lambert:kd=.8/.28/.03";
  const std::string blue = "lambert:kd=.05/.25/.7", gold = "cook-torrance:F=gold,m=.6";
  const std::string glazed = "cook-torrance:F=dielectric,m=.4,kd=.7";
  Scene room = studio::make_stage({
      placed("plane:1", white, {0, -.9, 0}, {1.3, 1, 1}, -90, {1, 0, 0}),
      placed("plane:1", white, {0, .4, -1}, {1.3, 1.3, 1}),
      placed("plane:1", orange, {-1.3, .4, 0}, {1, 1.3, 1}, 90),
      placed("plane:1", blue, {1.3, .4, 0}, {1, 1.3, 1}, -90),
      placed("teapot:24", glazed, {-.35, -.52, -.1}, dvec3(.76), 25),
      placed("sphere:64", gold, {.82, -.53, .3}, dvec3(.37)),
  });
  Light lamp;
  lamp.kind = LightKind::point;
  lamp.position = {.1, .8, .35};
  lamp.intensity = 1.4;
  lamp.constant = 0, lamp.quadratic = 1;
  room.lights = {lamp};
  return room;
}

/// Orange where local reflection is too bright, blue where it is too dark.
Framebuffer signed_difference(const Framebuffer& local, const Framebuffer& global) {
  Framebuffer result = studio::blank_picture(local.width, local.height, {});
  for (std::size_t i = 0; i < local.colour.size(); i += 4) {
    double d = 0;
    for (std::size_t c = i; c < i + 3; ++c) d += local.colour[c] - global.colour[c];
    const Rgb<double> colour = (d > 0 ? studio::ink::orange : studio::ink::sky) * std::abs(d);
    result.colour[i] = float(colour.r), result.colour[i + 1] = float(colour.g);
    result.colour[i + 2] = float(colour.b);
  }
  return result;
}

double mean_light(const Framebuffer& picture) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.colour.size(); i += 4) sum += picture.colour[i + 1];
  return sum / double(picture.pixel_count());
}

int main(int argc, char** argv) {
  studio::Lesson lesson("Local reflection beside the light's whole way.", 1500, 398);
  int paths = 24, bounces = 3;
  lesson.knob("--paths", paths, {1, 10000}, "per pixel");
  lesson.knob("--bounces", bounces, {0, 100}, "how often light goes on from the first surface");

  return lesson.run(argc, argv, [&] {
    const Scene room = make_room();
    const Rays rays(room);
    std::vector<Framebuffer> pictures;
    const auto draw = [&](int panel, int width, int height) {
      const Camera camera{.eye = {0, .2, 4.6}, .target = {0, -.02, 0}, .fov_deg = 27};
      const auto along = [&](const Ray& ray, Random& random) {
        return light_along(ray, rays, room, bounces, random);
      };
      pictures.push_back(panel == 0   ? studio::photograph(room, camera, width, height)
                         : panel == 1 ? studio::trace(camera, width, height, paths, along)
                                      : signed_difference(pictures[0], pictures[1]));
      return pictures.back();
    };
    const Framebuffer sheet =
        studio::panels(lesson.width(), lesson.height(), 3,
                       {"local: lamps and Ka Ia", "global: paths of light", "local - global"}, draw,
                       studio::ink::slate, lesson.height() * 3 / 2);
    lesson.figure("mean light, local", studio::fixed(mean_light(pictures[0]), 2));
    lesson.figure("mean light, global", studio::fixed(mean_light(pictures[1]), 2));
    return sheet;
  });
}
