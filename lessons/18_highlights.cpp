// New idea: N.H (Blinn) and R.V (Phong) ask the same question of two angles, one half the other.
// Builds on: lesson 17, the glossy part.
// Try: --n 20; --sun 8: what do the two streaks on the floor do when the sun sets?
#include <cmath>
#include <glm/trigonometric.hpp>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "rasterizer/formula_model.h"

using namespace scanlit;

// new idea
/// Ks (R.V)^n or Ks (N.H)^n. In the shading frame N is (0, 0, 1), so the mirrored light direction
/// R = 2 (N.L) N - L is L with x and y turned around.
struct Highlight {
  bool mirror;  // R.V
  Rgb<double> kd, ks;
  double n;

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    const Vec3<T> R{-f.l.x, -f.l.y, f.l.z}, N{T(0), T(0), T(1)};
    const T cosine = mirror ? dot(R, f.v) : dot(N, f.h);
    return {.diffuse = kd * c.n_l, .glossy = ks * pow(max(cosine, T(0)), T(n))};
  }
};
// end of new idea

/// How high and how wide the highlight is, in pixels brighter than half of the brightest.
glm::ivec2 extent(const Framebuffer& picture) {
  float brightest = 0;
  for (std::size_t i = 0; i < picture.pixel_count(); ++i)
    brightest = std::max(brightest, picture.colour[4 * i + 1]);
  glm::ivec2 low(picture.width, picture.height), high(0);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      if (picture.colour[4 * (std::size_t(y) * picture.width + x) + 1] > brightest / 2)
        low = glm::min(low, {x, y}), high = glm::max(high, {x + 1, y + 1});
  return high - low;
}

int main(int argc, char** argv) {
  studio::Lesson lesson("Phong's R.V and Blinn's N.H, on a ball and on the floor.", 1600, 1060);
  double n = 100, sun = 16;
  lesson.knob("--n", n, {1, 1000}, "exponent of R.V");
  lesson.knob("--sun", sun, {1, 80}, "how high the sun stands over the floor, in degrees");

  return lesson.run(argc, argv, [&] {
    const double exponents[] = {n, n, 4 * n};
    const std::string names[] = {"(R.V)^" + studio::text_of(n), "(N.H)^" + studio::text_of(n),
                                 "(N.H)^" + studio::text_of(4 * n)};
    const auto draw = [&](int panel, int width, int height) {
      const int column = panel % 3;
      const Highlight model{column == 0, {.10, .03, .02}, {.75, .70, .60}, exponents[column]};
      Object object = studio::make_object(panel < 3 ? "sphere:96" : "plane:1",
                                          std::make_shared<const FormulaModel<Highlight>>(model));
      Scene scene = studio::make_stage({object});
      scene.lights = {studio::far_light({-.5, .6, .7}, 1)};
      if (panel < 3) return studio::photograph(scene, {0, 0, 5}, width, height);
      scene.objects[0].world_from_object = glm::mat4(1000);
      scene.objects[0].world_from_object[3] = {0, 0, 0, 1};
      const double angle = glm::radians(sun);
      scene.lights = {studio::far_light({0, std::cos(angle), std::sin(angle)}, 1)};
      scene.background = {.12, .16, .24};
      const Camera camera{.eye = {0, 0, 1}, .target = {0, 3, 0}, .up = {0, 0, 1}, .fov_deg = 46};
      const Framebuffer picture = studio::photograph(scene, camera, width, height);
      const glm::ivec2 size = extent(picture);
      lesson.figure("spot of " + names[column] + ", height over width",
                    studio::fixed(double(size.y) / size.x, 1));
      return picture;
    };
    return studio::panels(lesson.width(), lesson.height(), 3,
                          {names[0], names[1], names[2], names[0] + ": low sun",
                           names[1] + ": low sun", names[2] + ": low sun"},
                          draw);
  });
}
