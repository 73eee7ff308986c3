// Your variant, as README.md states it, for who likes to have it as constants.
#pragma once

namespace a8::variant {

constexpr bool larger_is_nearer = {{larger_is_nearer}};
constexpr bool first_wins = {{first_wins}};          // of equal depths; else the last one
constexpr int inner = {{inner}}, outer = {{outer}};  // (1 - (d / reach)^inner)^outer

}  // namespace a8::variant
