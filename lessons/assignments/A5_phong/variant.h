// Your variant, as README.md states it, as constants.
#pragma once

namespace scanlit::variant {

constexpr double shininess = {{shininess}};             // as it is given
constexpr int shininess_given_as = {{shininess.case}};  // 0 exponent, 1 half-width, 2 gloss
constexpr bool same_width = {{same_width}};             // Blinn's exponent is 4 times Phong's
constexpr bool with_cosine = {{with_cosine}};           // the glossy term has the factor N.L
constexpr bool light_travels = {{light_travels}};       // `light` points away from the light

}  // namespace scanlit::variant
