// Blinn-Phong: the glossy term on the angle between the normal and the half vector.
//
//   Kd (N.L) + Ks (N.H)^n        H = (L + V) / |L + V|
//
// James F. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977.
// The lecture's form: no factor N.L on the glossy term, and not energy-normalised.
//
//   kd   Kd, diffuse reflectance per channel
//   ks   Ks, glossy reflectance per channel
//   n    the exponent: larger is a smaller, sharper highlight; 4 times Phong's gives one about as
//        wide, because N and H enclose half of R's and V's angle
#pragma once

#include "models/formula.h"

namespace scanlit::models {

struct BlinnPhong {
  Rgb<double> kd{0.6};
  Rgb<double> ks{0.4};
  double n = 50;

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    return {.diffuse = kd * c.n_l, .glossy = ks * pow(c.n_h, n)};
  }

  static Description<BlinnPhong> describe() {
    return {.name = "blinn-phong",
            .title = "Blinn-Phong (N.H)",
            .source = "Blinn 1977, Models of light reflection for computer synthesized pictures",
            .reciprocal = false,
            .energy_bounded = false,
            .parameters = {{"kd", &BlinnPhong::kd, 0, 1, "diffuse reflectance"},
                           {"ks", &BlinnPhong::ks, 0, 1, "glossy reflectance"},
                           {"n", &BlinnPhong::n, 0, 1e5, "exponent of N.H"}}};
  }
};

inline const Registered<BlinnPhong> blinn_phong_registered;

}  // namespace scanlit::models
