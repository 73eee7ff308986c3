// Your variant, as README.md states it, for who likes to have it as constants.
#pragma once

namespace a9::variant {

constexpr bool y_up = {{y_up}};
constexpr int centre = {{centre_256}};     // of pixel (0, 0), in 1/256 pixel, in x and in y
constexpr bool owns_left = {{owns_left}};  // else right edges
constexpr bool owns_top = {{owns_top}};    // else the horizontal edge at the bottom

}  // namespace a9::variant
