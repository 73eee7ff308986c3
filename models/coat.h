// A clear coat's own optics: varnish on wood, glaze, the clear layer of car paint. It mirrors some
// of the light, and refracts what enters.
//
//   glossy   D G F / (4 (N.L) (N.V)), as in models/microfacet/microfacet.h: GGX, Smith's
//            height-correlated G, F(V.H) of a dielectric
//   T        1 - F(N.W): what enters, taken as through a smooth coat, however rough it is
//   N.W'     sqrt(1 - (1 - (N.W)^2) / eta^2), the refracted direction's cosine: Snell's law
//
//   eta      the coat's index of refraction, at least 1
//   a        roughness of its surface (models/microfacet/ggx.h)
#pragma once

#include <numbers>

#include "models/fresnel.h"
#include "models/microfacet/ggx.h"
#include "models/microfacet/masking.h"

namespace scanlit::models {

template <class P = double>
struct Coat {
  P eta, a;

  /// pi f (N.L) of the coat's surface.
  template <class T>
  T glossy(const Cosines<T>& c) const {
    const microfacet::Ggx<microfacet::Isotropic<P>> facets{{a}};
    const Vec3<T> any{};  // an isotropic surface looks the same from all sides
    const T D = facets(c.n_h, any);
    const T G = microfacet::smith_correlated(facets.lambda(c.n_l, any), facets.lambda(c.n_v, any));
    const T F = dielectric_reflectance(c.v_h, T(eta));
    return T(std::numbers::pi / 4) * D * G * F / c.n_v;
  }

  template <class T>
  T transmittance(const T& n_w) const {
    return T(1) - dielectric_reflectance(n_w, T(eta));
  }

  /// N.W' of N.W. Written as a sum, which neither a grazing W nor eta near 1 makes cancel.
  template <class T>
  T refracted_cosine(const T& n_w) const {
    return sqrt(T((eta - P(1)) * (eta + P(1))) + n_w * n_w) * T(P(1) / eta);
  }
};

}  // namespace scanlit::models
