// Finished wood: fibres below a clear coat. Some light is mirrored by the coat. What enters it is
// scattered by the body of the wood in all directions, and by the fibres into a cone about each: a
// broad highlight that lies where the fibres point, and that travels over a board whose fibres
// wave.
//
//   f = ks D G F / (4 (N.L)(N.V)) + T(L) T(V) (kd / pi + kf g(beta, psi_h) / cos^2(psi_d / 2))
//
// Stephen R. Marschner, Stephen H. Westin, Adam Arbree, Jonathan T. Moon, "Measuring and modeling
// the appearance of finished wood", SIGGRAPH 2005, section 4.
//
//   u      the fibre's axis in the shading frame: (1, 0, 0) lies along the tangent; z != 0 tilts it
//          out of the surface, and the highlight with it
//   s(W)   W refracted into the coat: (Wx / eta, Wy / eta, sqrt(1 - (Wx^2 + Wy^2) / eta^2))
//   psi    the angle from the plane across the fibre: psi_l = asin(s(L).u), psi_v = asin(s(V).u)
//   psi_h  psi_v + psi_l: 0 on the cone into which a smooth fibre would mirror
//   psi_d  psi_v - psi_l
//   g      normal distribution of standard deviation beta: exp(-psi_h^2 / (2 beta^2)) /
//          (beta sqrt(2 pi)), in 1/rad
//   T      1 - F(N.W), Fresnel's transmittance of the coat, index eta
//   D G F  the coat's rough surface (models/coat.h), GGX of roughness a; which one the paper leaves
//          open
//   kd     albedo of the wood's body under the coat; the factor 1 / pi is this project's, the paper
//          does not settle it
//   kf     the fibres' colour times strength; no albedo: at psi_h = psi_d = 0 a model returns
//          kf sqrt(pi / 2) / beta for it
//
// Light that the wood sends back and the coat's inner side reflects is lost: the model is darker
// than wood. The paper has no factor 1 / eta^2, which a diffuser under a smooth coat would have:
// kd and kf are what the surface shows through the coat.
#pragma once

#include <numbers>

#include "models/coat.h"
#include "models/formula.h"

namespace scanlit::models {

template <class P = double>
struct FinishedWood {
  Rgb<P> kd{P(0.35), P(0.2), P(0.1)};
  Rgb<P> kf{P(0.08), P(0.055), P(0.03)};
  Vec3<P> u{P(1), P(0), P(0)};  // unit
  P beta{0.17};
  P eta{1.5};
  Rgb<P> ks{P(1.0)};
  P a{0.15};

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    const Coat<P> coat{eta, a};
    const Fibre<T> l = seen_from_fibre(f.l, coat.refracted_cosine(c.n_l));
    const Fibre<T> v = seen_from_fibre(f.v, coat.refracted_cosine(c.n_v));

    const P width = P(1) / beta;
    const P g_0 = width * P(1 / std::sqrt(2 * std::numbers::pi));
    const T x = (v.psi + l.psi) * T(width);
    const T g = T(g_0) * exp(T(-0.5) * x * x);
    // cos^2(psi_d / 2) = (1 + cos(psi_d)) / 2. Inside the coat two directions are at most
    // 2 asin(1 / eta) apart, hence it is at least 1 - 1 / eta^2: no 0, and nothing cancels.
    const T cos2_half_d = T(0.5) * (T(1) + v.cos * l.cos + v.sin * l.sin);

    const T through = coat.transmittance(c.n_l) * coat.transmittance(c.n_v) * c.n_l;
    return {.diffuse = kd * through,
            .glossy = kf * (through * T(std::numbers::pi) * g / cos2_half_d) + ks * coat.glossy(c)};
  }

  /// A direction inside the coat, seen from the fibre: the angle psi, its sine and cosine.
  template <class T>
  struct Fibre {
    T psi, sin, cos;
  };
  /// w is refracted; z is its cosine with the normal inside.
  template <class T>
  Fibre<T> seen_from_fibre(const Vec3<T>& w, const T& z) const {
    const T inverse(P(1) / eta);
    const Vec3<T> s{w.x * inverse, w.y * inverse, z}, axis{T(u.x), T(u.y), T(u.z)};
    // asin has an infinite slope where s points along the fibre, and magnifies the rounding of s.u;
    // the angle by its sine and cosine does not.
    const Vec3<T> across = cross(s, axis);
    const T sine = dot(s, axis), cosine = sqrt(dot(across, across));
    return {.psi = atan2(sine, cosine), .sin = sine, .cos = cosine};
  }

  static Description<FinishedWood> describe() {
    return {
        .name = "finished-wood",
        .year = 2005,
        .title = "Finished wood: fibres under a coat",
        .source =
            "Marschner, Westin, Arbree, Moon 2005, Measuring and modeling the appearance of "
            "finished wood, SIGGRAPH, section 4",
        .reciprocal = true,
        .energy_bounded = false,
        .parameters = {{"kd", &FinishedWood::kd, 0, 1, "albedo of the wood under the coat"},
                       {"kf", &FinishedWood::kf, 0, 1, "strength of the fibres' highlight"},
                       {"u", &FinishedWood::u, "axis of the fibres"},
                       {"beta", &FinishedWood::beta, 0.05, 1,
                        "width of the fibres' cone, a standard deviation in radians"},
                       {"eta", &FinishedWood::eta, 1.05, 3, "refractive index of the coat"},
                       {"ks", &FinishedWood::ks, 0, 1, "factor of the coat's own reflection"},
                       {"a", &FinishedWood::a, 0.01, 1, "roughness of the coat's surface (GGX)"}},
        .exceptions = "not bounded in energy for large kf"};
  }
};

inline const Registered<FinishedWood<>> finished_wood_registered;

}  // namespace scanlit::models
