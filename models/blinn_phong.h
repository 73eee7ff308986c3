// Blinn-Phong: the glossy term on the angle between the normal and the half vector.
//
//   Kd (N.L) + Ks (N.H)^n        H = (L + V) / |L + V|
//
// James F. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977.
// The lecture's form has no factor N.L on the glossy term and is not energy-normalised. With
// normalised=1 the glossy term is pi f_r (N.L) of the f_r whose albedo at normal incidence is Ks:
//
//   Ks (n+2)(n+4) / (8 (2^(-n/2) + n)) (N.H)^n (N.L)
//
// Fabian Giesen, "Phong and Blinn-Phong normalization factors", 2009; in Akenine-Moller, Haines,
// Hoffman, "Real-Time Rendering", 3rd ed., 2008, section 7.6 it is approximated by (n+8)/8.
//
//   kd   Kd, diffuse reflectance per channel
//   ks   Ks, glossy reflectance per channel
//   n    the exponent: larger is a smaller, sharper highlight; 4 times Phong's gives one about as
//        wide, because N and H enclose half of R's and V's angle
#pragma once

#include <numbers>

#include "models/formula.h"

namespace scanlit::models {

template <class P = double>
struct BlinnPhong {
  Rgb<P> kd{0.6};
  Rgb<P> ks{0.4};
  P n{50};
  int normalised = 0;

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    const T scale = normalised ? T(normalisation(n)) * c.n_l : T(1);
    return {.diffuse = kd * c.n_l, .glossy = ks * (scale * pow(c.n_h, n))};
  }

  static P normalisation(const P& n) {
    const P two_to_minus_half_n = exp(n * P(-0.5 * std::numbers::ln2));
    return (n + P(2)) * (n + P(4)) / (P(8) * (two_to_minus_half_n + n));
  }

  static Description<BlinnPhong> describe() {
    return {.name = "blinn-phong",
            .year = 1977,
            .title = "Blinn-Phong (N.H)",
            .source = "Blinn 1977, Models of light reflection for computer synthesized pictures",
            .reciprocal = false,
            .energy_bounded = false,
            .parameters = {{"kd", &BlinnPhong::kd, 0, 1, "diffuse reflectance"},
                           {"ks", &BlinnPhong::ks, 0, 1, "glossy reflectance"},
                           {"n", &BlinnPhong::n, 0, 1e5, "exponent of N.H"},
                           {"normalised",
                            &BlinnPhong::normalised,
                            {"0", "1"},
                            "1: energy-normalised, with the factor N.L"}}};
  }
};

inline const Registered<BlinnPhong<>> blinn_phong_registered;

}  // namespace scanlit::models
