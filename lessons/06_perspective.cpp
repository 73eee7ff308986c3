// New idea: what is twice as far away appears half as large: divide by the distance.
// Builds on: lesson 5, orthographic projection.
// Try: --near 1.2; --near 40; stand closer to the page: from where does each picture look right?
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lessons/studio/drawing/panels.h"
#include "lessons/studio/lesson.h"

using namespace scanlit;
namespace ink = studio::ink;

// new idea
/// The camera: where it stands, and its own axes, of unit length. It looks along -back.
struct View {
  glm::dvec3 eye, right, up, back;

  View(glm::dvec3 from, glm::dvec3 to) : eye(from), back(glm::normalize(from - to)) {
    right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
    up = glm::cross(back, right);
  }

  /// World space to the picture plane, at distance 1 before the eye: x to the right, y up.
  glm::dvec2 project(glm::dvec3 p) const {
    const glm::dvec3 from_eye = p - eye;
    const double distance = -glm::dot(from_eye, back);
    return glm::dvec2(glm::dot(from_eye, right), glm::dot(from_eye, up)) / distance;
  }
};
// end of new idea

/// Draws a pavement and two rows of pillars, the farthest first, as large as they fit. Returns the
/// last pillar's height as a share of the first one's.
double draw_colonnade(const View& view, glm::dvec2 size, studio::Canvas& canvas) {
  glm::dvec2 low(1e9), high(-1e9);
  for (int corner = 0; corner < 8; ++corner) {
    const auto p = view.project({corner & 1 ? 2 : -2, corner & 2 ? 2 : 0, corner & 4 ? -0.3 : -12});
    low = glm::min(low, p), high = glm::max(high, p);
  }
  const double scale = 0.95 * std::min(size.x / (high.x - low.x), size.y / (high.y - low.y));
  const auto at = [&](double x, double y, double z) {
    return size / 2.0 + scale * (view.project({x, y, z}) - (low + high) / 2.0) * glm::dvec2(1, -1);
  };
  for (int z = -12; z < 0; ++z)
    for (int x = -2; x < 2; ++x)
      canvas.polygon({at(x, 0, z), at(x + 1, 0, z), at(x + 1, 0, z + 1), at(x, 0, z + 1)},
                     (x + z) % 2 ? ink::soft : ink::pale);
  const auto pillar = [&](double l, double r, double z, double front) {
    const double side = view.eye.x < l ? l : r;  // the one that is seen, unless the eye is between
    canvas.polygon({at(side, 0, z), at(side, 0, front), at(side, 2, front), at(side, 2, z)},
                   ink::orange * .3);
    canvas.polygon({at(l, 2, z), at(r, 2, z), at(r, 2, front), at(l, 2, front)}, ink::orange * 1.2);
    canvas.polygon({at(l, 0, front), at(r, 0, front), at(r, 2, front), at(l, 2, front)},
                   ink::orange * .75);
  };
  for (int z = -12; z < 0; z += 2)
    for (const double x : {1.2, -1.8}) pillar(x, x + 0.6, z + 0.9, z + 1.5);
  const auto height = [&](double z) { return at(-1.8, 0, z).y - at(-1.8, 2, z).y; };
  return height(-10.5) / height(-0.5);
}

int main(int argc, char** argv) {
  studio::Lesson lesson("Perspective divides by the distance.", 1800, 620);
  double near = 2.5;
  lesson.knob("--near", near, {1, 1000}, "from where the nearest picture is taken: its distance");

  return lesson.run(argc, argv, [&] {
    const double distances[] = {near, 4 * near, 400 * near};
    std::vector<std::string> captions;
    for (const double d : distances) captions.push_back("from a distance of " + studio::text_of(d));
    const auto draw = [&](int panel, int width, int height) {
      const View view(distances[panel] * glm::dvec3(-.2, .3, 1) + glm::dvec3(0, 1, 0), {0, 1, 0});
      studio::Canvas canvas(width, height, {width, height}, ink::blue * 0.25);
      const double share = draw_colonnade(view, {width, height}, canvas);
      lesson.figure(
          captions[std::size_t(panel)] + ", the last pillar is as high as the first, times",
          studio::fixed(share, 3));
      return canvas.finish();
    };
    return studio::panels(lesson.width(), lesson.height(), 3, captions, draw);
  });
}
