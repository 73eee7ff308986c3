// GGX, or the Trowbridge-Reitz distribution: the surface of an ellipsoid, cut up. Its lobe has a
// long tail, like that of many polished and ground surfaces.
//
//   D = a^2 / (pi ((a^2 - 1) (N.H)^2 + 1)^2) = 1 / (pi a^2 ((N.H)^2 + sin^2(alpha) / a^2)^2)
//
// T. S. Trowbridge, K. P. Reitz, "Average irregularity representation of a rough surface for ray
// reflection", JOSA 65(5), 1975; Bruce Walter et al., "Microfacet models for refraction through
// rough surfaces", EGSR 2007, eq. 33. Written in the second form, a sum of squares, because in the
// first (a^2 - 1) (N.H)^2 + 1 cancels where the lobe is. Anisotropic: Brent Burley,
// "Physically-based shading at Disney", 2012, with (hx / ax)^2 + (hy / ay)^2.
#pragma once

#include "models/microfacet/roughness.h"

namespace scanlit::models::microfacet {

template <class Roughness>
struct Ggx {
  Roughness roughness;

  auto peak() const { return roughness.peak(); }

  template <class T>
  T operator()(const Cosine<T>& n_h, const Vec3<T>& h) const {
    const T sum = n_h.cos * n_h.cos + roughness.scaled_sin2(n_h, h);
    return T(peak()) / (sum * sum);
  }

  /// Smith's, exact: (-1 + sqrt(1 + (a tan(theta))^2)) / 2.
  template <class T>
  T lambda(const T& n_d, const Vec3<T>& d) const {
    return T(0.5) * (sqrt(T(1) + roughness.projected_tan2(n_d, d)) - T(1));
  }
};

}  // namespace scanlit::models::microfacet
