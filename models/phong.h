// Phong: the glossy term on the angle between the mirror direction and the viewer.
//
//   Kd (N.L) + Ks (R.V)^n        R = 2 (N.L) N - L
//
// Bui Tuong Phong, "Illumination for computer generated pictures", CACM 18(6), 1975. The lecture's
// form: no factor N.L on the glossy term.
//
//   kd   Kd, diffuse reflectance per channel
//   ks   Ks, glossy reflectance per channel
//   n    the exponent: larger is a smaller, sharper highlight
#pragma once

#include "models/formula.h"

namespace scanlit::models {

template <class P = double>
struct Phong {
  Rgb<P> kd{0.6};
  Rgb<P> ks{0.4};
  P n{50};

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    return {.diffuse = kd * c.n_l, .glossy = ks * pow(r_v(c), n)};
  }

  /// R.V from the four cosines. R - V = 2 (N.L) N - (L + V), split along and across N, gives
  /// 1 - R.V = 2 (V.H)^2 sin^2(N,H) + (N.L - N.V)^2 / 2: a sum of squares, exact where
  /// 2 (N.L) (N.V) - L.V would cancel. N.V is the clamped one: closer to the silhouette than that,
  /// R.V is that of the clamp.
  template <class T>
  static Cosine<T> r_v(const Cosines<T>& c) {
    const T d = c.n_l - c.n_v;
    return Cosine<T>::of_versine(T(2) * c.v_h * c.v_h * c.n_h.sin2() + T(0.5) * d * d);
  }

  static Description<Phong> describe() {
    return {.name = "phong",
            .year = 1975,
            .title = "Phong (R.V)",
            .source = "Phong 1975, Illumination for computer generated pictures, CACM 18(6)",
            .reciprocal = false,
            .energy_bounded = false,
            .parameters = {{"kd", &Phong::kd, 0, 1, "diffuse reflectance"},
                           {"ks", &Phong::ks, 0, 1, "glossy reflectance"},
                           {"n", &Phong::n, 0, 1e5, "exponent of R.V"}}};
  }
};

inline const Registered<Phong<>> phong_registered;

}  // namespace scanlit::models
