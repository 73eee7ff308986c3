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

/// (N.H) to the power of exponent_towards().
template <class T, class P>
T power_towards(const Cosine<T>& n_h, const Vec3<T>& h, const P& ex, const P& ey) {
  return pow(n_h, exponent_towards(h, ex, ey));
}
/// Over bounds without the 0/0: it is exp(-(ex hx^2 + ey hy^2) g) with g = -log(c) / (1 - c^2), c =
/// N.H, which as a power series of u = 1 - c begins with 1/2 and has coefficients of at most 1/2.
template <class P>
Bounded power_towards(const Cosine<Bounded>& n_h, const Vec3<Bounded>& h, const P& ex,
                      const P& ey) {
  const Bounded &u = n_h.versine, x(ex), y(ey);
  const Bounded squares = x * square(h.x) + y * square(h.y);
  const auto g_of = [](const Batch& versine) {
    const Batch v = max(versine, Batch(1e-3f));  // below, rounding of 1 - v would be large
    return -log(max(Batch(1) - v, Batch(1e-20f))) / (v * (Batch(2) - v));
  };
  const Batch c = Batch(1) - u.hi, inverse = Batch(1) / c, least = Batch(0.5f);
  const Batch lo = select(u.lo < Batch(1e-3f), least, g_of(u.lo));
  const Bounded g =
      known_where(c > Batch(0), chain(u, Bounded::rounded_outwards(lo, g_of(u.hi), 2e-4f),
                                      least * inverse * inverse, inverse * inverse * inverse));
  // s'' has the part 2 (ex hx'^2 + ey hy'^2), and s'^2 is at most twice that times s. (s g)'^2 =
  // s'^2 g^2 + 2 s s' g g' + s^2 g'^2, and g is at least 1/2.
  const Batch convex =
      Batch(2) * (x.hi * h.x.slope * h.x.slope + y.hi * h.y.slope * h.y.slope) * g.hi;
  const Batch steepness = Batch(2) * (convex + (squares.slope + squares.hi * g.slope) * g.slope);
  return exp_minus(squares * g, steepness * Batch(Bounded::rounding_slack), convex);
}

template <class P>
struct AshikhminShirley {
  P ex, ey;

  P peak() const { return sqrt((ex + P(2.0)) * (ey + P(2.0))) * P(0.5 * std::numbers::inv_pi); }

  template <class T>
  T operator()(const Cosine<T>& n_h, const Vec3<T>& h) const {
    return T(peak()) * power_towards(n_h, h, ex, ey);
  }

  template <class T>
  T lambda(const T& n_d, const Vec3<T>& d) const {
    const Anisotropic<P> roughness{beckmann_roughness(ex), beckmann_roughness(ey)};
    return beckmann_lambda(roughness.projected_tan2(n_d, d));
  }
};

}  // namespace scanlit::models::microfacet
