// Your variant, as README.md states it, for who likes to have it as constants.
#pragma once

namespace a2::variant {

constexpr double window = {{window}};          // |x| <= window w, |y| <= window w
constexpr bool near_at_0 = {{near_at_0}};      // the near plane is z = 0, else z = -w
constexpr bool given_inv_w = {{given_inv_w}};  // perspective() is given 1/w, else w

}  // namespace a2::variant
