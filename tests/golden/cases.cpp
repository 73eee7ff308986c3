// What the golden images show. Every case is small, and says what it would catch. One picture of
// each reflection model besides: model_cases.cpp.
#include <cstdlib>
#include <sstream>

#include "lessons/studio/watch/example.h"
#include "lessons/studio/watch/scan_picture.h"
#include "rasterizer/error.h"
#include "rasterizer/image.h"
#include "tests/golden/scenes.h"

namespace scanlit::golden {
namespace {

constexpr const char* porcelain = "blinn-phong:kd=.15/.35/.6,ks=.4,n=50";

Framebuffer teapot(Shading shading, Shot shot = {}) {
  shot.framing = 1.4;
  return draw(scene({object("teapot:6", porcelain, shading)}), shot);
}

// What the vertices and edges decide, which is the same to the bit on every processor.
constexpr Planes exact{.depth = true, .ids = true};

Framebuffer teapot_with_samples(int samples) {
  Shot shot;
  shot.settings.samples = samples;
  shot.planes = exact;
  return teapot(Shading::phong, shot);
}

Framebuffer orthographic_teapot() {
  Shot shot;
  shot.camera.projection = Projection::orthographic;
  return teapot(Shading::phong, shot);
}

Framebuffer teapot_for_a_viewer_at_infinity() {
  Shot shot;
  shot.camera.viewer_at_infinity = true;
  return teapot(Shading::phong, shot);
}

// The near plane opens the torus: its inside is seen, shaded with flipped normals.
Framebuffer near_plane_cuts_torus() {
  Shot shot;
  shot.framing = 0;
  shot.planes = exact;
  shot.camera = {.eye = {0.5, 0.35, 1.3}, .fov_deg = 70, .near = 1.3};
  Object torus = object("torus", porcelain);
  torus.sides = Sides::both;
  return draw(scene({torus}), shot);
}

// Triangles reach behind the eye on all sides.
Framebuffer camera_inside_cube() {
  Shot shot;
  shot.framing = 0;
  shot.planes = exact;
  shot.camera = {.eye = {0.1, 0.2, 0.3}, .target = {-1, -0.5, -1}, .fov_deg = 100};
  Object cube = object("cube", "lambert:kd=.7/.5/.3");
  cube.sides = Sides::both;
  return draw(scene({cube}), shot);
}

// Lit on the side that its normals do not point to, and beside it one that is not drawn there.
Framebuffer planes_from_behind() {
  Scene planes = scene({placed(object("plane:4", porcelain), {-0.6, 0, 0}, 0.5f),
                        placed(object("plane:4", porcelain), {0.6, 0, 0}, 0.5f)});
  planes.objects[1].sides = Sides::front;
  planes.lights = {directional({0.2, -0.6, -3})};
  Shot shot;
  shot.camera.eye = {-0.6, 1, -3};
  shot.framing = 1.6;
  return draw(planes, shot);
}

Framebuffer spot_and_point_lights() {
  Scene stage = scene({object("plane:1", "lambert:kd=.8"),
                       placed(object("sphere:24", porcelain), {0, 0, 0.4}, 0.4f)});
  Light spot;
  spot.kind = LightKind::spot;
  spot.position = {-1.2, -0.8, 2};
  spot.direction = -spot.position;
  spot.inner_deg = 12;
  spot.outer_deg = 18;
  Light point;
  point.kind = LightKind::point;
  point.position = {0.8, 0.5, 0.5};
  point.colour = {1, 0.5, 0.2};
  point.intensity = 0.2;
  point.constant = 0;
  point.quadratic = 1;
  stage.lights = {spot, point};
  Shot shot;
  shot.camera.eye = {0.6, -2, 2};
  shot.camera.up = {0, 0, 1};
  shot.framing = 1.3;
  return draw(stage, shot);
}

// A coloured light tints the highlight and not the body.
Framebuffer colour_form_2() {
  Scene plastic = scene({object("sphere:24", "blinn-phong:kd=.7,ks=.5,n=30")});
  plastic.objects[0].material.form = ColourForm::plastic;
  plastic.objects[0].material.object_colour = {0.8, 0.1, 0.1};
  plastic.lights[0].colour = {0.4, 1, 0.4};
  return draw(plastic);
}

// One bright corner of two large triangles: screen-linear, the brightness bends at their diagonal.
Framebuffer foreshortened_plane(Interpolation interpolation) {
  Shot shot;
  shot.framing = 0;
  shot.planes = exact;
  shot.camera = {.eye = {0.3, -1.4, 0.5}, .target = {0, -0.3, 0}, .up = {0, 0, 1}, .fov_deg = 60};
  shot.settings.interpolation = interpolation;
  Scene floor = scene({object("plane:1", "lambert:kd=.8", Shading::gouraud)});
  floor.lights[0].kind = LightKind::point;
  floor.lights[0].position = {-1, -1, 0.5};
  floor.lights[0].constant = 0;
  floor.lights[0].quadratic = 4;
  return draw(floor, shot);
}

// Also two objects that share a model, and one that is shaded per face.
Framebuffer intersecting_objects() {
  Shot shot;
  shot.planes = {.depth = true, .normal = true, .ids = true, .parts = true};
  return draw(
      scene({object("torus:12", porcelain),
             placed(object("cube", "lambert:kd=.7/.5/.3"), {-0.3, -0.2, 0.1}, 0.4f),
             placed(object("icosphere:3", porcelain, Shading::flat), {0.7, 0.3, 0.1}, 0.45f)}),
      shot);
}

// What a lesson draws, small: the program itself is run. Without words: letters are drawn otherwise
// where the font or its library is another one.
Framebuffer lesson(const std::string& name) {
  const std::string picture = SCANLIT_SOURCE_DIR "/tests/out/lesson_" + name + ".exr";
  std::filesystem::create_directories(SCANLIT_SOURCE_DIR "/tests/out");
  const std::string command = "SCANLIT_FONT=none '" SCANLIT_LESSONS "/" + name +
                              "' --size 360 -o '" + picture + "' >'" + picture + ".txt' 2>&1";
  if (std::system(command.c_str()) != 0)
    throw Error(picture + ".txt", "says why the lesson failed");
  return read_image(picture);
}

// A row of the third triangle: spans, hidden pixels, the fill rule.
Framebuffer watched_row() {
  setenv("SCANLIT_FONT", "none", 1);
  const studio::WatchExample example = studio::watch_example();
  const Rect all{0, 0, example.width, example.height};
  return studio::scan_picture(studio::watch_scan_conversion(example.scene, example.camera, {},
                                                            example.width, example.height, all),
                              {2, 6}, 12);
}

const Tolerance edges{1e-4f, 1e-4f, 75,
                      "pixels on the edge of light fall to either side of it by rounding"};

const Tolerance bands{1e-4f, 1e-4f, 75,
                      "pixels on the border of two colour bands change by rounding"};

std::vector<Case> all_cases() {
  std::vector<Case> all = {
      {"teapot_flat", rounding, [] { return teapot(Shading::flat); }},
      {"teapot_gouraud", rounding, [] { return teapot(Shading::gouraud); }},
      {"teapot_phong", rounding, [] { return teapot(Shading::phong); }},
      {"samples_4", rounding, [] { return teapot_with_samples(4); }},
      {"samples_8", rounding, [] { return teapot_with_samples(8); }},
      {"samples_16", rounding, [] { return teapot_with_samples(16); }},
      {"near_plane_cuts_torus", rounding, near_plane_cuts_torus},
      {"camera_inside_cube", rounding, camera_inside_cube},
      {"planes_from_behind", rounding, planes_from_behind},
      {"spot_and_point_lights", rounding, spot_and_point_lights},
      {"colour_form_2", rounding, colour_form_2},
      {"orthographic", rounding, orthographic_teapot},
      {"viewer_at_infinity", rounding, teapot_for_a_viewer_at_infinity},
      {"perspective_plane", rounding,
       [] { return foreshortened_plane(Interpolation::perspective); }},
      {"screen_linear_plane", rounding,
       [] { return foreshortened_plane(Interpolation::screen_linear); }},
      {"intersecting_objects", rounding, intersecting_objects},
      {"watched_row", rounding, watched_row},
  };
  std::istringstream lessons(SCANLIT_LESSON_NAMES);
  for (std::string name; std::getline(lessons, name, ',');) {
    // What is there to see is a hard edge where light ends: N.L is 0 there, but for rounding.
    const bool hard_edges = name == "23_shadowing" || name == "25_plate";
    const Tolerance& tolerance = hard_edges ? edges : name == "37_accuracy" ? bands : rounding;
    all.push_back({"lesson_" + name, tolerance, [name] { return lesson(name); }});
  }
  for (Case& model_case : model_cases()) all.push_back(std::move(model_case));
  return all;
}

}  // namespace

const std::vector<Case>& cases() {
  static const std::vector<Case> all = all_cases();
  return all;
}

}  // namespace scanlit::golden
