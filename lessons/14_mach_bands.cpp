// New idea: the eye reports not light but differences of light, and so finds every bend of it.
// Builds on: lesson 13, the three shadings.
// Try: --segments 24; --reach 40; stand back until the bands of the second cylinder disappear.
#include <algorithm>

#include "lessons/studio/drawing/chart.h"
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"

using namespace scanlit;
namespace ink = studio::ink;

/// Light along the picture's middle row, 0 beside the object.
std::vector<double> middle_row(const Framebuffer& picture) {
  std::vector<double> light;
  for (int x = 0; x < picture.width; ++x)
    light.push_back(picture.colour[4 * (std::size_t(picture.height / 2) * picture.width + x) + 1]);
  return light;
}

// new idea
/// Lateral inhibition: a cell in the retina reports its own light, and is held back by what its
/// neighbours within `reach` get. Where light changes evenly that cancels; at a bend it does not.
std::vector<double> reported(const std::vector<double>& light, int reach) {
  constexpr double strength = 3;
  std::vector<double> result = light;
  for (int i = reach; i < int(light.size()) - reach; ++i) {
    double neighbours = 0;
    for (int k = -reach; k <= reach; ++k) neighbours += light[i + k] / (2 * reach + 1);
    result[i] += strength * (light[i] - neighbours);
  }
  return result;
}

/// The sharpest bend: by how much the slope, per pixel, changes within a few pixels, at most.
double sharpest_bend(const std::vector<double>& light, int reach) {
  constexpr int few = 4;
  double bend = 0;
  for (int i = reach; i < int(light.size()) - reach; ++i)
    bend = std::max(bend, std::abs(light[i - few] - 2 * light[i] + light[i + few]) / few);
  return bend;
}
// end of new idea

int main(int argc, char** argv) {
  studio::Lesson lesson("Mach bands: the eye finds where light bends.", 1800, 1000);
  int segments = 12, reach = 36;
  lesson.knob("--segments", segments, {3, 200}, "of the cylinder");
  lesson.knob("--reach", reach, {4, 200}, "of a cell's neighbours, in pixels");

  return lesson.run(argc, argv, [&] {
    Object cylinder = studio::make_object("cylinder:" + std::to_string(segments), "lambert:kd=.85");
    const std::vector<std::string> names = {"flat", "Gouraud", "Phong shading"};
    const auto draw = [&](int panel, int width, int height) {
      cylinder.shading = std::array{Shading::flat, Shading::gouraud, Shading::phong}[panel % 3];
      Scene scene = studio::make_stage({cylinder});
      scene.lights = {studio::far_light({-.15, 0, 1}, .8)};
      Camera camera;  // so near that nothing but the cylinder is in the picture
      camera.projection = Projection::orthographic;
      camera.height = 1.7 * height / width;
      camera.far = 10;
      Framebuffer picture = studio::photograph(scene, camera, width, height);
      if (panel < 3) return picture;

      const std::vector<double> light = middle_row(picture), seen = reported(light, reach);
      lesson.figure(names[panel - 3] + ", sharpest bend, in 1/1000 of white",
                    studio::fixed(1000 * sharpest_bend(light, reach), 1));
      studio::Chart chart(width, height, {0, double(width), "pixels"}, {0, 1, "light"},
                          lesson.height());
      std::vector<glm::dvec2> light_curve, seen_curve;
      for (int x = 0; x < width; ++x) {
        light_curve.emplace_back(x, light[x]);
        if (x >= reach && x < width - reach)
          seen_curve.emplace_back(x, std::clamp(seen[x], 0.0, 1.0));
      }
      chart.curve(seen_curve, ink::vermilion, 7);
      chart.curve(light_curve, ink::black, 5);
      chart.words({.5 * width, .3}, "as reported", ink::vermilion, Align::centre);
      chart.words({.5 * width, .15}, "as it is", ink::black, Align::centre);
      return chart.finish();
    };
    return studio::panels(lesson.width(), lesson.height(), 3,
                          {names[0], names[1], names[2], "", "", ""}, draw);
  });
}
