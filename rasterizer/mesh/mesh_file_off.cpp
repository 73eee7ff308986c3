#include "rasterizer/mesh/mesh_colours.h"
#include "rasterizer/mesh/mesh_file.h"

namespace scanlit::detail {
namespace {

/// What the header's keyword says of each vertex: [ST][C][N]OFF.
struct OffLayout {
  bool texcoords, colours, normals;
};

/// The file's colours; fractions if any of them is written as one: 1 is a fraction beside .5.
struct OffColours {
  std::vector<glm::dvec3> values;
  ColourCode code = ColourCode::eight_bit;
};

OffLayout layout(const Lines& lines, std::string_view keyword) {
  const std::string_view whole = keyword;
  const auto take = [&](std::string_view prefix) {
    const bool found = keyword.starts_with(prefix);
    if (found) keyword.remove_prefix(prefix.size());
    return found;
  };
  OffLayout result{};
  result.texcoords = take("ST");
  result.colours = take("C");
  result.normals = take("N");
  if (keyword == "4OFF" || keyword == "nOFF" || keyword == "4nOFF")
    lines.fail("'" + std::string(whole) + "': only vertices of three coordinates can be drawn");
  if (keyword != "OFF") lines.fail("an OFF file begins with the word OFF");
  return result;
}

/// The numbers of vertices and faces, on the header's line or on one of their own.
void read_counts(Lines& lines, std::int64_t& vertices, std::int64_t& faces) {
  std::size_t first = 1;
  if (lines.words().size() > 1 && lines.words()[1] == "BINARY")
    lines.fail("binary OFF cannot be read; save it as text or as PLY");
  if (lines.words().size() == 1) {
    if (!lines.next()) lines.fail("the file ends before the numbers of vertices and faces");
    first = 0;
  }
  lines.expect_words(first + 2, "expected the numbers of vertices and faces");
  vertices = lines.integer(first, "number of vertices");
  faces = lines.integer(first + 1, "number of faces");
  const auto left = std::int64_t(lines.rest().size());
  // A vertex or face takes at least the six characters of "0 0 0\n".
  if (vertices < 0 || faces < 0 || vertices > left / 6 + 1 || faces > left / 6 + 1 ||
      vertices + faces > left / 6 + 1)
    lines.fail("the header claims " + std::to_string(vertices) + " vertices and " +
               std::to_string(faces) + " faces, more than the file's " + std::to_string(left) +
               " characters can hold");
}

void take_colour(const Lines& lines, std::size_t first, OffColours& colours) {
  glm::dvec3 colour;
  for (std::size_t c = 0; c < 3; ++c) {
    colour[int(c)] = lines.any_number(first + c, "colour");
    if (lines.words()[first + c].find_first_of(".eEnN") != std::string_view::npos)
      colours.code = ColourCode::fraction;
  }
  colours.values.push_back(colour);
}

void copy_vertex(Lines& lines, const OffLayout& has, CheckedFile& result, OffColours& colours) {
  const std::size_t before_colour = has.normals ? 6 : 3;
  const std::size_t size = before_colour + (has.colours ? 3 : 0) + (has.texcoords ? 2 : 0);
  lines.expect_words(size, "a vertex has " + std::to_string(size) + " numbers");
  for (std::size_t i = 0; i < 3; ++i)
    append_number(result.data, lines.finite(i, "vertex coordinate"));
  result.data += '\n';
  if (has.normals)
    result.normals.emplace_back(lines.any_number(3, "normal"), lines.any_number(4, "normal"),
                                lines.any_number(5, "normal"));
  if (has.colours) take_colour(lines, before_colour, colours);
  const std::size_t last = lines.words().size() - 1;  // colours come before texture coordinates
  if (has.texcoords)
    result.texcoords.emplace_back(lines.finite(last - 1, "texture coordinate"),
                                  lines.finite(last, "texture coordinate"));
}

void copy_face(Lines& lines, std::int64_t vertices, std::string& data) {
  const std::int64_t size = lines.integer(0, "number of corners");
  if (size < 0) lines.fail("a face has " + std::to_string(size) + " corners");
  if (std::uint64_t(size) >= lines.words().size())
    lines.fail("face of " + std::to_string(size) + " corners names only " +
               std::to_string(lines.words().size() - 1));
  append_number(data, size);
  for (std::size_t i = 1; i <= std::size_t(size); ++i) {
    const std::int64_t vertex = lines.integer(i, "index");
    if (vertex < 0 || vertex >= vertices)
      lines.fail("face names vertex " + std::to_string(vertex) + " of " + std::to_string(vertices) +
                 " (counted from 0)");
    append_number(data, vertex);
  }
  data += '\n';  // colours are left out: OpenMesh takes them for the next face
}

}  // namespace

CheckedFile check_off(const std::string& name, std::string_view text) {
  expect_text(name, text.substr(0, text.find("BINARY")));
  Lines lines(name, text);
  if (!lines.next()) lines.fail("there is nothing in it");
  const OffLayout has = layout(lines, lines.words()[0]);
  std::int64_t vertices = 0, faces = 0;
  read_counts(lines, vertices, faces);

  CheckedFile result;
  result.faces = std::size_t(faces);
  result.data = "OFF\n";
  append_number(result.data, vertices);
  append_number(result.data, faces);
  result.data += "0\n";
  const auto next = [&](std::int64_t i, std::int64_t count, const char* what) {
    if (!lines.next())
      lines.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(count) + " " +
                 what);
  };
  OffColours colours;
  for (std::int64_t i = 0; i < vertices; ++i) {
    next(i, vertices, "vertices");
    copy_vertex(lines, has, result, colours);
  }
  result.colours = linear_colours(colours.values, colours.code, result.repairs);
  for (std::int64_t i = 0; i < faces; ++i) {
    next(i, faces, "faces");
    copy_face(lines, vertices, result.data);
  }
  return result;
}

}  // namespace scanlit::detail
