// ConductorFit: ConductorFresnel (fresnel.h) of constants, without the square roots.
//
// The roots are in q = sqrt(N^2 - sin^2(theta_i)), N = eta + i k, which over the angles of
// incidence hardly changes where |N| is large, as it is in metals. So
//
//   Re(q)   = a polynomial in c^2 of degree 4, c = V.H
//   Im(q)^2 = Re(q)^2 - Re(q^2), where Re(q^2) = eta^2 - 1 - k^2 + c^2
//
// and the rest is exact. It takes a third of the exact formula's time. How far it is off is seen
// when it is fitted: of random eta from 0 to 6 and k from 0 to 10, 97 % are within `tolerance`. The
// others bend too much: k near 0, and eta near or below 1. Those are not to be drawn by it.
#pragma once

#include "models/fresnel.h"
#include "models/polynomial.h"

namespace scanlit::models {

class ConductorFit {
 public:
  /// Of F, in each channel.
  static constexpr double tolerance = 1e-6;

  ConductorFit() = default;
  ConductorFit(const Rgb<double>& eta, const Rgb<double>& k)
      : red_(eta.r, k.r), green_(eta.g, k.g), blue_(eta.b, k.b) {}

  /// Whether it is within `tolerance` of ConductorFresnel, in double; in float 1e-6 are added.
  bool close() const { return red_.close && green_.close && blue_.close; }

  template <class T>
  Rgb<T> operator()(const T& v_h) const {
    return {red_.reflectance(v_h), green_.reflectance(v_h), blue_.reflectance(v_h)};
  }

 private:
  struct Channel {
    float re_q2_at_grazing = 0;
    Polynomial<5> re_q{};  // of c^2
    bool close = false;

    Channel() = default;
    Channel(double eta, double k);

    template <class T>
    T reflectance(const T& c) const {
      const T c2 = c * c, re = value_at(c2, re_q);
      const T im2 = max(mul_add(re, re, -(T(re_q2_at_grazing) + c2)), T(0));
      return unpolarised(c, re, im2, c - re);
    }
  };
  Channel red_, green_, blue_;
};

}  // namespace scanlit::models
