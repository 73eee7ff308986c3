// (9) Lights and surface made ready for the reflection model: what is known before any point is.
#pragma once

#include <vector>

#include "rasterizer/vec.h"

namespace scanlit {

/// The direction half-way between two unit directions: s / |s|, s = l + v.
template <class T>
struct HalfWay {
  Vec3<T> h;
  T v_h;  // V.H = L.H = |s| / 2, in [0, 1]
  T s2;   // |s|^2; below `none`, where l = -v, H has no direction

  static constexpr double none = 1e-20;
};

/// A light as the points of one object see it. World space.
struct LightSource {
  bool far = true;         // infinitely far: a direction, and no fall-off
  bool cone = false;       // a spot light
  Vec3<float> to_light{};  // far: unit
  HalfWay<float> half{};   // far, where the viewer is so, too: the same at every point
  Vec3<float> position{};  // not far, as all that follows
  float constant = 1, linear = 0, quadratic = 0;  // fall-off
  Vec3<float> axis{};                             // of the cone, unit, back towards the light
  float cos_outer = 0, inverse_width = 0;         // of the cone; 1 / (cos_inner - cos_outer)
  // Its intensity and colour in the material's colour form, for each part. At most 1e30: an
  // infinite one would be NaN where nothing is reflected.
  Rgb<float> diffuse{}, glossy{};
};

/// How one object is lit, and what its shading looks at.
struct Illumination {
  std::vector<LightSource> lights{};
  Rgb<float> ambient{};        // the ambient radiance but for Material::ambient_share
  bool near_lights = false;    // some light is not far
  bool constant = false;       // nothing but `ambient`
  bool needs_position = true;  // object space or world space
  bool needs_weights = true;   // where in its triangle a fragment lies
};

}  // namespace scanlit
