// New idea: facets stand in each other's light and view, and G is the share that is left.
// Builds on: lesson 22, a surface of facets.
// Try: --light 20 --viewer 40; --light 5 --viewer 85; from where on does G fall below 1?
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lessons/studio/drawing/chart.h"
#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/drawing/stage.h"
#include "lessons/studio/lesson.h"

using namespace scanlit;
namespace ink = studio::ink;
using glm::dvec2, glm::dot;

// new idea
/// The share of a facet that the light L reaches and the viewer V sees, where facets are the sides
/// of V-shaped grooves; H is the facet's own normal.
double G(dvec2 N, dvec2 L, dvec2 V) {
  const dvec2 H = glm::normalize(L + V);
  const double Ga = 1;                                      // nothing is hidden
  const double Gb = 2 * dot(N, H) * dot(N, V) / dot(V, H);  // masking: from the viewer
  const double Gc = 2 * dot(N, H) * dot(N, L) / dot(L, H);  // shadowing: from the light
  return std::min({Ga, Gb, Gc});
}

/// The groove itself, y up: its sides go from (-1, 0) and (1, 0) down to (0, -depth). How far a ray
/// comes from a point on the left side before it hits the right one; if it leaves, 3.
double way(dvec2 from, dvec2 direction, double depth) {
  const double t = (depth * (from.x - 1) - from.y) / (direction.y - depth * direction.x);
  const bool hits = t > 0 && from.y + t * direction.y < 0;
  return hits ? t : 3;
}
// end of new idea

/// A direction so many degrees from N = (0, 1) to the right.
dvec2 towards(double deg) { return {std::sin(glm::radians(deg)), std::cos(glm::radians(deg))}; }

/// The light that comes to the groove's left side (orange), and where it goes (blue). Returns the
/// share of the side that is lit and seen.
double draw_groove(studio::Canvas& canvas, dvec2 L, dvec2 V) {
  const double depth = (L + V).x / (L + V).y;  // the left side is perpendicular to H
  const auto at = [](dvec2 p) { return dvec2(2 + 1.2 * p.x, 1.75 - 1.2 * p.y); };
  constexpr int rays = 1000;
  int both = 0;
  for (int i = 0; i < rays; ++i) {
    const double t = (i + .5) / rays;
    const dvec2 point(-t, depth * (t - 1));
    const double lit = way(point, L, depth), seen = way(point, V, depth);
    both += lit == 3 && seen == 3;
    if (i % 100 != 50) continue;
    canvas.line(at(point + 3.0 * L), at(lit == 3 ? point : point + lit * L), ink::orange, 6);
    if (lit == 3) canvas.line(at(point), at(point + seen * V), ink::blue, 6);
  }
  const dvec2 bottom = at({0, -depth});  // the ground hides light that does not get that far
  for (const double side : {-1.0, 1.0})
    canvas.polygon({at({side, 0}), bottom, {2, 4}, {2 + 2 * side, 4}, {2 + 2 * side, 1.75}},
                   ink::grid);
  canvas.polyline({{0, 1.75}, at({-1, 0}), bottom, at({1, 0}), {4, 1.75}}, ink::black, 8);
  return double(both) / rays;
}

Framebuffer chart_of_G(int width, int height, int sheet_height) {
  studio::Chart chart(width, height, {-90, 90, "angle of V"}, {0, 1, "G"}, sheet_height);
  const Rgb<double> colours[] = {ink::blue, ink::orange, ink::vermilion};
  for (int k = 0; k < 3; ++k) {
    std::vector<dvec2> curve;
    for (double v = -89.5; v < 90; v += .5)
      curve.emplace_back(v, std::max(0.0, G({0, 1}, towards(-40 * k), towards(v))));
    chart.curve(curve, colours[k], 12);
  }
  return chart.finish();
}

int main(int argc, char** argv) {
  studio::Lesson lesson("G: facets that shadow and mask each other.", 1740, 1060);
  double light = 10, viewer = 75;
  lesson.knob("--light", light, {0, 89}, "angle of the light from N, in degrees");
  lesson.knob("--viewer", viewer, {0, 89}, "of the viewer, on the same side");

  return lesson.run(argc, argv, [&] {
    const double angles[3][2] = {{10, 30}, {light, viewer}, {viewer, light}};
    const char* const names[] = {"Ga: all is seen", "Gb: masked", "Gc: shadowed"};
    const auto draw = [&](int panel, int width, int height) {
      if (panel == 3) return chart_of_G(width, height, lesson.height());
      if (panel > 3) {
        Scene scene = studio::make_stage({studio::make_object(
            "teapot:32", std::string("torrance-sparrow:m=.5,F=one,ks=.7/.6/.5,G=") +
                             (panel == 4 ? "none" : "vcavity"))});
        scene.lights = {studio::far_light({-.8, .5, -.35}, 1), studio::far_light({.5, .5, 1}, .4)};
        return studio::photograph(scene, {1, 2.2, 5}, width, height);
      }
      const dvec2 L = towards(angles[panel][0]), V = towards(angles[panel][1]);
      studio::Canvas canvas(width, height, {4, 3.2});
      const double counted = draw_groove(canvas, L, V);
      lesson.figure(std::string(names[panel]) + ", G = " + studio::fixed(G({0, 1}, L, V), 3) +
                        ", share of rays",
                    studio::fixed(counted, 3));
      return canvas.finish();
    };
    return studio::panels(
        lesson.width(), lesson.height(), 3,
        {names[0], names[1], names[2], "G; light at 0, -40, -80 degrees", "without G", "with G"},
        draw);
  });
}
