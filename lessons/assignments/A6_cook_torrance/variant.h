// Your variant, as README.md states it, as constants.
#pragma once

#include "rasterizer/vec.h"

namespace scanlit::variant {

constexpr double roughness = {{roughness.value}};       // as it is given
constexpr int roughness_given_as = {{roughness.case}};  // 0 angle, 1 exponent, 2 slope, 3 smooth

constexpr int D = {{D.case}};                 // 0 Beckmann, 1 GGX, 2 Blinn
constexpr bool D_is_density = {{D.density}};  // else D is 1 where H is N
constexpr int G = {{G.case}};                 // 0 V-cavity, 1 Smith, 2 correlated, 3 Kelemen
constexpr int F = {{F.case}};                 // 0 of n + i k, 1 Schlick, of F0

// Copper, at {{F.wavelengths}} nm for red, green and blue.
inline const Rgb<double> n{{F.n}}, k{{F.k}};
inline const Rgb<double> F0{{F.F0}};

constexpr bool wants_braces = {{product.braces}};  // pi f_r (N.L); else f_r

}  // namespace scanlit::variant
