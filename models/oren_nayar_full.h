// Oren-Nayar, the full model: a rough diffuse surface of V-shaped grooves with Lambertian walls,
// which mask, shadow and light each other.
//
//   rho (N.L) [C1 + cos phi C2 tan B + (1 - |cos phi|) C3 tan((A + B) / 2)]
//     + .17 rho^2 (N.L) s2 / (s2 + .13) [1 - cos phi (2 B / pi)^2]
//
//   C1 = 1 - .5 s2 / (s2 + .33)
//   C2 = .45 s2 / (s2 + .09) (sin A, less (2 B / pi)^3 where cos phi < 0)
//   C3 = .125 s2 / (s2 + .09) (4 A B / pi^2)^2
//
// Michael Oren and Shree K. Nayar, "Generalization of Lambert's reflectance model", SIGGRAPH 1994,
// section 4.3: a fit to integrals over the grooves. rho, sigma, A, B, phi and s2 as in
// oren_nayar.h. The fit dips below 0, by 1e-4, where sigma is large, L and V are both grazing and
// light goes forward: 0 is taken there.
#pragma once

#include <numbers>

#include "models/oren_nayar.h"

namespace scanlit::models {

template <class P = double>
struct OrenNayarFull {
  Rgb<P> rho{0.8};
  P sigma{0.2};

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    const P s2 = sigma * sigma, steep = s2 / (s2 + P(0.09));
    const T c1(P(1) - P(0.5) * s2 / (s2 + P(0.33)));
    const T second_bounce(P(0.17) * s2 / (s2 + P(0.13)));

    const T zero(0), one(1);
    const Cosine<T> cos_a{min(c.n_l, c.n_v), max(c.n_l_versine, c.n_v_versine)};
    const Cosine<T> cos_b{max(c.n_l, c.n_v), min(c.n_l_versine, c.n_v_versine)};
    const T sin_a = sqrt(max(cos_a.sin2(), zero)), sin_b = sqrt(max(cos_b.sin2(), zero));
    const T a = T(2 / std::numbers::pi) * angle(cos_a);  // as shares of a right angle
    const T b = T(2 / std::numbers::pi) * angle(cos_b);

    // Where L or V is the normal, phi is undefined and 0/0 without the bound; whatever it is, it is
    // then multiplied by 0.
    const T sines_cos_phi = projected_l_v(c);
    const T cos_phi = min(max(sines_cos_phi / max(sin_a * sin_b, T(1e-20)), T(-1)), one);

    // Each tangent times N.L, which keeps them finite. tan((A + B) / 2) is
    // (sin A + sin B) / (cos A + cos B), and sin A sin B cos phi is known: cos phi alone, which
    // jumps where L or V is the normal, only weighs what is small there.
    const T n_l_over_b = c.n_l / cos_b.cos;
    const T n_l_tan_mean = c.n_l / (cos_a.cos + cos_b.cos) * (sin_a + sin_b);
    const T forward = sin_b * (b * b * b) * max(-cos_phi, zero);
    const T c2(P(0.45) * steep);
    const T c3 = T(P(0.125) * steep) * (a * b * a * b);

    const T once = c1 * c.n_l + c2 * n_l_over_b * (sines_cos_phi + forward) +
                   (one - abs(cos_phi)) * c3 * n_l_tan_mean;
    const T twice = second_bounce * c.n_l * (one - cos_phi * b * b);
    return {.diffuse = above_zero(rho * once + rho * (rho * twice)), .glossy = {}};
  }

  template <class T>
  static Rgb<T> above_zero(const Rgb<T>& a) {
    return {max(a.r, T(0)), max(a.g, T(0)), max(a.b, T(0))};
  }

  static Description<OrenNayarFull> describe() {
    return {.name = "oren-nayar-full",
            .year = 1994,
            .title = "Oren-Nayar, full, with light between the grooves' walls",
            .source = "Oren and Nayar 1994, Generalization of Lambert's reflectance model",
            .reciprocal = true,
            .energy_bounded = false,
            .parameters = {{"rho", &OrenNayarFull::rho, 0, 1, "albedo of the grooves' walls"},
                           {"sigma", &OrenNayarFull::sigma, 0, std::numbers::pi / 2,
                            "deviation of their slope angle, rad; 0 is Lambert"}},
            .exceptions = "with rho = 1 and sigma = .3 the albedo reaches 1.05 at grazing angles"};
  }
};

inline const Registered<OrenNayarFull<>> oren_nayar_full_registered;

}  // namespace scanlit::models
