// Blinn-Phong as a first program has it, in float or double.
#pragma once

#include <algorithm>
#include <cmath>

#include "rasterizer/vec.h"

namespace scanlit::studio {

/// Kd (N.L) + Ks (N.H)^n, where N.H is the dot product: near 1 it has lost digits, which a large n
/// shows. (The engine's cosines.h has not.)
struct ByHand {
  Rgb<double> kd;
  double ks, n;
  // In place of the power, t / (n - n t + t): Christophe Schlick, "A fast alternative to Phong's
  // specular model", Graphics Gems IV, 1994.
  bool fast_power = false;

  template <class T>
  Rgb<T> operator()(const Vec3<T>& normal, const Vec3<T>& l, const Vec3<T>& v) const {
    const T n_l = dot(normal, l);
    if (!(n_l > 0)) return {};
    const Vec3<T> s = l + v;
    const T n_h = std::max(dot(normal, s) / std::sqrt(dot(s, s)), T(0)), exponent(n);
    const T lobe = fast_power ? n_h / (exponent - exponent * n_h + n_h) : std::pow(n_h, exponent);
    return kd * n_l + Rgb<T>(T(ks) * lobe);
  }
};

}  // namespace scanlit::studio
