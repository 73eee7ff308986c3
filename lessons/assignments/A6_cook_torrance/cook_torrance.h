// A6, Cook-Torrance. README.md says what each function is to do; `scanlit check .` says how far you
// are. This file is all that you hand in.
//
// c holds the cosines c.n_l, c.n_v, c.n_h and c.v_h: N.L, N.V, N.H and V.H. T is double or float; a
// number is written T(2), and exp, pow, sqrt, tan, min, max are there.
#pragma once

#include <complex>

#include "answer/model.h"
#include "variant.h"

namespace scanlit {

struct CookTorrance {
  /// The m of the formulas, from variant::roughness.
  static double m() {
    //<< TODO(A6.1) m, from the roughness as it is given.
    const double given = variant::roughness;
    switch (variant::roughness_given_as) {
      case 0: return std::tan(given * std::numbers::pi / 180);
      case 1: return std::sqrt(2 / (given + 2));
      case 2: return std::numbers::sqrt2 * given;
      default: return (1 - given) * (1 - given);
    }
    //== return 0.5;
    //>>
  }

  /// How many facets face H.
  template <class T>
  T D(const Cosines<T>& c, const T& m) const {
    //<< TODO(A6.2) The distribution of facets.
    const T pi(std::numbers::pi), m2 = m * m, c2 = c.n_h * c.n_h;
    const T at_peak = variant::D_is_density ? T(1) / (pi * m2) : T(1);
    if (variant::D == 0) return at_peak * exp(-c.n_h.sin2() / (m2 * c2)) / (c2 * c2);
    if (variant::D == 2) return at_peak * pow(c.n_h, T(2) / m2 - T(2));
    const T below = c.n_h.sin2() + m2 * c2;  // (m^2 - 1) c^2 + 1
    return at_peak * m2 * m2 / (below * below);
    //== return T(1);
    //>>
  }

  /// The share of them that light reaches and the viewer sees.
  template <class T>
  T G(const Cosines<T>& c, const T& m) const {
    //<< TODO(A6.3) Shadowing and masking.
    const auto lambda = [&m](const T& cos) {
      return (sqrt(T(1) + m * m * (T(1) - cos * cos) / (cos * cos)) - T(1)) / T(2);
    };
    if (variant::G == 0) return min(T(1), T(2) * c.n_h * min(c.n_v, c.n_l) / c.v_h);
    if (variant::G == 1) return T(1) / ((T(1) + lambda(c.n_l)) * (T(1) + lambda(c.n_v)));
    if (variant::G == 2) return T(1) / (T(1) + lambda(c.n_l) + lambda(c.n_v));
    return c.n_l * c.n_v / (c.v_h * c.v_h);
    //== return T(1);
    //>>
  }

  /// What a facet mirrors, per channel.
  template <class T>
  Rgb<T> F(const Cosines<T>& c) const {
    //<< TODO(A6.4) Fresnel's reflectance of copper. Which cosine is it a function of?
    if (variant::F == 1) {
      const auto schlick = [&c](double f0) { return T(f0) + T(1 - f0) * pow(T(1) - c.v_h, T(5)); };
      return {schlick(variant::F0.r), schlick(variant::F0.g), schlick(variant::F0.b)};
    }
    const auto exact = [cos = c.v_h](double n, double k) {
      const std::complex<T> eta{T(n), T(k)}, eta2 = eta * eta;
      const std::complex<T> q = std::sqrt(eta2 - T(1) + cos * cos);
      return (std::norm((cos - q) / (cos + q)) + std::norm((eta2 * cos - q) / (eta2 * cos + q))) /
             T(2);
    };
    return {exact(variant::n.r, variant::k.r), exact(variant::n.g, variant::k.g),
            exact(variant::n.b, variant::k.b)};
    //== return Rgb<T>(T(1));
    //>>
  }

  /// D, G and F are given.
  template <class T>
  Rgb<T> product(const T& D, const T& G, const Rgb<T>& F, const Cosines<T>& c) const {
    //<< TODO(A6.5) What is returned, of D, G and F.
    const T k(variant::D_is_density ? 0.25 : 1 / std::numbers::pi);  // f_r = k D G F / (NL NV)
    if (variant::wants_braces) return F * (k * T(std::numbers::pi) * D * G / c.n_v);
    return F * (k * D * G / (c.n_l * c.n_v));
    //== return F * (D * G * c.n_v);
    //>>
  }

  /// The model. Nothing is to be done here.
  template <class T>
  Rgb<T> operator()(const Cosines<T>& c) const {
    const T roughness(m());
    return product(D(c, roughness), G(c, roughness), F(c), c);
  }
};

}  // namespace scanlit
