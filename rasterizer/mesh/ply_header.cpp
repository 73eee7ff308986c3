#include "rasterizer/mesh/ply_header.h"

#include <algorithm>
#include <array>

namespace scanlit::detail {
namespace {

struct TypeName {
  std::string_view name, other_name;
  std::size_t size;
};
// In the order of PlyType.
constexpr std::array<TypeName, 8> types{{{"char", "int8", 1},
                                         {"uchar", "uint8", 1},
                                         {"short", "int16", 2},
                                         {"ushort", "uint16", 2},
                                         {"int", "int32", 4},
                                         {"uint", "uint32", 4},
                                         {"float", "float32", 4},
                                         {"double", "float64", 8}}};

PlyType type_named(const Lines& lines, std::string_view name) {
  for (std::size_t i = 0; i < types.size(); ++i)
    if (name == types[i].name || name == types[i].other_name) return PlyType(i);
  lines.fail("unknown type '" + std::string(name.substr(0, 40)) + "'");
}

PlyProperty property(const Lines& lines) {
  const auto& words = lines.words();
  PlyProperty result;
  result.is_list = words.size() > 1 && words[1] == "list";
  lines.expect_words(result.is_list ? 5 : 3, result.is_list
                                                 ? "expected property list COUNT_TYPE TYPE NAME"
                                                 : "expected property TYPE NAME");
  if (result.is_list) result.count = type_named(lines, words[2]);
  if (result.is_list && is_float(result.count)) lines.fail("the count of a list is a whole number");
  result.value = type_named(lines, words[result.is_list ? 3 : 1]);
  result.name = words[result.is_list ? 4 : 2];
  return result;
}

/// The fewest bytes that one row can take.
std::size_t least_row(const PlyHeader& header, const PlyElement& element) {
  if (header.format == PlyHeader::Format::ascii) return 2 * element.properties.size();
  std::size_t bytes = 0;
  for (const PlyProperty& p : element.properties) bytes += size_of(p.is_list ? p.count : p.value);
  return bytes;
}

void check_counts(const Lines& lines, const PlyHeader& header) {
  // The last line's end may be missing.
  std::size_t left = lines.rest().size() + (header.format == PlyHeader::Format::ascii ? 1 : 0);
  for (const PlyElement& e : header.elements) {
    const std::size_t row = least_row(header, e);
    if (e.count > 0 && row == 0) lines.fail("element '" + e.name + "' has no property");
    if (row > 0 && std::size_t(e.count) > left / row)
      lines.fail("the header claims " + std::to_string(e.count) + " of element '" + e.name +
                 "', more than the file's " + std::to_string(lines.rest().size()) +
                 " remaining bytes can hold");
    left -= std::size_t(e.count) * row;
  }
}

}  // namespace

std::size_t size_of(PlyType type) { return types[std::size_t(type)].size; }
bool is_float(PlyType type) { return type == PlyType::f32 || type == PlyType::f64; }

int PlyElement::find(std::initializer_list<std::string_view> names) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (std::ranges::find(names, properties[i].name) != names.end()) return int(i);
  return -1;
}

PlyHeader read_ply_header(Lines& lines) {
  if (!lines.next() || (lines.words()[0] != "ply" && lines.words()[0] != "PLY"))
    lines.fail("a PLY file begins with the word ply");
  PlyHeader header;
  bool has_format = false;
  while (lines.next()) {
    const auto& words = lines.words();
    if (words[0] == "end_header") {
      if (!has_format) lines.fail("the header says no format");
      check_counts(lines, header);
      return header;
    }
    if (words[0] == "format") {
      lines.expect_words(2, "expected format NAME 1.0");
      constexpr std::array<std::string_view, 3> formats = {"ascii", "binary_little_endian",
                                                           "binary_big_endian"};
      const auto found = std::ranges::find(formats, words[1]);
      if (found == formats.end())
        lines.fail("unknown format; there are: ascii, binary_little_endian, binary_big_endian");
      header.format = PlyHeader::Format(found - formats.begin());
      has_format = true;
    } else if (words[0] == "element") {
      lines.expect_words(3, "expected element NAME COUNT");
      header.elements.push_back({std::string(words[1]), lines.integer(2, "count"), {}});
      if (header.elements.back().count < 0) lines.fail("a count is not negative");
    } else if (words[0] == "property") {
      if (header.elements.empty()) lines.fail("a property before any element");
      header.elements.back().properties.push_back(property(lines));
    } else if (words[0] != "comment" && words[0] != "obj_info") {
      lines.fail(
          "unknown word in the header; there are: format, element, property, comment, "
          "obj_info, end_header");
    }
  }
  lines.fail("the file ends before end_header");
}

}  // namespace scanlit::detail
