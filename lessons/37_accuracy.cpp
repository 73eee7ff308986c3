// New idea: an error is measured against a reference that is right, in steps that one can see.
// Builds on: lesson 13, where flat, Gouraud and Phong shading stood side by side.
// Try: --n 4; --n 32; which of the three errors shrinks with the triangles, and how fast?
#include <cmath>

#include "lessons/studio/drawing/heat.h"
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "rasterizer/reference/analytic.h"
#include "rasterizer/reference/picture_error.h"

using namespace scanlit;

// new idea
/// How far a pixel is off, in the steps of an 8-bit sRGB file: the worst channel's.
double error_in_steps(const Rgb<double>& right, const Rgb<double>& drawn) {
  const auto steps = [](double a, double b) {
    return 255 * std::abs(encoded(a, Encoding::srgb) - encoded(b, Encoding::srgb));
  };
  return std::max({steps(right.r, drawn.r), steps(right.g, drawn.g), steps(right.b, drawn.b)});
}

struct Errors {
  std::vector<double> steps;     // a pixel; -1: empty
  double rms = 0, interior = 0;  // root mean square over the surface, without its outline
};

/// On the outline a coarse mesh misses pixels altogether, or has some too many. That is an error of
/// the shape, and no shading can mend it: it is left out of the sum.
Errors errors_of(const ExactPicture& right, const ExactPicture& drawn,
                 const std::vector<bool>& outline) {
  Errors e;
  for (std::size_t i = 0; i < right.pixel_count(); ++i) {
    const bool empty = right.object[i] == no_id && drawn.object[i] == no_id;
    e.steps.push_back(empty ? -1 : error_in_steps(right.colour[i], drawn.colour[i]));
    if (empty || outline[i]) continue;
    e.rms += e.steps[i] * e.steps[i], ++e.interior;
  }
  e.rms = std::sqrt(e.rms / e.interior);
  return e;
}
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("Pictures of the error, against a reference.", 1800, 1240);
  int n = 8;
  lesson.knob("--n", n, {2, 64}, "segments a side of each of the teapot's patches");

  return lesson.run(argc, argv, [&] {
    const std::vector<std::string> names = {"the picture", "float, not double", "Phong shading",
                                            "Gouraud shading"};
    const std::vector<double> ends = {.01, .1, .5, 2, 8, 32};
    std::vector<studio::HeatScale::Band> bands;
    for (double end : ends) bands.push_back({end, "< " + studio::text_of(end)});
    bands.push_back({0, "more"});
    const studio::HeatScale scale(bands);
    const auto stage = [](int segments, Shading shading) {
      return studio::make_stage({studio::make_object(
          "teapot:" + std::to_string(segments), "blinn-phong:kd=.05/.16/.22,ks=.6,n=60", shading)});
    };
    const Scene fine = stage(64, Shading::phong);
    ExactPicture truth;
    const auto draw = [&](int panel, int width, int height) {
      const Camera camera =
          studio::fitted({.eye = {1, 2, 5}, .fov_deg = 20}, fine, double(width) / height);
      if (panel == 0) return studio::photograph(fine, camera, width, height);
      if (panel == 2) truth = render_analytic(fine, camera, width, height);
      const Scene scene = stage(n, panel == 3 ? Shading::gouraud : Shading::phong);
      Framebuffer drawn(width, height, {.ids = true});
      render(scene, camera, {}, drawn);
      const ExactPicture in_double = render_reference(scene, camera, width, height);
      const ExactPicture& right = panel == 1 ? in_double : truth;
      const Errors e =
          errors_of(right, exact_picture(drawn), silhouettes(right, in_double, camera));
      // How much less depends on the processor.
      lesson.figure(names[panel] + ", rms error in steps",
                    e.rms < .001 ? "less than 0.001" : studio::fixed(e.rms, 2));
      return scale.draw(e.steps, width, height);
    };
    const int strip = lesson.height() / 8;
    return studio::stacked(
        studio::panels(lesson.width(), lesson.height() - strip, 2, names, draw, studio::ink::slate,
                       lesson.height()),
        scale.legend("error, in 8-bit steps", lesson.width(), strip, lesson.height()));
  });
}
