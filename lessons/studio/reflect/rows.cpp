#include "lessons/studio/reflect/rows.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "lessons/studio/text.h"
#include "rasterizer/error.h"

namespace scanlit::studio {
namespace {

constexpr std::array<std::string_view, 6> column_names{"lx", "ly", "lz", "vx", "vy", "vz"};

constexpr std::string_view blanks = " \t\r";

/// A comma with blanks around it separates once, blanks alone too.
std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  bool after_comma = true;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    if (line.empty()) break;
    if (line[0] == ',') {
      if (after_comma) fields.emplace_back();
      after_comma = true;
      line.remove_prefix(1);
      continue;
    }
    const bool quoted = line[0] == '"';
    if (quoted) line.remove_prefix(1);
    const std::size_t end =
        std::min(quoted ? line.find('"') : line.find_first_of(", \t\r"), line.size());
    fields.push_back(line.substr(0, end));
    line.remove_prefix(std::min(end + quoted, line.size()));
    after_comma = false;
  }
  if (after_comma && !fields.empty()) fields.emplace_back();
  return fields;
}

bool is_number(std::string_view text) {
  double value;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return end == text.data() + text.size() && code != std::errc::invalid_argument;
}

/// Which fields of a row are the six, and how many fields it has.
struct Columns {
  std::array<std::size_t, 6> index{0, 1, 2, 3, 4, 5};
  std::size_t count = 6;
};

Columns columns_of(const std::string& where, const std::vector<std::string_view>& header) {
  Columns columns;
  columns.count = header.size();
  std::size_t found = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto at = std::ranges::find(header, column_names[i]);
    columns.index[i] = std::size_t(at - header.begin());
    found += at != header.end();
  }
  if (found == 6) return columns;
  const bool named = std::ranges::find(header, "") == header.end();
  if (found == 0 && header.size() == 6 && named) return {};  // other names for the same six
  throw Error(where, "these columns are not lx,ly,lz,vx,vy,vz");
}

Vec3<double> read_direction(const std::string& where, const std::vector<std::string_view>& fields,
                            const Columns& columns, std::size_t first) {
  std::array<double, 3> a;
  for (std::size_t i = 0; i < 3; ++i)
    a[i] = parse_number(where + ": " + std::string(column_names[first + i]),
                        fields[columns.index[first + i]], any_coordinate);
  const double length = std::hypot(a[0], a[1], a[2]);
  if (!(std::abs(length - 1) < unit_tolerance))
    throw Error(where, std::string(first == 0 ? "l" : "v") + " has length " + text_of(length) +
                           "; a direction's is 1, to " + text_of(unit_tolerance));
  return {a[0], a[1], a[2]};
}

}  // namespace

std::vector<DirectionRow> read_rows(std::string_view text, const std::string& name) {
  std::vector<DirectionRow> rows;
  Columns columns;
  bool first = true;
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const auto fields = fields_of(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (fields.empty()) continue;
    const std::string where = name + ":" + std::to_string(line);
    if (first && std::ranges::none_of(fields, is_number)) {
      columns = columns_of(where, fields);
    } else {
      if (fields.size() != columns.count)
        throw Error(where, std::to_string(fields.size()) + " columns, not " +
                               std::to_string(columns.count) +
                               (columns.count == 6 ? ": lx,ly,lz,vx,vy,vz" : " as in the header"));
      rows.push_back(
          {read_direction(where, fields, columns, 0), read_direction(where, fields, columns, 3)});
    }
    first = false;
  }
  return rows;
}

std::string read_all(const std::string& file) {
  if (file == "-") return {std::istreambuf_iterator<char>(std::cin), {}};
  if (std::filesystem::is_directory(file)) throw Error(file, "is a folder");
  if (std::filesystem::is_character_file(file))  // /dev/zero has no end
    throw Error(file, "is a device; rows are read from a file, a pipe or - (standard input)");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(file, std::string("cannot read: ") + std::strerror(errno));
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace scanlit::studio
