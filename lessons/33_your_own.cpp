// New idea: a model of your own is one formula; the engine does the rest, in vectors.
// Builds on: all lessons of this part; here you write.
// Try: --film 250; --film 600; then change the formula, and read what is printed of it.
#include <algorithm>
#include <cmath>
#include <random>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "lessons/studio/reflect/query.h"
#include "models/albedo.h"
#include "rasterizer/formula_model.h"

using namespace scanlit;

// new idea
/// A beetle: a dark body under a film as thin as a wave of light. What its upper and its lower side
/// mirror differ by the way 2 index film cos(theta) through it and, one of the two being mirrored
/// at what is denser, by half a wave: sin^2 of half the difference of phase is left of them.
struct Beetle {
  double film, index, n;  // film's thickness in nm, its refractive index, highlight's exponent
  static constexpr double red_nm = 620, green_nm = 540, blue_nm = 455;

  template <class T>
  static T left(const T& way, double wavelength_nm) {
    const T wave = sin(way * T(std::numbers::pi / wavelength_nm));
    return wave * wave;
  }
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    const T sine2 = (T(1) - c.v_h * c.v_h) * T(1 / (index * index));  // refracted, Snell
    const T way = T(2 * index * film) * sqrt(T(1) - sine2);
    const Rgb<T> colour(left(way, red_nm), left(way, green_nm), left(way, blue_nm));
    return {.diffuse = colour * (T(.04) * c.n_l), .glossy = colour * (T(.9) * pow(c.n_h, T(n)))};
  }
};
// end of new idea

/// The first two things to ask of a model: by how much f_r(L, V) and f_r(V, L) differ at most, and
/// how much of all light it reflects.
void examine(studio::Lesson& lesson, const ReflectionModel& model) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> theta(0, 89), phi(0, 360);
  double largest = 0;
  for (int i = 0; i < 10000; ++i) {
    const auto l = studio::direction_at(theta(random), phi(random));
    const auto v = studio::direction_at(theta(random), phi(random));
    const double there = studio::reflected(model, l, v).g / l.z;
    const double back = studio::reflected(model, v, l).g / v.z;
    largest = std::max(largest, std::abs(there - back) / std::max({there, back, 1e-9}));
  }
  lesson.figure("there and back differ by at most", studio::fixed(100 * largest, 1) + " %");
  for (const double angle : {0.0, 60.0, 85.0})
    lesson.figure(
        "albedo at " + studio::text_of(angle) + " degrees",
        studio::fixed(
            models::directional_albedo(model, studio::direction_at(angle, 0), 1e-4).value.g, 3));
}

int main(int argc, char** argv) {
  studio::Lesson lesson("A model of your own: the colours of a thin film.", 1740, 1060);
  double film = 330, index = 1.5, n = 25;
  lesson.knob("--film", film, {0, 2000}, "thickness of the middle one's film, in nm");
  lesson.knob("--index", index, {1, 3}, "its refractive index");
  lesson.knob("--n", n, {1, 1000}, "exponent of the highlight");

  return lesson.run(argc, argv, [&] {
    const double films[] = {.8 * film, film, 1.2 * film};
    const auto draw = [&](int panel, int width, int height) {
      const auto model =
          std::make_shared<const FormulaModel<Beetle>>(Beetle{films[panel % 3], index, n});
      if (panel == 1) examine(lesson, *model);
      Scene scene =
          studio::make_stage({studio::make_object(panel < 3 ? "teapot:32" : "trefoil:64", model)});
      for (const double x : {-.9, -.3, .4, .9})
        scene.lights.push_back(studio::far_light({x, .4 - x * x, .5 + .3 * x}, .3));
      return studio::photograph(scene, {1, 2, 5}, width, height);
    };
    const auto name = [&](int i) { return studio::text_of(films[i]) + " nm"; };
    return studio::panels(lesson.width(), lesson.height(), 3,
                          {name(0), name(1), name(2), name(0), name(1), name(2)}, draw);
  });
}
