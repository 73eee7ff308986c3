// Lambert: ideal diffuse reflection.
//
//   Kd (N.L)
//
// Johann Heinrich Lambert, Photometria, 1760; as the diffuse term of Bui Tuong Phong, "Illumination
// for computer generated pictures", CACM 18(6), 1975.
//
//   kd   Kd, the diffuse reflectance (albedo) per channel
#pragma once

#include "models/formula.h"

namespace scanlit::models {

template <class P = double>
struct Lambert {
  Rgb<P> kd{0.8};

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    return {.diffuse = kd * c.n_l, .glossy = {}};
  }

  static Description<Lambert> describe() {
    return {.name = "lambert",
            .year = 1760,
            .title = "Lambert (ideal diffuse)",
            .source = "Lambert 1760, Photometria",
            .reciprocal = true,
            .energy_bounded = true,
            .parameters = {{"kd", &Lambert::kd, 0, 1, "diffuse reflectance"}}};
  }
};

inline const Registered<Lambert<>> lambert_registered;

}  // namespace scanlit::models
