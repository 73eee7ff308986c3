// Your variant, as README.md states it, for who likes to have it as constants.
#pragma once

namespace a4::variant {

constexpr double wrap = {{wrap}};              // w in the diffuse term
constexpr bool mirrored_light = {{mirrored}};  // the highlight is (R.V)^n, else (N.H)^n
constexpr bool clamps_vertices = {{clamps}};   // vertex colours are cut to 0..1
constexpr bool unit_first = {{unit_first}};  // normals get unit length first, and again at the end

}  // namespace a4::variant
