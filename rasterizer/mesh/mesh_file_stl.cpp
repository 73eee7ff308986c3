#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

#include "rasterizer/error.h"
#include "rasterizer/mesh/mesh_file.h"

namespace scanlit::detail {
namespace {

constexpr std::size_t header_size = 84;  // 80 bytes of anything, then the number of triangles
constexpr std::size_t record_size = 50;  // normal, three vertices, two bytes

std::string lower_case(std::string_view word) {
  std::string result(word);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

std::uint32_t claimed_triangles(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

/// Binary files may begin with "solid" too: their size tells them apart.
bool is_binary(std::string_view bytes) {
  if (bytes.size() >= header_size &&
      bytes.size() == header_size + record_size * std::size_t(claimed_triangles(bytes)))
    return true;
  const std::size_t start = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  return lower_case(bytes.substr(start, 5)) != "solid" || bytes.find('\0') != bytes.npos;
}

/// OpenMesh leaves out triangles of fewer than three distinct vertices.
void count_triangle(const float* v, CheckedFile& result) {
  const auto same = [&](int i, int k) { return std::equal(v + 3 * i, v + 3 * i + 3, v + 3 * k); };
  if (same(0, 1) || same(1, 2) || same(2, 0))
    ++result.repairs.dropped;
  else
    ++result.faces;
}

CheckedFile check_binary(const std::string& name, std::string_view bytes) {
  if (bytes.size() < header_size)
    throw Error(name,
                "neither text (it does not begin with solid) nor a binary STL file (it is "
                "shorter than the header)");
  const std::size_t triangles = claimed_triangles(bytes);
  const std::size_t room = (bytes.size() - header_size) / record_size;
  if (triangles > room)
    throw Error(name, "the header claims " + std::to_string(triangles) +
                          " triangles, the file has room for " + std::to_string(room));
  CheckedFile result;
  result.binary = true;
  result.data = bytes.substr(0, header_size + triangles * record_size);
  for (std::size_t t = 0; t < triangles; ++t) {
    float vertices[9];
    std::memcpy(vertices, result.data.data() + header_size + t * record_size + 12, sizeof vertices);
    if (!std::ranges::all_of(vertices, [](float x) { return std::isfinite(x); }))
      throw Error(name, "triangle " + std::to_string(t) +
                            " (counted from 0): a vertex coordinate is not finite");
    count_triangle(vertices, result);
  }
  return result;
}

/// Copies the facets' vertices: OpenMesh takes any line with "outer" in it for the start of one.
CheckedFile check_text(const std::string& name, std::string_view text) {
  CheckedFile result;
  result.data = "solid\n";
  Lines lines(name, text);
  bool ended = false;
  while (lines.next()) {
    const std::string word = lower_case(lines.words()[0]);
    if (word == "endsolid") ended = true;
    if (word == "solid") ended = false;
    if (word == "vertex") lines.fail("a vertex outside of outer loop ... endloop");
    if (word != "outer") continue;
    result.data += "outer loop\n";
    float v[9];
    for (std::size_t i = 0; i < 9; ++i) {
      if (i % 3 == 0) {
        if (!lines.next() || lower_case(lines.words()[0]) != "vertex")
          lines.fail("expected the three vertices of a triangle");
        lines.expect_words(4, "a vertex has three coordinates");
        result.data += "vertex ";
      }
      v[i] = lines.finite(i % 3 + 1, "vertex coordinate");
      append_number(result.data, v[i]);
      if (i % 3 == 2) result.data += '\n';
    }
    if (!lines.next() || lower_case(lines.words()[0]) != "endloop")
      lines.fail("expected endloop after the three vertices of a triangle");
    count_triangle(v, result);
  }
  if (!ended) lines.fail("the file ends before endsolid");
  return result;
}

}  // namespace

CheckedFile check_stl(const std::string& name, std::string_view bytes) {
  return is_binary(bytes) ? check_binary(name, bytes) : check_text(name, bytes);
}

}  // namespace scanlit::detail
