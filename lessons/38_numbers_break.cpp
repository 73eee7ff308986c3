// New idea: float has 24 bits, and three places in a renderer where they are not enough.
// Builds on: lesson 4, the fill rule; lesson 6, the camera; lesson 25, a division by N.V.
// Try: --far 10000; --far 10000000; --needles 2000; when does each of the three begin to show?
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"
#include "rasterizer/formula_model.h"
#include "rasterizer/scan_conversion.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// Far origins. Moved in the file, positions are rounded to the floats there are so far out. Moved
/// by the object's matrix they are not: it meets the camera's in double, and the two large numbers
/// cancel before anything is rounded.
void move(Object& object, const glm::vec3& there, bool in_the_file) {
  if (!in_the_file) {
    object.world_from_object = glm::translate(glm::mat4(1), there);
    return;
  }
  Mesh mesh = *object.mesh;
  for (glm::vec3& position : mesh.positions) position += there;
  object.mesh = std::make_shared<const Mesh>(mesh);
}

/// Slivers. Which side of a -> b is p on? The sign of this, once from the one triangle and once, as
/// b -> a, from its neighbour. In whole numbers the two are opposite; rounded they need not be.
template <class T>
T edge(const glm::vec<2, T>& a, const glm::vec<2, T>& b, const glm::vec<2, T>& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Grazing angles. Ward's root of (N.L)(N.V): at the outline an interpolated normal may face away
/// from a viewer who sees the point, and N.V is negative.
struct Ward1992 {
  bool careless;

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    const T n_v = careless ? f.v.z : c.n_v;  // c.n_v is at least min_n_v
    const T tan2 = c.n_h.sin2() / (c.n_h * c.n_h), m2(.06);
    const T lobe = exp(-(tan2 / m2)) * c.n_l / (T(4) * m2 * sqrt(c.n_l * n_v));
    return {.diffuse = Rgb<double>(.05, .16, .22) * c.n_l, .glossy = Rgb<double>(.12) * lobe};
  }
};
// end of new idea

/// A fan of needles around a point of a large screen. How often is each pixel hit? Positions are
/// pixels, as floats, or 1/256 pixels, as whole numbers.
template <class T>
Framebuffer fan(studio::Lesson& lesson, int needles, int width, int height) {
  constexpr bool whole = std::is_integral_v<T>;
  const int n = std::max(1, height / 36), columns = width / n, rows = height / n;
  const glm::dvec2 corner(3072, 1728),
      tip = corner + glm::dvec2(columns * .47 + .21, rows * .5 + .13);
  const auto point = [&](const glm::dvec2& p) {
    return glm::vec<2, T>(whole ? glm::round(p * double(subpixel)) : p);
  };
  const auto rim = [&](int i) {
    const double angle = 2 * std::numbers::pi * (i % needles) / needles;
    return point(tip + 2000.0 * glm::dvec2(std::cos(angle), std::sin(angle)));
  };
  const auto t = point(tip);
  std::vector<int> hits(std::size_t(columns) * rows), last(hits.size());
  for (int i = 0; i < needles; ++i) {
    const auto a = rim(i), b = rim(i + 1);
    for (std::size_t k = 0; k < hits.size(); ++k) {
      const auto p = point(corner + glm::dvec2(int(k) % columns + .5, int(k) / columns + .5));
      if (edge(t, a, p) >= 0 && edge(a, b, p) >= 0 && edge(b, t, p) > 0) ++hits[k], last[k] = i;
    }
  }
  studio::Canvas canvas(width, height, {double(columns), double(rows)}, ink::slate);
  const Rgb<double> light(.05, .16, .22), dark(.03, .09, .13),
      wrong[] = {ink::vermilion, ink::yellow};
  for (std::size_t k = 0; k < hits.size(); ++k)
    canvas.cell(int(k) % columns, int(k) / columns,
                hits[k] != 1                   ? wrong[hits[k] > 1]
                : last[k] * 24LL / needles % 2 ? light
                                               : dark);
  lesson.figure(std::string("slivers in ") + (whole ? "whole numbers" : "float") +
                    ", pixels missed or hit twice",
                std::to_string(hits.size() - std::size_t(std::ranges::count(hits, 1))));
  return canvas.finish();
}

int main(int argc, char** argv) {
  studio::Lesson lesson("Far origins, slivers and grazing angles.", 1800, 960);
  double far = 300000;
  int needles = 40000;
  lesson.knob("--far", far, {0, 1e9}, "how far from the origin the first teapot stands");
  lesson.knob("--needles", needles, {8, 200000}, "triangles in the fan");

  return lesson.run(argc, argv, [&] {
    const auto draw = [&](int panel, int width, int height) {
      const bool careless = panel < 3;
      if (panel % 3 == 1)
        return (careless ? fan<float> : fan<std::int64_t>)(lesson, needles, width, height);
      if (panel % 3 == 0) {
        Object teapot = studio::make_object("teapot:16", "blinn-phong:kd=.05/.16/.22,ks=.6,n=60");
        const glm::vec3 there{float(far)};
        const Camera here = studio::fitted({.eye = {1, 2, 5}, .fov_deg = 20},
                                           studio::make_stage({teapot}), double(width) / height);
        Camera camera = here;
        camera.eye += glm::dvec3(there), camera.target += glm::dvec3(there);
        move(teapot, there, careless);
        return studio::photograph(studio::make_stage({teapot}), camera, width, height);
      }
      const auto ward = std::make_shared<const FormulaModel<Ward1992>>(Ward1992{careless});
      Framebuffer picture = studio::photograph(
          studio::make_stage({studio::make_object("teapot:3", ward)}), {1, 2, 5}, width, height);
      double covered = 0, broken = 0;
      for (std::size_t i = 0; i < picture.colour.size(); i += 4) {
        covered += picture.colour[i + 3] > 0;
        if (std::isfinite(picture.colour[i])) continue;
        const double ink[] = {ink::vermilion.r, ink::vermilion.g, ink::vermilion.b};
        std::copy(ink, ink + 3, &picture.colour[i]), ++broken;
      }
      lesson.figure(careless ? "grazing, pixels that are no number" : "grazing, N.V clamped",
                    studio::fixed(100 * broken / covered, 0) + " %");
      return picture;
    };
    return studio::panels(lesson.width(), lesson.height(), 3,
                          {"far from the origin", "slivers in float", "N.V < 0: no number",
                           "cancelled in double", "in whole numbers", "N.V clamped"},
                          draw);
  });
}
