// What a file or a shape is while it still is an OpenMesh mesh. Heavy to compile: for the few
// sources between files and `Mesh`, never for the pipeline.
#pragma once

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace scanlit::detail {

/// OpenMesh's own colours are of 8 bits.
struct LinearColours : OpenMesh::DefaultTraits {
  using Color = OpenMesh::Vec3f;
};
/// Points are float, as in Mesh. Normals and texture coordinates are requested by those who have
/// them, per vertex or per halfedge (the corner at the vertex the halfedge points to); colours, per
/// vertex, likewise.
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<LinearColours>;

inline glm::vec3 to_glm(const OpenMesh::Vec3f& v) { return {v[0], v[1], v[2]}; }
inline glm::vec2 to_glm(const OpenMesh::Vec2f& v) { return {v[0], v[1]}; }
inline OpenMesh::Vec3f to_openmesh(const glm::vec3& v) { return {v.x, v.y, v.z}; }
inline OpenMesh::Vec2f to_openmesh(const glm::vec2& v) { return {v.x, v.y}; }

/// "1 face", "2 faces".
inline std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// What could not be taken as it is, by what was done about it.
struct Repairs {
  // Faces:
  std::size_t complex = 0;   // no manifold takes them: drawn with vertices of their own
  std::size_t repeated = 0;  // a vertex named more than once: drawn with copies of it
  std::size_t dropped = 0;   // fewer than 3 distinct vertices
  // Vertices:
  std::size_t clamped_colours = 0;  // not a number, or out of range
  std::size_t uncoloured = 0;       // where others have a colour: taken for white

  std::vector<std::string> warnings() const;
};

/// Takes faces that OpenMesh refuses, by copying vertices, and counts them.
class MeshImporter : public OpenMesh::IO::ImporterT<PolyMesh> {
 public:
  explicit MeshImporter(PolyMesh& mesh, const Repairs& repairs = {})
      : ImporterT(mesh), mesh_(mesh), repairs_(repairs) {}

  using VertexHandle = OpenMesh::VertexHandle;
  using FaceHandle = OpenMesh::FaceHandle;
  using ImporterT::add_face;
  using ImporterT::add_face_texcoords;
  using ImporterT::set_normal;

  /// Invalid where the face was dropped.
  FaceHandle add_face(const VHandles& vertices) override;
  void set_normal(VertexHandle vertex, const OpenMesh::Vec3f& normal) override;
  void add_face_texcoords(FaceHandle face, VertexHandle first,
                          const std::vector<OpenMesh::Vec2f>& texcoords) override;
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<OpenMesh::Vec3f>&) override;

  /// Gives copied vertices the normals, texture coordinates and colours of their originals, once
  /// those have theirs: some files say them after the faces.
  void complete_copies();

  const Repairs& repairs() const { return repairs_; }

  /// For each vertex the one it is a copy of (itself, if it is none): copies are smoothed as one.
  const std::vector<std::uint32_t>& originals();

 private:
  VertexHandle copy_of(VertexHandle vertex);
  VertexHandle with_room(VertexHandle vertex);
  template <class Set>
  void for_corners(FaceHandle face, Set set);

  PolyMesh& mesh_;
  Repairs repairs_;
  std::vector<std::uint32_t> originals_;         // by vertex, as far as it was asked for
  std::vector<int> faces_at_;                    // by vertex
  std::vector<VertexHandle> stand_in_;           // by vertex: the copy that takes its next face
  VertexHandle first_corner_;                    // of the face added last
  std::vector<OpenMesh::Vec3f> corner_normals_;  // of the next face
};

}  // namespace scanlit::detail
