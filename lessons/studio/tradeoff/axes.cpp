#include "lessons/studio/tradeoff/axes.h"

namespace scanlit::studio {

const std::vector<StudyAxis>& study_axes() {
  static const char* const surface = "the true surface";
  static const char* const in_double = "the same triangles in double";
  static const std::vector<StudyAxis> axes{
      {"teapot", "Teapot: shading and tessellation", surface, 4, sweep_teapot},
      {"sphere", "Sphere: shading and tessellation", surface, 5, sweep_sphere},
      {"arithmetic", "Arithmetic, power and normals", in_double, 1, sweep_arithmetic},
      {"perspective", "Perspective on a wall of two triangles", in_double, 1, sweep_perspective},
      {"tolerance", "A tolerance under 16 lights", in_double, 1, sweep_tolerance},
      {"fresnel", "Copper's Fresnel reflectance", "the spectrum, in double", 1.5, sweep_fresnel},
      {"tables", "A formula and tables of it", in_double, 1, sweep_tables}};
  return axes;
}

}  // namespace scanlit::studio
