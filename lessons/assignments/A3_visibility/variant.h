// Your variant, as README.md states it, for who likes to have it as constants.
#pragma once

namespace a3::variant {

constexpr bool smaller_is_nearer = {{smaller}};  // 0 at the near plane, 1 at the far plane
constexpr int bits = {{bits}};                   // of a stored depth
constexpr bool rounds = {{rounds}};              // to nearest, else down
constexpr bool last_wins = {{last_wins}};        // of equal depths, else the first stays

}  // namespace a3::variant
