#include "lessons/studio/drawing/polar.h"

#include <cmath>
#include <glm/trigonometric.hpp>

namespace scanlit::studio {
namespace {

constexpr double width_units = 108, height_units = 62, radius = 50;
constexpr glm::dvec2 centre{width_units / 2, 56};

}  // namespace

glm::dvec2 Polar::at(double angle, double r) const {
  const double radians = glm::radians(angle);
  return centre + r * glm::dvec2(std::sin(radians), -std::cos(radians));
}

Polar::Polar(int width, int height, double largest, int sheet_height)
    : canvas_(width, height, {width_units, height_units}), largest_(largest) {
  canvas_.letter_for(sheet_height);
  for (const double r : {radius / 2, radius}) {
    std::vector<glm::dvec2> arc;
    for (int angle = -90; angle <= 90; angle += 2) arc.push_back(at(angle, r));
    canvas_.polyline(arc, ink::pale, 5);
  }
  for (int angle = -60; angle <= 60; angle += 30)
    canvas_.line(centre, at(angle, radius), ink::pale, 5);
  canvas_.rectangle({0, centre.y}, {width_units, centre.y + 4}, ink::pale);
  canvas_.line({0, centre.y}, {width_units, centre.y}, ink::black, 8);
}

void Polar::light(double angle, const Rgb<double>& colour) {
  canvas_.arrow(at(-angle, radius + 4), at(-angle, 3), colour, 10);
  canvas_.line(centre, at(angle, radius), colour, 3);
}

void Polar::lobe(const std::function<double(double angle)>& value, const Rgb<double>& colour) {
  std::vector<glm::dvec2> curve{centre};
  for (double angle = -89.75; angle < 90; angle += .25)
    curve.push_back(at(angle, radius * value(angle) / largest_));
  curve.push_back(centre);
  canvas_.polyline(curve, colour, 12);
}

}  // namespace scanlit::studio
