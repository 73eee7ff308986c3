// Rows of directions as text: lx,ly,lz,vx,vy,vz.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rasterizer/vec.h"

namespace scanlit::studio {

/// l to the light, v to the viewer; in the shading frame, as they stood in the file.
struct DirectionRow {
  Vec3<double> l, v;
};

/// How far from 1 a direction's length may be: text of seven digits is nearer.
constexpr double unit_tolerance = 1e-5;

/// Six numbers a line, separated by commas or blanks. A first line without any number names the
/// columns: with lx, ly, lz, vx, vy and vz among them there may be others, in any order. A field in
/// quotation marks may hold commas. Throws Error "name:line: ...": a missing or surplus column,
/// what is no number or not finite, a direction that is not of unit length.
std::vector<DirectionRow> read_rows(std::string_view text, const std::string& name);

/// All of a file, or of standard input where it is "-". Throws Error.
std::string read_all(const std::string& file);

}  // namespace scanlit::studio
