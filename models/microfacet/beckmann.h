// Beckmann's distribution: slopes that are normally distributed, as of a random rough surface.
//
//   D = exp(-tan^2(alpha) / m^2) / (pi m^2 (N.H)^4)        tan^2(alpha) = (1 - (N.H)^2) / (N.H)^2
//
// Petr Beckmann, Andre Spizzichino, "The Scattering of Electromagnetic Waves from Rough Surfaces",
// 1963; in graphics since Cook and Torrance 1982, who print it without the pi. Anisotropic, in
// place of tan^2(alpha) / m^2, tan^2(alpha) (cos^2(phi) / ax^2 + sin^2(phi) / ay^2): Eric Heitz,
// "Understanding the masking-shadowing function in microfacet-based BRDFs", JCGT 3(2), 2014.
#pragma once

#include <numbers>

#include "models/microfacet/error_function.h"
#include "models/microfacet/roughness.h"

namespace scanlit::models::microfacet {

/// Smith's Lambda of a Beckmann surface, from (m tan(theta))^2. With a = 1 / (m tan(theta)):
///
///   (exp(-a^2) / (a sqrt(pi)) - erfc(a)) / 2
///
/// Exact; in Batch 1 / (1 + Lambda) is within 5e-7, the error of erfc. Widely used instead is the
/// rational approximation of Walter et al. 2007, section 5.2, off by up to .35 %.
template <class T>
T beckmann_lambda(const T& projected_tan2) {
  const T m_tan = sqrt(max(projected_tan2, T(1e-24)));  // 0 along N, where a would be infinite
  const T a = T(1) / m_tan;
  const T lambda = exp(-(a * a)) * T(std::numbers::inv_sqrtpi) * m_tan - erfc(a);
  return max(T(0.5) * lambda, T(0));  // a difference of nearly equal numbers where a is large
}

/// exp(-sin2 / (m^2 cos^2)) / cos^4 of an isotropic surface over bounds: of e^-kt (1 + t)^2, t =
/// tan^2 = 1/cos^2 - 1, whose two factors grow against each other. With r = cos^2 the derivatives
/// are 2r - k and 2r^2 - 4rk + k^2 times it; k >= 1, up to which they are monotonic in r.
inline Bounded normal_slopes(const Cosine<Bounded>& n_h, const Batch& k) {
  const Bounded& u = n_h.versine;
  const Batch from = max(u.lo, Batch(0)), one(1), two(2);
  const Batch c0 = one - from, c1 = one - u.hi, i0 = one / c0, i1 = one / c1;
  const Batch r0 = c0 * c0, r1 = c1 * c1, t0 = from * (two - from) * i0 * i0,
              t1 = u.hi * (two - u.hi) * i1 * i1;
  const Bounded t =
      chain(u, Bounded(t0, t1, 0, 0), two * i1 * i1 * i1, Batch(6) * i1 * i1 * i1 * i1);
  const auto value = [&](const Batch& tan2, const Batch& inverse) {
    return exp(-k * tan2) * inverse * inverse * inverse * inverse;
  };
  const Batch a = value(t0, i0), b = value(t1, i1);
  // It grows at first where k < 2, up to r = k/2.
  const Batch top = select(k < two, Batch(4) / (k * k) * exp(k - two), Batch(0));
  const Batch hi = max(max(a, b), top);
  const auto first = [&](const Batch& r) { return abs(two * r - k); };
  const auto second = [&](const Batch& r) { return abs((two * r - Batch(4) * k) * r + k * k); };
  const Bounded all = Bounded::rounded_outwards(min(a, b), hi, mul_add(k * t1, 1e-6f, 2e-6f));
  return known_where(c1 > Batch(1e-3f), chain(t, all, hi * max(first(r0), first(r1)),
                                              hi * max(second(r0), second(r1))));
}

template <class Roughness>
struct Beckmann {
  Roughness roughness;

  auto peak() const { return roughness.peak(); }

  template <class T>
  T operator()(const Cosine<T>& n_h, const Vec3<T>& h) const {
    if constexpr (std::is_same_v<T, Bounded> && requires { roughness.m; })
      return T(peak()) * normal_slopes(n_h, Batch(1 / (roughness.m * roughness.m)));
    // At N.H = 0, 0/0 without the bound. There exp(-1e12) makes 0 of it all.
    const T cos2 = max(n_h.cos * n_h.cos, T(1e-12));
    const T inverse = reciprocal(cos2);
    return T(peak()) * exp(-roughness.scaled_sin2(n_h, h) * inverse) * (inverse * inverse);
  }

  template <class T>
  T lambda(const T& n_d, const Vec3<T>& d) const {
    return beckmann_lambda(roughness.projected_tan2(n_d, d));
  }
};

}  // namespace scanlit::models::microfacet
