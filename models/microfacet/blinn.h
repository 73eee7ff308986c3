// Distributions that are powers of N.H.
//
//   Blinn               D = (n+2)/(2 pi) (N.H)^n
//   Ashikhmin-Shirley   D = sqrt((ex+2)(ey+2))/(2 pi) (N.H)^((ex hx^2 + ey hy^2) / (1 - (N.H)^2))
//
// James F. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977.
// Michael Ashikhmin, Peter Shirley, "An anisotropic Phong BRDF model", Journal of Graphics Tools
// 5(2), 2000; normalised as a D: Matt Pharr, Greg Humphreys, "Physically Based Rendering", 2004,
// section 9.4.
//
// Smith's Lambda of them has no closed form. Beckmann's of equal width stands in, m = sqrt(2 /
// (n+2)), as in Walter et al. 2007, section 5.2: m = 1 where n = 0. It hides too few of the facets
// of a broad lobe from grazing light: with smith-correlated and F = 1 the albedo at 89.8 degrees is
// 1.74 for n = 0, 1.03 for n = 20, 1.002 for n = 100.
#pragma once

#include <numbers>

#include "models/microfacet/beckmann.h"

namespace scanlit::models::microfacet {

template <class P>
P beckmann_roughness(const P& exponent) {
  return sqrt(P(2.0) / (exponent + P(2.0)));
}

template <class P>
struct Blinn {
  P n;

  P peak() const { return (n + P(2.0)) * P(0.5 * std::numbers::inv_pi); }

  template <class T>
  T operator()(const Cosine<T>& n_h, const Vec3<T>&) const {
    return T(peak()) * pow(n_h, T(n));
  }

  template <class T>
  T lambda(const T& n_d, const Vec3<T>& d) const {
    return beckmann_lambda(Isotropic<P>{beckmann_roughness(n)}.projected_tan2(n_d, d));
  }
};

/// (ex hx^2 + ey hy^2) / (1 - hz^2), the exponent in the azimuth of h. 1 - hz^2 is taken as
/// hx^2 + hy^2, which does not cancel near the normal; at h = N, where the exponent is 0/0 without
/// the bound, the power is 1 whatever it is.
template <class T, class P>
T exponent_towards(const Vec3<T>& h, const P& ex, const P& ey) {
  const T x2 = h.x * h.x, y2 = h.y * h.y;
  return (T(ex) * x2 + T(ey) * y2) / max(x2 + y2, T(1e-30));
}

template <class P>
struct AshikhminShirley {
  P ex, ey;

  P peak() const { return sqrt((ex + P(2.0)) * (ey + P(2.0))) * P(0.5 * std::numbers::inv_pi); }

  template <class T>
  T operator()(const Cosine<T>& n_h, const Vec3<T>& h) const {
    return T(peak()) * pow(n_h, exponent_towards(h, ex, ey));
  }

  template <class T>
  T lambda(const T& n_d, const Vec3<T>& d) const {
    const Anisotropic<P> roughness{beckmann_roughness(ex), beckmann_roughness(ey)};
    return beckmann_lambda(roughness.projected_tan2(n_d, d));
  }
};

}  // namespace scanlit::models::microfacet
