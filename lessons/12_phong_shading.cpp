// New idea: interpolate the normals, make them unit vectors again, and light every pixel.
// Builds on: lesson 11, Gouraud shading.
// Try: --n 5; --n 300; --shape sphere:4: how short do the interpolated normals become?
#include <glm/geometric.hpp>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/drawing/stages.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/reflect/sheet_layout.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// The mean of the vertices' normals, weighted by the barycentric coordinates. It is shorter than 1
/// wherever they differ, and N.H would be too small.
glm::dvec3 mean_normal(const studio::VisiblePoint& p, const Mesh& mesh) {
  return p.interpolated(mesh.normals);
}

/// The reflection model, asked at every pixel.
Rgb<double> colour_at(const studio::VisiblePoint& p, const Scene& scene, glm::dvec3 to_viewer) {
  const glm::dvec3 normal = glm::normalize(mean_normal(p, *scene.objects[0].mesh));
  return studio::reflected_light(scene, normal, to_viewer);
}
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("Phong shading: normals between the vertices, light at every pixel.", 1800,
                        450);
  std::string shape = "teapot:3";
  double n = 30;
  lesson.knob("--shape", shape, "what is lit");
  lesson.knob("--n", n, {1, 1000}, "exponent of the highlight");

  return lesson.run(argc, argv, [&] {
    const std::string model = "blinn-phong:kd=.10/.30/.55,ks=.4,n=" + studio::text_of(n);
    const Scene scene = studio::make_stage({studio::make_object(shape, model)});
    double shortest = 1;
    const auto draw = [&](int panel, int width, int height) {
      constexpr int fine = 3;
      Camera viewer;
      viewer.eye = {1.2, 1.6, 5};
      viewer.fov_deg = 20;
      const Camera camera = studio::fitted(viewer, scene, double(width) / height);
      Framebuffer image = studio::blank_picture(width * fine, height * fine, ink::slate);
      for (const auto& p :
           studio::visible_points(scene.objects[0], camera, image.width, image.height)) {
        const glm::dvec3 mean = mean_normal(p, *scene.objects[0].mesh);
        const glm::dvec3 shown = (glm::normalize(mean) + 1.0) / 2.0 * 0.9;
        const double missing = 1 - glm::length(mean);
        shortest = std::min(shortest, glm::length(mean));
        studio::put(image, p.x, p.y,
                    panel == 0 ? Rgb<double>(shown.x, shown.y, shown.z)
                    : panel == 1
                        ? ink::pale + (ink::vermilion - ink::pale) * std::min(1.0, 5 * missing)
                        : colour_at(p, scene, towards_viewer(camera)));
      }
      return studio::reduced(image, fine);
    };
    Framebuffer sheet = studio::panels(lesson.width(), lesson.height(), 3,
                                       {"normals: x, y, z as red, green, blue",
                                        "what is missing to length 1", "lit at every pixel"},
                                       draw);
    lesson.figure("shortest mean of unit normals", studio::fixed(shortest, 2));
    return sheet;
  });
}
