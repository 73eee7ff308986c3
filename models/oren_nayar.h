// Oren-Nayar, the qualitative model: a rough diffuse surface, of V-shaped grooves whose walls are
// Lambertian. It is flatter than Lambert's: the limb of the full moon is as bright as its centre.
//
//   rho (N.L) [1 - .5 s2 / (s2 + .33) + .45 s2 / (s2 + .09) max(0, cos phi) sin A tan B]
//
// Michael Oren and Shree K. Nayar, "Generalization of Lambert's reflectance model", SIGGRAPH 1994,
// section 4.4. It is their full model (oren_nayar_full.h) without the terms that matter least.
//
//   rho      albedo of the walls, per channel
//   sigma    standard deviation of the walls' slope angle, rad; s2 = sigma^2. 0 is Lambert
//   A, B     the larger and the smaller of the angles between N and L, N and V
//   phi      the angle between L and V, both projected onto the surface
#pragma once

#include <numbers>

#include "models/formula.h"

namespace scanlit::models {

/// sin A sin B cos phi: the dot product of L and V, both projected onto the surface.
template <class T>
T projected_l_v(const Cosines<T>& c) {
  return T(2) * c.v_h * c.v_h - T(1) - c.n_l * c.n_v;
}

template <class P = double>
struct OrenNayar {
  Rgb<P> rho{0.8};
  P sigma{0.2};

  /// No angle is computed: cos B is the larger of N.L and N.V, and tan B = sin B / cos B. Towards
  /// grazing angles cos B alone would magnify rounding; (N.L) / cos B is never above 1.
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    const P s2 = sigma * sigma;
    const T constant(P(1) - P(0.5) * s2 / (s2 + P(0.33)));
    const T groove(P(0.45) * s2 / (s2 + P(0.09)));
    const T n_l_tan_b = c.n_l / max(c.n_l, c.n_v) * max(T(0), projected_l_v(c));
    return {.diffuse = rho * (constant * c.n_l + groove * n_l_tan_b), .glossy = {}};
  }

  static Description<OrenNayar> describe() {
    return {.name = "oren-nayar",
            .year = 1994,
            .title = "Oren-Nayar, qualitative",
            .source = "Oren and Nayar 1994, Generalization of Lambert's reflectance model",
            .reciprocal = true,
            .energy_bounded = false,
            .parameters = {{"rho", &OrenNayar::rho, 0, 1, "albedo of the grooves' walls"},
                           {"sigma", &OrenNayar::sigma, 0, std::numbers::pi / 2,
                            "deviation of their slope angle, rad; 0 is Lambert"}},
            .exceptions = "with rho = 1 and sigma = .2 the albedo reaches 1.015 at grazing angles"};
  }
};

inline const Registered<OrenNayar<>> oren_nayar_registered;

}  // namespace scanlit::models
