#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "rasterizer/error.h"
#include "rasterizer/mesh/mesh_colours.h"
#include "rasterizer/mesh/mesh_file.h"
#include "rasterizer/mesh/ply_header.h"

namespace scanlit::detail {
namespace {

/// The numbers of an ascii file: one row a line.
class TextRows {
 public:
  explicit TextRows(Lines& lines) : lines_(lines) {}

  void begin_row(const PlyElement& element, std::int64_t row) {
    if (!lines_.next())
      lines_.fail("the file ends after " + std::to_string(row) + " of " +
                  std::to_string(element.count) + " of element '" + element.name + "'");
    word_ = 0;
  }
  double next(PlyType type) {
    if (word_ >= lines_.words().size()) fail("the line ends early");
    if (is_float(type)) return lines_.any_number(word_++, "value");
    return double(lines_.integer(word_++, "value"));
  }
  [[noreturn]] void fail(const std::string& what) const { lines_.fail(what); }

 private:
  Lines& lines_;
  std::size_t word_ = 0;
};

/// The numbers of a binary file.
class BinaryRows {
 public:
  BinaryRows(const std::string& name, std::string_view bytes, bool big_endian)
      : name_(name), bytes_(bytes), big_endian_(big_endian) {}

  void begin_row(const PlyElement& element, std::int64_t row) {
    element_ = &element;
    row_ = row;
  }
  double next(PlyType type) {
    switch (type) {
      case PlyType::i8: return take<std::int8_t>();
      case PlyType::u8: return take<std::uint8_t>();
      case PlyType::i16: return take<std::int16_t>();
      case PlyType::u16: return take<std::uint16_t>();
      case PlyType::i32: return take<std::int32_t>();
      case PlyType::u32: return take<std::uint32_t>();
      case PlyType::f32: return double(take<float>());
      case PlyType::f64: return take<double>();
    }
    return 0;
  }
  [[noreturn]] void fail(const std::string& what) const {
    const std::string row = element_ ? element_->name + " " + std::to_string(row_) + " of " +
                                           std::to_string(element_->count) + " (counted from 0): "
                                     : "";
    throw Error(name_, printable(row + what));
  }

 private:
  template <class T>
  T take() {
    if (bytes_.size() < sizeof(T)) fail("the file ends here");
    char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data(), sizeof(T));
    if (big_endian_) std::reverse(raw, raw + sizeof(T));
    bytes_.remove_prefix(sizeof(T));
    return std::bit_cast<T>(raw);
  }

  const std::string& name_;
  std::string_view bytes_;
  bool big_endian_;
  const PlyElement* element_ = nullptr;
  std::int64_t row_ = 0;
};

/// Reads the list's items into `items`.
template <class Rows>
void read_list(Rows& rows, const PlyProperty& list, std::vector<double>& items) {
  items.clear();
  const double count = rows.next(list.count);
  if (count < 0) rows.fail("a list of negative length");
  for (double i = 0; i < count; ++i) items.push_back(rows.next(list.value));
}

/// Where a vertex's row holds its colour, if it does.
struct PlyColour {
  int red, green, blue;
  ColourCode code = ColourCode::eight_bit;

  explicit PlyColour(const PlyElement& element)
      : red(element.find({"red", "diffuse_red"})),
        green(element.find({"green", "diffuse_green"})),
        blue(element.find({"blue", "diffuse_blue"})) {
    if (!present()) return;
    const PlyType type = element.properties[std::size_t(red)].value;
    if (is_float(type)) code = ColourCode::fraction;
    if (type == PlyType::u16) code = ColourCode::sixteen_bit;
  }

  bool present() const { return red >= 0 && green >= 0 && blue >= 0; }
};

template <class Rows>
void copy_vertices(Rows& rows, const PlyElement& element, CheckedFile& result) {
  // x y z, nx ny nz, u v, in the order in which they are written
  const int positions[] = {element.find({"x"}),
                           element.find({"y"}),
                           element.find({"z"}),
                           element.find({"nx"}),
                           element.find({"ny"}),
                           element.find({"nz"}),
                           element.find({"u", "s", "texture_u"}),
                           element.find({"v", "t", "texture_v"})};
  if (*std::min_element(positions, positions + 3) < 0) rows.fail("a vertex has no x, y and z");
  result.vertex_normals = *std::min_element(positions + 3, positions + 6) >= 0;
  result.vertex_texcoords = *std::min_element(positions + 6, positions + 8) >= 0;

  const PlyColour colour(element);
  std::vector<glm::dvec3> colours;
  std::vector<double> values(element.properties.size()), ignored;
  for (std::int64_t row = 0; row < element.count; ++row) {
    rows.begin_row(element, row);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (element.properties[i].is_list)
        read_list(rows, element.properties[i], ignored);
      else
        values[i] = rows.next(element.properties[i].value);
    for (std::size_t i = 0; i < 8; ++i) {
      if ((i >= 3 && i < 6 && !result.vertex_normals) || (i >= 6 && !result.vertex_texcoords))
        continue;
      const auto value = float(values[std::size_t(positions[i])]);
      if (i < 3 && !std::isfinite(value)) rows.fail("a vertex coordinate is not a finite float");
      append_bytes(result.data, value);
    }
    if (colour.present())
      colours.emplace_back(values[std::size_t(colour.red)], values[std::size_t(colour.green)],
                           values[std::size_t(colour.blue)]);
  }
  result.colours = linear_colours(colours, colour.code, result.repairs);
}

template <class Rows>
void copy_faces(Rows& rows, const PlyElement& element, std::int64_t vertices, std::string& data) {
  const int indices = element.find({"vertex_indices", "vertex_index"});
  if (indices < 0 || !element.properties[std::size_t(indices)].is_list)
    rows.fail("a face has no list vertex_indices");
  if (is_float(element.properties[std::size_t(indices)].value))
    rows.fail("vertex_indices are whole numbers");
  std::vector<double> items, corners;
  for (std::int64_t row = 0; row < element.count; ++row) {
    rows.begin_row(element, row);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& p = element.properties[i];
      if (p.is_list)
        read_list(rows, p, int(i) == indices ? corners : items);
      else
        rows.next(p.value);
    }
    if (corners.size() > 255)  // OpenMesh reads lists whose length is a byte
      rows.fail("a face of " + std::to_string(corners.size()) +
                " corners; at most 255 can be read");
    append_bytes(data, std::uint8_t(corners.size()));
    for (const double corner : corners) {
      if (corner < 0 || corner >= double(vertices))
        rows.fail("face names vertex " + std::to_string(std::int64_t(corner)) + " of " +
                  std::to_string(vertices) + " (counted from 0)");
      append_bytes(data, std::int32_t(corner));
    }
  }
}

template <class Rows>
void skip(Rows& rows, const PlyElement& element) {
  std::vector<double> ignored;
  for (std::int64_t row = 0; row < element.count; ++row) {
    rows.begin_row(element, row);
    for (const PlyProperty& p : element.properties)
      if (p.is_list)
        read_list(rows, p, ignored);
      else
        rows.next(p.value);
  }
}

std::string header_text(const CheckedFile& file, std::int64_t vertices, std::int64_t faces) {
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  append_number(text, vertices);
  text += "\nproperty float x\nproperty float y\nproperty float z\n";
  if (file.vertex_normals) text += "property float nx\nproperty float ny\nproperty float nz\n";
  if (file.vertex_texcoords) text += "property float u\nproperty float v\n";
  text += "element face ";
  append_number(text, faces);
  return text + "\nproperty list uchar int vertex_indices\nend_header\n";
}

/// Writes everything as little-endian floats, uchar and int: OpenMesh reads no double coordinates
/// and no long lists from binary files, and loses its place at other elements and properties.
template <class Rows>
CheckedFile copy(Rows& rows, const std::string& name, const PlyHeader& header) {
  CheckedFile result;
  std::int64_t vertices = -1, faces = -1;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex" && vertices < 0) {
      copy_vertices(rows, element, result);
      vertices = element.count;
    } else if (element.name == "face" && faces < 0) {
      if (vertices < 0) throw Error(name, "the faces come before the vertices");
      copy_faces(rows, element, vertices, result.data);
      faces = element.count;
    } else if (faces < 0) {  // nothing after the faces is of interest
      skip(rows, element);
    }
  }
  if (vertices < 0) throw Error(name, "there is no element 'vertex'");
  if (faces < 0) throw Error(name, "there is no element 'face'");
  result.faces = std::size_t(faces);
  result.data = header_text(result, vertices, faces) + result.data;
  return result;
}

}  // namespace

CheckedFile check_ply(const std::string& name, std::string_view bytes) {
  Lines lines(name, bytes);
  const PlyHeader header = read_ply_header(lines);
  if (header.format == PlyHeader::Format::ascii) {
    expect_text(name, bytes);
    TextRows rows(lines);
    return copy(rows, name, header);
  }
  BinaryRows rows(name, lines.rest(), header.format == PlyHeader::Format::big_endian);
  return copy(rows, name, header);
}

}  // namespace scanlit::detail
