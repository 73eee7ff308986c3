// What the golden images show. Every case is small, and says what it would catch.
#include <glm/gtc/matrix_transform.hpp>
#include <memory>

#include "models/registry.h"
#include "rasterizer/render.h"
#include "rasterizer/shapes.h"
#include "tests/golden/golden.h"

namespace scanlit::golden {
namespace {

constexpr int width = 160, height = 120;

// A reference is exact to 1 part in 65,536 (its floats are shortened), and shading rounds
// differently with the vector width: up to 2e-5 of a highlight's peak. The eye sees 4e-3.
const Tolerance rounding{1e-4f, 1e-4f, 0, "shading rounds differently on each instruction set"};

Object object(const char* shape, const char* model, Shading shading = Shading::phong) {
  Object result;
  result.mesh = std::make_shared<Mesh>(make_shape(shape));
  result.material.model = models::make(model).model;
  result.shading = shading;
  result.name = shape;
  return result;
}

Object moved(Object result, const glm::vec3& by) {
  result.world_from_object = glm::translate(glm::mat4(1), by) * result.world_from_object;
  return result;
}

Light directional(const glm::dvec3& towards_light, double intensity = 0.8) {
  Light light;
  light.direction = towards_light;
  light.intensity = intensity;
  return light;
}

// Lit from above, on the viewer's left, with a weaker warm light from the right.
Scene scene(std::vector<Object> objects) {
  Scene result;
  result.objects = std::move(objects);
  result.lights = {directional({-1, 1.5, 2}), directional({2, 0.2, 1}, 0.3)};
  result.lights[1].colour = {1, 0.7, 0.4};
  return result;
}

struct Shot {
  Camera camera{.eye = {1.2, 1.4, 3}};
  bool automatic_framing = true;
  RenderSettings settings;
  Planes planes;
};

Framebuffer draw(const Scene& scene, const Shot& shot = {}) {
  Framebuffer framebuffer(width, height, shot.planes);
  const Camera camera = shot.automatic_framing
                            ? framed(shot.camera, bounding_sphere(scene), double(width) / height)
                            : shot.camera;
  render(scene, camera, shot.settings, framebuffer);
  return framebuffer;
}

constexpr const char* porcelain = "blinn-phong:kd=.15/.35/.6,ks=.4,n=50";

Framebuffer teapot(Shading shading, const Shot& shot = {}) {
  return draw(scene({object("teapot:6", porcelain, shading)}), shot);
}

Framebuffer sphere(const char* model) { return draw(scene({object("sphere:24", model)})); }

Framebuffer teapot_with_samples(int samples) {
  Shot shot;
  shot.settings.samples = samples;
  return teapot(Shading::phong, shot);
}

Framebuffer near_plane_cuts_torus() {
  Shot shot;
  shot.automatic_framing = false;
  shot.camera = {.eye = {0.5, 0.35, 1.1}, .fov_deg = 70, .near = 0.7};
  Object torus = object("torus", porcelain);
  torus.sides = Sides::both;
  return draw(scene({torus}), shot);
}

Framebuffer camera_inside_cube() {
  Shot shot;
  shot.automatic_framing = false;
  shot.camera = {.eye = {0.1, 0.2, 0.3}, .target = {-1, -0.5, -1}, .fov_deg = 100};
  Object cube = object("cube", "lambert:kd=.7/.5/.3");
  cube.sides = Sides::both;
  return draw(scene({cube}), shot);
}

// The far side is seen from behind, and shaded with its normal flipped.
Framebuffer open_cylinder_of_a_bowl() {
  Scene bowl = scene({object("teapot:6", porcelain)});
  bowl.objects[0].sides = Sides::both;
  Shot shot;
  shot.automatic_framing = false;
  shot.camera = {.eye = {0, 1.2, 1.0}, .near = 0.9};
  return draw(bowl, shot);
}

Framebuffer spot_and_point_lights() {
  Scene stage =
      scene({object("plane:1", "lambert:kd=.8"), moved(object("sphere:24", porcelain), {0, 0, 0})});
  Light spot;
  spot.kind = LightKind::spot;
  spot.position = {-1.5, 2.5, 1.5};
  spot.direction = -spot.position;
  spot.intensity = 1.2;
  spot.inner_deg = 12;
  spot.outer_deg = 18;
  Light point;
  point.kind = LightKind::point;
  point.position = {1.3, 0.8, 0.9};
  point.colour = {1, 0.5, 0.2};
  point.constant = 0;
  point.quadratic = 1;
  stage.lights = {spot, point};
  return draw(stage);
}

// A coloured light tints the highlight and not the body.
Framebuffer colour_form_2() {
  Scene plastic = scene({object("sphere:24", "blinn-phong:kd=.7,ks=.5,n=30")});
  plastic.objects[0].material.form = ColourForm::plastic;
  plastic.objects[0].material.object_colour = {0.8, 0.1, 0.1};
  plastic.lights[0].colour = {0.4, 1, 0.4};
  return draw(plastic);
}

Framebuffer screen_linear_plane() {
  Shot shot;
  shot.automatic_framing = false;
  shot.camera = {.eye = {0.2, 0.3, 1.2}, .fov_deg = 60};
  shot.settings.interpolation = Interpolation::screen_linear;
  Scene floor = scene({object("plane:1", "lambert:kd=.8", Shading::gouraud)});
  floor.lights[0].kind = LightKind::point;
  floor.lights[0].position = {-1, 0.5, 1};
  return draw(floor, shot);
}

// Also what lies behind one another, and the same material in different objects.
Framebuffer intersecting_objects() {
  Shot shot;
  shot.planes = {.depth = true, .normal = true, .ids = true, .parts = true};
  return draw(scene({object("torus:12", porcelain), object("cube", "lambert:kd=.7/.5/.3"),
                     moved(object("icosphere:3", porcelain, Shading::flat), {0.6, 0.4, 0.3})}),
              shot);
}

}  // namespace

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"teapot_flat", rounding, [] { return teapot(Shading::flat); }},
      {"teapot_gouraud", rounding, [] { return teapot(Shading::gouraud); }},
      {"teapot_phong", rounding, [] { return teapot(Shading::phong); }},
      {"sphere_lambert", rounding, [] { return sphere("lambert:kd=.15/.35/.6"); }},
      {"sphere_phong", rounding, [] { return sphere("phong:kd=.15/.35/.6,ks=.4,n=20"); }},
      {"sphere_blinn_phong", rounding, [] { return sphere(porcelain); }},
      {"samples_4", rounding, [] { return teapot_with_samples(4); }},
      {"samples_8", rounding, [] { return teapot_with_samples(8); }},
      {"samples_16", rounding, [] { return teapot_with_samples(16); }},
      {"near_plane_cuts_torus", rounding, near_plane_cuts_torus},
      {"camera_inside_cube", rounding, camera_inside_cube},
      {"open_cylinder", rounding, open_cylinder_of_a_bowl},
      {"spot_and_point_lights", rounding, spot_and_point_lights},
      {"colour_form_2", rounding, colour_form_2},
      {"orthographic", rounding,
       [] {
         Shot shot;
         shot.camera.projection = Projection::orthographic;
         return teapot(Shading::phong, shot);
       }},
      {"viewer_at_infinity", rounding,
       [] {
         Shot shot;
         shot.camera.viewer_at_infinity = true;
         return teapot(Shading::phong, shot);
       }},
      {"screen_linear_plane", rounding, screen_linear_plane},
      {"intersecting_objects", rounding, intersecting_objects},
  };
  return all;
}

}  // namespace scanlit::golden
