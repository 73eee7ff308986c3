// The header of a PLY file: what each element's rows hold.
#pragma once

#include <string>
#include <vector>

#include "rasterizer/mesh/mesh_file.h"

namespace scanlit::detail {

enum class PlyType { i8, u8, i16, u16, i32, u32, f32, f64 };
std::size_t size_of(PlyType type);  // in bytes
bool is_float(PlyType type);

struct PlyProperty {
  std::string name;
  bool is_list = false;
  PlyType count = PlyType::u8;  // of a list
  PlyType value = PlyType::f32;
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Position in properties, or -1.
  int find(std::initializer_list<std::string_view> names) const;
};

struct PlyHeader {
  enum class Format { ascii, little_endian, big_endian } format = Format::ascii;
  std::vector<PlyElement> elements;
};

/// Leaves `lines` at end_header. Throws Error: not PLY, malformed, counts that what follows cannot
/// hold.
PlyHeader read_ply_header(Lines& lines);

}  // namespace scanlit::detail
