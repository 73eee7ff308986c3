// New idea: where the reflection model is evaluated is all that flat, Gouraud and Phong differ in.
// Builds on: lessons 10, 11 and 12, each of which made one of the three by hand.
// Try: --teapot teapot:16; --n 300; which shading loses the highlight first, and where?
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"

using namespace scanlit;

int main(int argc, char** argv) {
  studio::Lesson lesson("Flat, Gouraud and Phong shading, side by side.", 1800, 500);
  std::string shape = "teapot:4";  // coarse, so that it shows what is lost between the vertices
  double n = 80;
  lesson.knob("--teapot", shape, "its shape and tessellation");
  lesson.knob("--n", n, {1, 1000}, "exponent of the highlight");

  return lesson.run(argc, argv, [&] {
    Object teapot = studio::make_object(
        shape, "blinn-phong:kd=.50/.17/.07,ks=.5/.42/.35,n=" + studio::text_of(n));
    teapot.world_from_object = glm::rotate(glm::mat4(1), glm::radians(-20.f), glm::vec3(0, 1, 0));
    const auto draw = [&](int panel, int width, int height) {
      // new idea
      constexpr Shading where[] = {Shading::flat, Shading::gouraud, Shading::phong};
      teapot.shading = where[panel];
      // end of new idea
      FrameStats stats;
      const Framebuffer picture =
          studio::photograph(studio::make_stage({teapot}), {0, 2, 5}, width, height, &stats);
      const char* const points[] = {"faces", "vertices", "pixels"};
      lesson.figure(std::string("evaluations at ") + points[panel],
                    studio::grouped(stats.evaluations));
      return picture;
    };
    return studio::panels(
        lesson.width(), lesson.height(), 3,
        {"flat: once for each face", "Gouraud: at the vertices", "Phong shading: at every pixel"},
        draw);
  });
}
