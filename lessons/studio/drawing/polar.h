// A polar plot: how much a surface sends in each direction of the plane of incidence.
#pragma once

#include <functional>

#include "lessons/studio/drawing/canvas.h"

namespace scanlit::studio {

/// The surface lies at the bottom, light comes from the left. Angles are degrees from the normal,
/// positive on the right, the side of the mirror direction.
class Polar {
 public:
  /// `largest` is the value whose lobe just reaches the half circle. Words as for a picture of
  /// sheet_height pixels.
  Polar(int width, int height, double largest, int sheet_height);

  /// An arrow from the light to the surface, and a thin line where a mirror would send it.
  void light(double angle, const Rgb<double>& colour);
  /// Where the value is above 0.
  void lobe(const std::function<double(double angle)>& value, const Rgb<double>& colour);
  Framebuffer finish() { return canvas_.finish(); }

 private:
  glm::dvec2 at(double angle, double radius) const;

  Canvas canvas_;
  double largest_;
};

}  // namespace scanlit::studio
