#include <algorithm>
#include <cmath>

#include "rasterizer/mesh/face_repeats.h"
#include "rasterizer/mesh/mesh_colours.h"
#include "rasterizer/mesh/mesh_file.h"

namespace scanlit::detail {
namespace {

/// Indices into the file's lists, from 0; absent where the face does not say.
struct ObjCorner {
  std::int64_t vertex, texcoord, normal;
};
constexpr std::int64_t absent = -1;

/// OpenMesh's OBJ reader looks for each corner among all before it: 300,000 take half a minute.
constexpr std::size_t max_corners = 10'000;

struct Counts {
  std::int64_t vertices = 0, texcoords = 0, normals = 0;
};

/// Copies what concerns geometry; materials, groups, lines, points and curves are left out.
class ObjChecker {
 public:
  ObjChecker(std::string name, std::string_view text) : lines_(std::move(name), text, true) {}

  CheckedFile check(const Counts& total) {
    total_ = total;
    while (lines_.next()) {
      const std::string_view keyword = lines_.words()[0];
      if (keyword == "v") add_vertex();
      if (keyword == "vt") add_texcoord();
      if (keyword == "vn") add_normal();
      if (keyword == "f" || keyword == "fo") add_face();
    }
    for (const std::int64_t vertex : copied_) write_vertex(points_[std::size_t(vertex)]);
    take_colours();
    return std::move(result_);
  }

 private:
  void add_vertex() {
    lines_.expect_words(4, "a vertex has three coordinates");
    glm::vec3 point;
    for (int i = 0; i < 3; ++i) point[i] = lines_.finite(std::size_t(i + 1), "vertex coordinate");
    points_.push_back(point);
    write_vertex(point);
    if (lines_.words().size() >= 7) add_colour();
    ++seen_.vertices;
  }

  /// After the coordinates. (A single fourth number is a weight, and of no use.)
  void add_colour() {
    glm::dvec3 colour;
    for (int c = 0; c < 3; ++c) colour[c] = lines_.any_number(std::size_t(4 + c), "colour");
    colours_.resize(points_.size(), white);
    colours_.back() = colour;
    ++coloured_;
  }

  void take_colours() {
    if (coloured_ == 0) return;
    result_.repairs.uncoloured = points_.size() - coloured_;
    colours_.resize(points_.size(), white);
    for (const std::int64_t vertex : copied_) colours_.push_back(colours_[std::size_t(vertex)]);
    result_.colours = linear_colours(colours_, ColourCode::fraction, result_.repairs);
  }

  void write_vertex(const glm::vec3& point) {
    result_.data += "v ";
    for (int i = 0; i < 3; ++i) append_number(result_.data, point[i]);
    result_.data += '\n';
  }

  void add_texcoord() {
    lines_.expect_words(2, "a texture coordinate has one to three numbers");
    result_.data += "vt ";
    append_number(result_.data, lines_.finite(1, "texture coordinate"));
    append_number(result_.data,
                  lines_.words().size() > 2 ? lines_.finite(2, "texture coordinate") : 0.0f);
    result_.data += '\n';
    ++seen_.texcoords;
  }

  void add_normal() {
    lines_.expect_words(4, "a normal has three numbers");
    float normal[3];
    for (std::size_t i = 0; i < 3; ++i) normal[i] = float(lines_.any_number(i + 1, "normal"));
    // OpenMesh would leave out a normal that is not finite, and so shift all later ones.
    const bool good =
        std::isfinite(normal[0]) && std::isfinite(normal[1]) && std::isfinite(normal[2]);
    result_.data += "vn ";
    for (const float n : normal) append_number(result_.data, good ? n : 0.0f);
    result_.data += '\n';
    ++seen_.normals;
  }

  void add_face() {
    std::vector<ObjCorner> corners;
    const std::size_t count = lines_.words().size() - 1;
    if (count > max_corners)
      lines_.fail("a face of " + std::to_string(count) + " corners; at most " +
                  std::to_string(max_corners) + " can be read");
    for (std::size_t i = 1; i < lines_.words().size(); ++i) corners.push_back(corner(i));
    const FaceRepeats repeats = mend_repeats(corners, [](const ObjCorner& c) { return c.vertex; });
    if (repeats.distinct < 3) {
      ++result_.repairs.dropped;
      return;
    }
    if (repeats.any) ++result_.repairs.repeated;
    for (const std::size_t i : repeats.copies) corners[i].vertex = copy_of(corners[i].vertex);

    const bool texcoords =
        std::ranges::none_of(corners, [](const ObjCorner& c) { return c.texcoord == absent; });
    const bool normals =
        std::ranges::none_of(corners, [](const ObjCorner& c) { return c.normal == absent; });
    result_.corner_texcoords |= texcoords;
    result_.corner_normals |= normals;
    write_face(corners, texcoords, normals);
    ++result_.faces;
  }

  void write_face(const std::vector<ObjCorner>& corners, bool texcoords, bool normals) {
    std::string& text = result_.data;
    const auto append_index = [&](std::int64_t index, char after) {
      append_number(text, index + 1);
      text.back() = after;
    };
    text += "f ";
    for (const ObjCorner& c : corners) {
      append_index(c.vertex, texcoords || normals ? '/' : ' ');
      if (texcoords) append_index(c.texcoord, normals ? '/' : ' ');
      if (!texcoords && normals) text += '/';
      if (normals) append_index(c.normal, ' ');
    }
    text += '\n';
  }

  /// "vertex", "vertex/texcoord", "vertex//normal" or "vertex/texcoord/normal".
  ObjCorner corner(std::size_t word) {
    std::string_view text = lines_.words()[word];
    const auto next = [&](std::int64_t seen, std::int64_t total, const char* what) {
      const std::string_view part = text.substr(0, text.find('/'));
      text.remove_prefix(std::min(part.size() + 1, text.size()));
      return part.empty() ? absent : index(part, seen, total, what);
    };
    ObjCorner c;
    c.vertex = next(seen_.vertices, total_.vertices, "vertex");
    c.texcoord = next(seen_.texcoords, total_.texcoords, "texture coordinate");
    c.normal = next(seen_.normals, total_.normals, "normal");
    if (c.vertex == absent || !text.empty())
      lines_.fail(
          "a face's corner is VERTEX, VERTEX/TEXCOORD, VERTEX//NORMAL or "
          "VERTEX/TEXCOORD/NORMAL");
    return c;
  }

  /// From 1, or back from the last one before this line.
  std::int64_t index(std::string_view text, std::int64_t seen, std::int64_t total,
                     const std::string& what) const {
    const std::int64_t named = lines_.integer(text, "index");
    const std::int64_t i = named < 0 ? seen + named : named - 1;
    if (i < 0 || i >= total)
      lines_.fail("face names " + what + " " + std::to_string(named) + " of " +
                  std::to_string(named < 0 ? seen : total));
    return i;
  }

  /// A vertex at the same place, written after all others.
  std::int64_t copy_of(std::int64_t vertex) {
    copied_.push_back(vertex);
    return total_.vertices + std::int64_t(copied_.size()) - 1;
  }

  Lines lines_;
  Counts total_, seen_;
  CheckedFile result_;
  static constexpr glm::dvec3 white{1, 1, 1};
  std::vector<glm::vec3> points_;
  std::vector<glm::dvec3> colours_;  // as far as a vertex has had one
  std::size_t coloured_ = 0;
  std::vector<std::int64_t> copied_;
};

/// Faces may name vertices of later lines.
Counts count(const std::string& name, std::string_view text) {
  Counts counts;
  for (Lines lines(name, text, true); lines.next();) {
    const std::string_view keyword = lines.words()[0];
    if (keyword == "v") ++counts.vertices;
    if (keyword == "vt") ++counts.texcoords;
    if (keyword == "vn") ++counts.normals;
  }
  return counts;
}

}  // namespace

CheckedFile check_obj(const std::string& name, std::string_view text) {
  expect_text(name, text);
  return ObjChecker(name, text).check(count(name, text));
}

}  // namespace scanlit::detail
