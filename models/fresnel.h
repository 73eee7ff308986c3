// Fresnel reflectance F(V.H): the share of light that a microfacet mirrors, per channel.
//
//   ConductorFresnel   exact, of eta + i k      Fresnel's equations with a complex index: Max Born
//   DielectricFresnel  exact, of eta            and Emil Wolf, Principles of Optics, 1.5.2 and 14.2
//   SchlickFresnel     F0 + (1 - F0)(1 - c)^5   Christophe Schlick, "An inexpensive BRDF model for
//                                               physically-based rendering", Eurographics 1994
//   UnitFresnel        1                        to see a model without it
//
// Each is a function of c = V.H in [0, 1], the cosine of the angle of incidence on the microfacet,
// and gives F in [0, 1]: 1 at grazing (c = 0), whatever the material. Light is unpolarised: F is
// the mean of the reflectances of its two polarisations, perpendicular (s) and parallel (p) to the
// plane of incidence. eta and k are relative to the medium outside. For metals by name see
// metals.h; for how fragments are drawn of a conductor that is the same everywhere,
// conductor_fit.h.
//
// P is the parameters' type: double where a parameter is constant, else the formula's own T.
#pragma once

#include "rasterizer/batch.h"
#include "rasterizer/scalar_math.h"
#include "rasterizer/vec.h"

namespace scanlit::models {

/// The mean of the two polarisations' reflectances, from q = N cos(theta_t) = re + i im:
///
///   r_s = (c - q) / (c + q)    |r_p / r_s|^2 = (t - u) / (t + u)    t = c^2 |q|^2 + sin^4(theta_i)
///                                                                   u = 2 c re sin^2(theta_i)
///
/// so that F = |r_s|^2 t / (t + u): one division. minus is c - re: the caller knows whether that
/// loses digits, and what else to take.
template <class T>
T unpolarised(const T& c, const T& re, const T& im2, const T& minus) {
  const T plus = c + re, sin2 = (T(1) - c) * (T(1) + c);
  const T t = mul_add(c * c, mul_add(re, re, im2), sin2 * sin2);
  const T t_plus_u = mul_add(T(2) * c * sin2, re, t);
  // Both are 0 at grazing where q is 0 too: within the denser of two media, and where there is no
  // surface (eta = 1, k = 0). The bound turns 0/0 into 1, the limit of every other index.
  const T bound(1e-30);
  const T numerator = mul_add(minus, minus, im2 + bound) * t;
  return min(numerator / (mul_add(plus, plus, im2 + bound) * t_plus_u), T(1));
}

/// eta and k from 0 to 1e6, not both 0. At normal incidence
/// ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2). Maximum error in float where eta >= 1 or
/// eta k >= .01: 1e-6, absolute; for other values as below.
template <class T>
T conductor_reflectance(const T& c, const T& eta, const T& k) {
  // q^2 = N^2 - sin^2(theta_i) = t + 2 i eta k. eta^2 - 1 is factored because it cancels where eta
  // is near 1.
  const T t = (eta - T(1)) * (eta + T(1)) - k * k + c * c, eta_k = eta * k;
  // Of q's two parts only the larger is taken from the sum under the root, where nothing cancels;
  // the other follows from 2 Re(q) Im(q) = 2 eta k. (Where q = 0 so is eta k: the bound on 0/0.)
  const T larger = sqrt(T(0.5) * (sqrt(t * t + T(4) * eta_k * eta_k) + abs(t)));
  const T smaller = eta_k / max(larger, T(1e-30));
  const T re = select(t > T(0), larger, smaller), im = select(t > T(0), smaller, larger);
  return unpolarised(c, re, im * im, c - re);
}

/// The same for k = 0, eta from 1e-3 to 1e6. If eta < 1 (light leaves the denser medium), q is
/// imaginary where c^2 < 1 - eta^2, and reflection is total: 1. Maximum error in float: 2e-6,
/// absolute, and 2e-5 of F, however small it is; close to the critical angle, where F falls from 1
/// with infinite slope, what rounding of c and eta makes of it.
template <class T>
T dielectric_reflectance(const T& c, const T& eta) {
  const T eta2_minus_1 = (eta - T(1)) * (eta + T(1));
  const T q = sqrt(max(eta2_minus_1 + c * c, T(0)));
  // c - q from c^2 - q^2: where eta is near 1, c and q are nearly equal, and a narrow lobe makes
  // much of what little is mirrored. (Where reflection is total, this is more than c, so F is 1.)
  const T minus = -eta2_minus_1 / max(c + q, T(1e-15));
  return unpolarised(c, q, T(0), minus);
}

template <class P = double>
struct ConductorFresnel {
  Rgb<P> eta{P(1.0)}, k{P(0.0)};

  template <class T>
  Rgb<T> operator()(const T& v_h) const {
    return {conductor_reflectance(v_h, T(eta.r), T(k.r)),
            conductor_reflectance(v_h, T(eta.g), T(k.g)),
            conductor_reflectance(v_h, T(eta.b), T(k.b))};
  }
};

template <class P = double>
struct DielectricFresnel {
  Rgb<P> eta{P(1.5)};

  template <class T>
  Rgb<T> operator()(const T& v_h) const {
    return {dielectric_reflectance(v_h, T(eta.r)), dielectric_reflectance(v_h, T(eta.g)),
            dielectric_reflectance(v_h, T(eta.b))};
  }
};

template <class P = double>
struct SchlickFresnel {
  Rgb<P> f0{P(0.04)};  // F at normal incidence

  template <class T>
  Rgb<T> operator()(const T& v_h) const {
    const T d = T(1) - v_h, d2 = d * d;
    const Rgb<T> one(T(1)), f = f0 * one;
    return f + (one - f) * (d2 * d2 * d);
  }
};

struct UnitFresnel {
  template <class T>
  Rgb<T> operator()(const T&) const {
    return Rgb<T>(T(1));
  }
};

}  // namespace scanlit::models
