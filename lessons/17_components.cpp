// New idea: the lecture's model is a sum of three parts, and each can be drawn alone.
// Builds on: lesson 12, Phong shading, which asks a model at every pixel.
// Try: --ia .4; --n 5; without which part does the teapot look flat, and without which dry?
#include <algorithm>
#include <cmath>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "rasterizer/formula_model.h"

using namespace scanlit;

// new idea
/// I = Ka Ia + { Kd (N.L) + Ks (N.H)^n } Ii. What stands in braces is the reflection model; the
/// part in front of them depends on no direction, and the engine adds it.
struct LectureModel {
  Rgb<double> ka, kd, ks;
  double n;

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    return {.diffuse = kd * c.n_l, .glossy = ks * pow(c.n_h, T(n))};
  }

  LectureModel ambient_part() const { return {ka, {}, {}, n}; }
  LectureModel diffuse_part() const { return {{}, kd, {}, n}; }
  LectureModel glossy_part() const { return {{}, {}, ks, n}; }
};
// end of new idea

/// The mean of all that light adds to the picture's background.
double mean_light(const Framebuffer& picture) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.colour.size(); ++i)
    if (i % 4 != 3) sum += picture.colour[i];
  return sum / double(3 * picture.pixel_count());
}

int main(int argc, char** argv) {
  studio::Lesson lesson("Ambient, diffuse and glossy light, apart and summed.", 1500, 1060);
  double ia = 1, n = 60;
  lesson.knob("--ia", ia, {0, 3}, "Ia, the ambient light");
  lesson.knob("--n", n, {1, 1000}, "exponent of the highlight");

  return lesson.run(argc, argv, [&] {
    const LectureModel whole{{.02, .06, .10}, {.06, .27, .45}, {.5, .5, .5}, n};
    const LectureModel models[] = {whole.ambient_part(), whole.diffuse_part(), whole.glossy_part(),
                                   whole};
    std::vector<Framebuffer> pictures;
    const auto draw = [&](int panel, int width, int height) {
      const LectureModel& model = models[panel];
      Object teapot = studio::make_object(
          "teapot:24", std::make_shared<const FormulaModel<LectureModel>>(model));
      teapot.material.ka = model.ka, teapot.material.ambient_share = 0;
      Scene scene = studio::make_stage({teapot});
      scene.lights = {studio::far_light({-.6, .7, .7}, 1)};
      scene.ambient = Rgb<double>(ia);
      scene.background = {};
      pictures.push_back(studio::photograph(scene, {1, 2.2, 5}, width, height));
      return pictures.back();
    };
    const Framebuffer sheet = studio::panels(
        lesson.width(), lesson.height(), 2,
        {"ambient: Ka Ia", "+ diffuse: Kd (N.L) Ii", "+ glossy: Ks (N.H)^n Ii", "= I"}, draw,
        Rgb<double>(0));
    const double all = mean_light(pictures[3]);
    const char* const names[] = {"ambient", "diffuse", "glossy"};
    for (int k = 0; k < 3; ++k)
      lesson.figure(std::string(names[k]) + " share of the light, in percent",
                    studio::fixed(100 * mean_light(pictures[k]) / all, 1));
    double largest = 0;
    for (std::size_t i = 0; i < pictures[3].colour.size(); ++i)
      if (i % 4 != 3)
        largest = std::max(largest, std::abs(double(pictures[0].colour[i]) + pictures[1].colour[i] +
                                             pictures[2].colour[i] - pictures[3].colour[i]));
    lesson.figure("largest difference of sum and whole", studio::fixed(largest, 5));
    return sheet;
  });
}
