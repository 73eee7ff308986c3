#include "rasterizer/mesh/face_repeats.h"
#include "rasterizer/mesh/poly_mesh.h"

namespace scanlit::detail {
namespace {

// OpenMesh walks around a vertex for every face it adds there: without this bound a cone of 100,000
// segments takes minutes. A vertex with more faces goes on in a copy.
constexpr int max_faces_at_vertex = 128;

}  // namespace

std::vector<std::string> Repairs::warnings() const {
  std::vector<std::string> lines;
  if (complex > 0)
    lines.push_back(counted(complex, "face") +
                    " at an edge or vertex that no surface has (a third face, or a face turned "
                    "over): drawn with vertices of their own");
  if (repeated > 0)
    lines.push_back(counted(repeated, "face") +
                    " with a vertex named more than once: drawn with copies");
  if (dropped > 0)
    lines.push_back(counted(dropped, "face") + " of fewer than 3 distinct vertices: dropped");
  if (clamped_colours > 0)
    lines.push_back(counted(clamped_colours, "vertex colour") +
                    " not a number or out of range: clamped");
  if (uncoloured > 0)
    lines.push_back(std::to_string(uncoloured) + (uncoloured == 1 ? " vertex" : " vertices") +
                    " without a colour where others have one: drawn white");
  return lines;
}

OpenMesh::VertexHandle MeshImporter::copy_of(VertexHandle vertex) {
  const std::uint32_t original = originals()[std::size_t(vertex.idx())];
  const VertexHandle copy = mesh_.add_vertex(PolyMesh::Point(mesh_.point(vertex)));
  originals_.push_back(original);
  return copy;
}

OpenMesh::VertexHandle MeshImporter::with_room(VertexHandle vertex) {
  const auto index = std::size_t(vertex.idx());
  if (stand_in_.size() <= index) stand_in_.resize(mesh_.n_vertices());
  const VertexHandle taker = stand_in_[index].is_valid() ? stand_in_[index] : vertex;
  if (faces_at_.size() <= std::size_t(taker.idx())) faces_at_.resize(mesh_.n_vertices());
  if (++faces_at_[std::size_t(taker.idx())] <= max_faces_at_vertex) return taker;
  return stand_in_[index] = copy_of(vertex);
}

OpenMesh::FaceHandle MeshImporter::add_face(const VHandles& vertices) {
  VHandles corners = vertices;
  const FaceRepeats repeats = mend_repeats(corners, [](VertexHandle v) { return v.idx(); });
  if (repeats.distinct < 3) {
    ++repairs_.dropped;
    corner_normals_.clear();
    return FaceHandle();
  }
  if (repeats.any) ++repairs_.repeated;
  for (VertexHandle& corner : corners) corner = with_room(corner);
  for (const std::size_t i : repeats.copies) corners[i] = copy_of(corners[i]);

  FaceHandle face = mesh_.add_face(corners);
  if (!face.is_valid()) {
    ++repairs_.complex;
    for (VertexHandle& corner : corners) corner = copy_of(corner);
    face = mesh_.add_face(corners);
  }
  first_corner_ = corners.front();
  const bool normals = corner_normals_.size() == corners.size();
  for_corners(face, [&](auto corner, std::size_t i) {
    if (mesh_.has_halfedge_normals())
      mesh_.set_normal(corner, normals ? corner_normals_[i] : PolyMesh::Normal(0.0f));
    if (mesh_.has_halfedge_texcoords2D()) mesh_.set_texcoord2D(corner, PolyMesh::TexCoord2D(0.0f));
  });
  corner_normals_.clear();
  return face;
}

/// Calls set(halfedge, i) for the i-th corner the face was added with.
template <class Set>
void MeshImporter::for_corners(FaceHandle face, Set set) {
  OpenMesh::HalfedgeHandle corner = mesh_.halfedge_handle(face);
  while (mesh_.to_vertex_handle(corner) != first_corner_)
    corner = mesh_.next_halfedge_handle(corner);
  const std::size_t count = mesh_.valence(face);
  for (std::size_t i = 0; i < count; ++i) {
    set(corner, i);
    corner = mesh_.next_halfedge_handle(corner);
  }
}

void MeshImporter::set_normal(VertexHandle vertex, const OpenMesh::Vec3f& normal) {
  if (mesh_.has_halfedge_normals()) corner_normals_.push_back(normal);
  if (mesh_.has_vertex_normals()) mesh_.set_normal(vertex, normal);
}

void MeshImporter::add_face_texcoords(FaceHandle face, VertexHandle,
                                      const std::vector<OpenMesh::Vec2f>& texcoords) {
  if (!mesh_.has_halfedge_texcoords2D() || texcoords.size() != mesh_.valence(face)) return;
  for_corners(face,
              [&](auto corner, std::size_t i) { mesh_.set_texcoord2D(corner, texcoords[i]); });
}

// OpenMesh's OBJ reader hands over those of all faces so far, again for each face.
void MeshImporter::add_face_texcoords(FaceHandle, VertexHandle,
                                      const std::vector<OpenMesh::Vec3f>&) {}

void MeshImporter::complete_copies() {
  for (std::size_t i = 0; i < originals().size(); ++i) {
    const VertexHandle copy(static_cast<int>(i)), original(static_cast<int>(originals_[i]));
    if (copy == original) continue;
    if (mesh_.has_vertex_normals()) mesh_.set_normal(copy, mesh_.normal(original));
    if (mesh_.has_vertex_texcoords2D()) mesh_.set_texcoord2D(copy, mesh_.texcoord2D(original));
    if (mesh_.has_vertex_colors()) mesh_.set_color(copy, mesh_.color(original));
  }
}

const std::vector<std::uint32_t>& MeshImporter::originals() {
  while (originals_.size() < mesh_.n_vertices())
    originals_.push_back(std::uint32_t(originals_.size()));
  return originals_;
}

}  // namespace scanlit::detail
