// New idea: light a face once, by its own normal, and give the colour to all of its pixels.
// Builds on: lesson 9; from here on the engine says which triangle is seen at a pixel.
// Try: --light 80; --shape sphere:8; which faces are as bright as the surface they stand for?
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/drawing/stages.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/reflect/sheet_layout.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// I = Ka Ia + Kd (N.L) Ii, once for each face. N is perpendicular to two of its edges; a face that
/// the light does not reach has N.L below 0 and gets the ambient light alone.
std::vector<Rgb<double>> face_colours(const Mesh& mesh, glm::dvec3 light, const Rgb<double>& kd) {
  std::vector<Rgb<double>> colours;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const glm::dvec3 a = mesh.positions[mesh.indices[3 * t]];
    const glm::dvec3 b = mesh.positions[mesh.indices[3 * t + 1]];
    const glm::dvec3 c = mesh.positions[mesh.indices[3 * t + 2]];
    const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));  // counter-clockwise: outwards
    const double n_l = std::max(glm::dot(n, light), 0.0);
    colours.push_back(kd * (0.12 + 0.88 * n_l));
  }
  return colours;
}
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("Flat shading: one colour for each face.", 1800, 450);
  std::string shape = "teapot";
  int coarse = 3;
  double light_deg = 35;
  lesson.knob("--shape", shape, "a shape");
  lesson.knob("--segments", coarse, {3, 50}, "of the coarsest; each next has three times as many");
  lesson.knob("--light", light_deg, studio::any_angle_deg, "to the left of the viewer, in degrees");

  return lesson.run(argc, argv, [&] {
    std::vector<std::string> captions;
    for (const int times : {1, 3, 9})
      captions.push_back(shape + ':' + std::to_string(coarse * times));
    const double angle = glm::radians(light_deg);
    const glm::dvec3 light = glm::normalize(glm::dvec3(-std::sin(angle), 0.7, std::cos(angle)));
    const auto draw = [&](int panel, int width, int height) {
      constexpr int fine = 3;
      const Object object = studio::make_object(captions[std::size_t(panel)], "lambert");
      Scene scene;
      scene.objects = {object};
      Camera camera;
      camera.eye = {1.2, 1.6, 5};
      camera.fov_deg = 20;
      camera = studio::fitted(camera, scene, double(width) / height);

      const auto colours = face_colours(*object.mesh, light, {.75, .55, .30});
      Framebuffer image = studio::blank_picture(width * fine, height * fine, ink::slate);
      for (const auto& p : studio::visible_points(object, camera, image.width, image.height))
        studio::put(image, p.x, p.y, colours[p.triangle]);
      lesson.figure("faces of " + captions[std::size_t(panel)],
                    studio::grouped(std::int64_t(object.mesh->triangle_count())));
      return studio::reduced(image, fine);
    };
    return studio::panels(lesson.width(), lesson.height(), 3, captions, draw);
  });
}
