// Ashikhmin-Shirley: an anisotropic glossy lobe, and under it a diffuse part that gets the light
// which the glossy one leaves.
//
//   fs = sqrt((nu + 1)(nv + 1)) / (8 pi) (N.H)^e F(V.H) / ((V.H) max(N.L, N.V))
//   fd = 28 Rd / (23 pi) (1 - Rs) (1 - (1 - N.L / 2)^5) (1 - (1 - N.V / 2)^5)
//   e  = nu cos^2 phi + nv sin^2 phi              F(c) = Rs + (1 - Rs) (1 - c)^5
//
// Michael Ashikhmin and Peter Shirley, "An anisotropic Phong BRDF model", Journal of Graphics Tools
// 5(2), 2000, eqs. 4 and 5. What is returned is pi (fs + fd) (N.L).
//
//   rd, rs   Rd, Rs: diffuse reflectance, glossy reflectance at normal incidence, per channel
//   nu, nv   exponents along the tangent and the bitangent: the smaller one draws the highlight out
//   phi      the angle between the tangent and H, projected onto the surface
//
// The lobe's integral over half vectors is 1 at most, because (N.L) / max(N.L, N.V) is: the model
// reflects no more light than it gets, for any parameters.
#pragma once

#include "models/formula.h"
#include "models/microfacet/blinn.h"

namespace scanlit::models {

template <class P = double>
struct AshikhminShirley {
  Rgb<P> rd{0.4};
  Rgb<P> rs{0.2};
  P nu{20};
  P nv{500};

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    const T one(1);
    // N.H is at most 1, so V.H = (N.L + N.V) / (2 N.H) is at least (N.L) / 2: also where l = -v
    // and what rounding leaves of V.H is 0.
    const T v_h = max(c.v_h, T(0.5) * c.n_l);
    const T lobe = T(sqrt((nu + P(1)) * (nv + P(1))) * P(0.125)) *
                   microfacet::power_towards(c.n_h, f.h, nu, nv);
    const Rgb<T> reflectance = rs * one;
    const Rgb<T> fresnel = reflectance + (Rgb<T>(one) - reflectance) * power5(one - v_h);
    const Rgb<T> transmitted = rd * (Rgb<T>(one) - reflectance);
    const auto entering = [&](const T& n_d) { return one - power5(one - T(0.5) * n_d); };
    return {.diffuse = transmitted * (T(28.0 / 23) * entering(c.n_l) * entering(c.n_v) * c.n_l),
            .glossy = fresnel * (lobe * c.n_l / (v_h * max(c.n_l, c.n_v)))};
  }

  template <class T>
  static T power5(const T& x) {
    const T x2 = x * x;
    return x2 * x2 * x;
  }

  static Description<AshikhminShirley> describe() {
    return {.name = "ashikhmin-shirley",
            .year = 2000,
            .title = "Ashikhmin-Shirley, anisotropic",
            .source = "Ashikhmin and Shirley 2000, An anisotropic Phong BRDF model",
            .reciprocal = true,
            .energy_bounded = true,
            .parameters = {
                {"rd", &AshikhminShirley::rd, 0, 1, "diffuse reflectance"},
                {"rs", &AshikhminShirley::rs, 0, 1, "glossy reflectance at normal incidence"},
                {"nu", &AshikhminShirley::nu, 0, 1e5, "exponent along the tangent"},
                {"nv", &AshikhminShirley::nv, 0, 1e5, "exponent along the bitangent"}}};
  }
};

inline const Registered<AshikhminShirley<>> ashikhmin_shirley_registered;

}  // namespace scanlit::models
