#include <OpenMesh/Core/IO/OMFormat.hh>
#include <cmath>
#include <cstring>

#include "rasterizer/error.h"
#include "rasterizer/mesh/mesh_file.h"

namespace scanlit::detail {
namespace {

using Chunk = OpenMesh::IO::OMFormat::Chunk;

/// Copies the chunks the engine uses. OpenMesh takes every index in them on trust.
class OmChecker {
 public:
  OmChecker(const std::string& name, std::string_view bytes) : name_(name), bytes_(bytes) {}

  CheckedFile check() {
    read_header();
    while (true) {
      const std::size_t start = position_;
      Chunk::Header chunk;
      chunk << take<std::uint16_t>();
      if (chunk.entity_ == Chunk::Entity_Sentinel) {
        keep(start);
        break;
      }
      if (chunk.name_) {  // properties of other programs
        skip(take<std::uint8_t>());
        skip_data(chunk);
      } else if (check_chunk(chunk)) {
        keep(start);
      }
    }
    if (!has_points_ || !has_faces_ || (version_2_ && !(has_edges_ && has_vertex_links_)))
      throw Error(name_, "there are no vertices or no faces in it");
    result_.faces = faces_;
    return std::move(result_);
  }

 private:
  void read_header() {
    if (bytes_.size() < 16 || !bytes_.starts_with("OM"))
      throw Error(name_, "an OM file begins with the letters OM and a header of 16 bytes");
    kind_ = bytes_[2];
    if (kind_ != 'T' && kind_ != 'Q' && kind_ != 'P')
      throw Error(name_, "the header says it is neither of triangles, quads nor polygons");
    version_2_ = std::uint8_t(bytes_[3]) >= OpenMesh::IO::OMFormat::mk_version(2, 0);
    position_ = 4;
    vertices_ = take<std::uint32_t>();
    faces_ = take<std::uint32_t>();
    edges_ = take<std::uint32_t>();
    // Three floats a vertex, a byte a face, six an edge.
    if (vertices_ * 12 + faces_ + (version_2_ ? edges_ * 6 : 0) > bytes_.size())
      throw Error(name_, "the header claims " + std::to_string(vertices_) + " vertices, " +
                             std::to_string(faces_) + " faces and " + std::to_string(edges_) +
                             " edges, more than the file's " + std::to_string(bytes_.size()) +
                             " bytes can hold");
    keep(0);
  }

  /// Moves past the chunk's data; true where OpenMesh is to read it.
  bool check_chunk(const Chunk::Header& chunk) {
    if (chunk.type_ == Chunk::Type_Topology) {
      const std::size_t integer = std::size_t(1) << chunk.bits_;
      switch (chunk.entity_) {
        case Chunk::Entity_Vertex: return check_vertex_links(integer);
        case Chunk::Entity_Halfedge: return check_edges(integer);
        case Chunk::Entity_Face: return check_faces(integer);
        default: throw Error(name_, "malformed: topology of no known kind");
      }
    }
    if (chunk.entity_ == Chunk::Entity_Vertex && is_vector(chunk, Chunk::Type_Pos, 3))
      return check_points();
    if (chunk.entity_ == Chunk::Entity_Vertex && has_points_) {
      if (is_vector(chunk, Chunk::Type_Normal, 3)) return take_vectors(result_.vertex_normals, 12);
      if (is_vector(chunk, Chunk::Type_Texcoord, 2))
        return take_vectors(result_.vertex_texcoords, 8);
    }
    skip_data(chunk);
    return false;
  }

  void skip_data(const Chunk::Header& chunk) {
    if (chunk.type_ == Chunk::Type_Custom)
      skip(take<std::uint32_t>());
    else
      skip(count_of(chunk) * data_size(chunk));
  }

  static bool is_vector(const Chunk::Header& chunk, Chunk::Type type, unsigned size) {
    return chunk.type_ == unsigned(type) && chunk.float_ && chunk.bits_ == Chunk::Float_32 &&
           chunk.dim_ + 1u == size;
  }

  std::size_t count_of(const Chunk::Header& chunk) const {
    switch (chunk.entity_) {
      case Chunk::Entity_Vertex: return vertices_;
      case Chunk::Entity_Face: return faces_;
      case Chunk::Entity_Edge: return edges_;
      case Chunk::Entity_Halfedge: return 2 * edges_;
      case Chunk::Entity_Mesh: return 1;
      default: throw Error(name_, "malformed: a chunk of no known kind");
    }
  }

  static std::size_t data_size(const Chunk::Header& chunk) {
    const std::size_t scalar =
        chunk.float_ ? std::size_t(4) << chunk.bits_ : std::size_t(1) << chunk.bits_;
    return scalar * (chunk.dim_ + 1);
  }

  bool check_points() {
    if (has_points_) throw Error(name_, "malformed: vertices twice");
    has_points_ = true;
    for (std::size_t i = 0; i < 3 * vertices_; ++i)
      if (!std::isfinite(take<float>()))
        throw Error(name_, "vertex " + std::to_string(i / 3) +
                               " (counted from 0): a coordinate is not finite");
    return true;
  }

  bool take_vectors(bool& present, std::size_t size) {
    present = true;
    skip(vertices_ * size);
    return true;
  }

  bool check_vertex_links(std::size_t integer) {
    if (!has_points_ || has_vertex_links_) throw Error(name_, "malformed: vertices out of order");
    has_vertex_links_ = true;
    for (std::size_t i = 0; i < vertices_; ++i) take_index(integer, -1, 2 * edges_, "halfedge");
    return true;
  }

  bool check_edges(std::size_t integer) {
    if (has_edges_) throw Error(name_, "malformed: edges twice");
    has_edges_ = true;
    face_of_.assign(2 * edges_, -1);
    next_.assign(2 * edges_, -1);
    std::vector<bool> has_previous(2 * edges_);
    for (std::size_t i = 0; i < 2 * edges_; ++i) {
      next_[i] = take_index(integer, 0, 2 * edges_, "halfedge");
      take_index(integer, 0, vertices_, "vertex");
      face_of_[i] = take_index(integer, -1, faces_, "face");
      // Each halfedge follows one other: only so is every face's outline a closed ring.
      if (has_previous[std::size_t(next_[i])])
        throw Error(name_, "malformed: two halfedges are followed by the same one");
      has_previous[std::size_t(next_[i])] = true;
    }
    return true;
  }

  bool check_faces(std::size_t integer) {
    if (has_faces_) throw Error(name_, "malformed: faces twice");
    has_faces_ = true;
    for (std::size_t i = 0; i < faces_; ++i) {
      if (version_2_) {
        const std::int64_t h = take_index(integer, 0, 2 * edges_, "halfedge");
        if (has_edges_) check_ring(h, std::int64_t(i));
        continue;
      }
      const std::size_t corners = kind_ == 'T' ? 3 : kind_ == 'Q' ? 4 : take<std::uint16_t>();
      for (std::size_t k = 0; k < corners; ++k) take_index(integer, 0, vertices_, "vertex");
    }
    if (version_2_ && !has_edges_) throw Error(name_, "malformed: faces before edges");
    return true;
  }

  /// The face's outline: at least three halfedges, all of that face.
  void check_ring(std::int64_t first, std::int64_t face) const {
    std::size_t size = 0;
    std::int64_t h = first;
    do {
      if (face_of_[std::size_t(h)] != face)
        throw Error(name_, "malformed: face " + std::to_string(face) +
                               " (counted from 0) shares its outline with another");
      h = next_[std::size_t(h)];
      ++size;
    } while (h != first);
    if (size < 3)
      throw Error(name_, "face " + std::to_string(face) +
                             " (counted from 0) has fewer than 3 "
                             "corners");
  }

  std::int64_t take_index(std::size_t integer, std::int64_t least, std::size_t end,
                          const char* what) {
    const std::int64_t index = integer == 1   ? take<std::int8_t>()
                               : integer == 2 ? take<std::int16_t>()
                               : integer == 4 ? take<std::int32_t>()
                                              : take<std::int64_t>();
    if (index < least || index >= std::int64_t(end))
      throw Error(name_, std::string("names ") + what + " " + std::to_string(index) + " of " +
                             std::to_string(end) + " (counted from 0)");
    return index;
  }

  template <class T>
  T take() {
    T value;
    const std::size_t start = position_;
    skip(sizeof value);
    std::memcpy(&value, bytes_.data() + start, sizeof value);
    return value;
  }

  void skip(std::size_t size) {
    if (size > bytes_.size() - position_)
      throw Error(name_, "the file ends early: " + std::to_string(size) +
                             " bytes expected at byte " + std::to_string(position_) + ", " +
                             std::to_string(bytes_.size() - position_) + " there");
    position_ += size;
  }

  void keep(std::size_t start) { result_.data += bytes_.substr(start, position_ - start); }

  const std::string& name_;
  std::string_view bytes_;
  std::size_t position_ = 0;
  char kind_ = 'P';
  bool version_2_ = false;
  std::size_t vertices_ = 0, faces_ = 0, edges_ = 0;
  bool has_points_ = false, has_faces_ = false, has_edges_ = false, has_vertex_links_ = false;
  std::vector<std::int64_t> face_of_, next_;  // by halfedge
  CheckedFile result_;
};

}  // namespace

CheckedFile check_om(const std::string& name, std::string_view bytes) {
  return OmChecker(name, bytes).check();
}

}  // namespace scanlit::detail
