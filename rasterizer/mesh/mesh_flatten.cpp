#include "rasterizer/mesh/mesh_flatten.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "rasterizer/error.h"
#include "rasterizer/mesh/mesh_normals.h"
#include "rasterizer/mesh/mesh_tangents.h"
#include "rasterizer/mesh/triangulate.h"

namespace scanlit::detail {
namespace {

using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

constexpr std::uint32_t none = 0xffffffffu;

/// Three corners per triangle. A corner is the halfedge that points to it.
struct Corners {
  std::vector<std::uint32_t> halfedge;
  std::vector<std::uint32_t> vertex;
  std::size_t badly_cut = 0;  // polygons
};

HalfedgeHandle halfedge(std::uint32_t index) { return HalfedgeHandle(int(index)); }

Corners corners_of(const PolyMesh& mesh) {
  Corners corners;
  corners.halfedge.reserve(3 * mesh.n_faces());
  std::vector<std::uint32_t> outline, cut;
  std::vector<glm::vec3> polygon;
  for (const OpenMesh::FaceHandle face : mesh.faces()) {
    outline.clear();
    const HalfedgeHandle first = mesh.halfedge_handle(face);
    HalfedgeHandle h = first;
    do {
      outline.push_back(std::uint32_t(h.idx()));
      h = mesh.next_halfedge_handle(h);
    } while (h != first);

    cut = {0, 1, 2};
    if (outline.size() > 3) {
      polygon.clear();
      for (const std::uint32_t corner : outline)
        polygon.push_back(to_glm(mesh.point(mesh.to_vertex_handle(halfedge(corner)))));
      cut.clear();
      if (!triangulate(polygon, cut)) ++corners.badly_cut;
    }
    for (const std::uint32_t i : cut) corners.halfedge.push_back(outline[i]);
  }
  corners.vertex.reserve(corners.halfedge.size());
  for (const std::uint32_t h : corners.halfedge)
    corners.vertex.push_back(std::uint32_t(mesh.to_vertex_handle(halfedge(h)).idx()));
  return corners;
}

std::vector<glm::vec3> points_of(const PolyMesh& mesh, const std::string& name) {
  std::vector<glm::vec3> points;
  points.reserve(mesh.n_vertices());
  for (const VertexHandle v : mesh.vertices()) {
    points.push_back(to_glm(mesh.point(v)));
    const glm::vec3& p = points.back();
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw Error(name, "vertex " + std::to_string(v.idx()) + " (counted from 0) is not finite");
  }
  return points;
}

/// Which corners share a normal: those of a vertex, or of the part of it between two creases.
struct Groups {
  std::vector<std::uint32_t> of_corner;
  std::size_t count = 0;
};

Groups groups_by_vertex(const Corners& corners, std::span<const std::uint32_t> originals,
                        std::size_t vertex_count) {
  Groups groups{corners.vertex, vertex_count};
  if (!originals.empty())
    for (std::uint32_t& group : groups.of_corner) group = originals[group];
  return groups;
}

class Creases {
 public:
  Creases(const PolyMesh& mesh, const Corners& corners, const std::vector<glm::vec3>& points,
          double crease_deg)
      : mesh_(mesh), normal_(mesh.n_faces(), glm::dvec3(0)) {
    // Faces that meet at just the crease angle stay smooth, whatever rounding says of their
    // normals.
    constexpr double rounding = 1e-6;
    min_cos_ = std::cos(glm::radians(crease_deg)) - rounding;
    for (std::size_t i = 0; i < corners.vertex.size(); i += 3) {
      const glm::dvec3 a = points[corners.vertex[i]];
      const glm::dvec3 b = points[corners.vertex[i + 1]], c = points[corners.vertex[i + 2]];
      normal_[face_index(halfedge(corners.halfedge[i]))] += glm::cross(b - a, c - a);
    }
    for (glm::dvec3& n : normal_) n = unit_or_zero(n);
  }

  /// Walks each vertex from crease to crease.
  Groups groups(const Corners& corners) const {
    std::vector<std::uint32_t> group_of(mesh_.n_halfedges(), none);
    Groups groups;
    for (const HalfedgeHandle start : mesh_.halfedges()) {
      if (mesh_.is_boundary(start) || group_of[std::size_t(start.idx())] != none) continue;
      HalfedgeHandle corner = start;
      for (HalfedgeHandle before = start;;) {
        before = mesh_.opposite_halfedge_handle(before);
        if (mesh_.is_boundary(before)) break;
        before = mesh_.prev_halfedge_handle(before);
        if (before == start || !is_smooth(before, corner)) break;
        corner = before;
      }
      for (HalfedgeHandle last = corner;; last = corner) {
        group_of[std::size_t(corner.idx())] = std::uint32_t(groups.count);
        corner = mesh_.opposite_halfedge_handle(mesh_.next_halfedge_handle(corner));
        if (mesh_.is_boundary(corner) || group_of[std::size_t(corner.idx())] != none ||
            !is_smooth(last, corner))
          break;
      }
      ++groups.count;
    }
    for (const std::uint32_t h : corners.halfedge) groups.of_corner.push_back(group_of[h]);
    return groups;
  }

 private:
  std::size_t face_index(HalfedgeHandle h) const { return std::size_t(mesh_.face_handle(h).idx()); }

  bool is_smooth(HalfedgeHandle a, HalfedgeHandle b) const {
    const glm::dvec3 &m = normal_[face_index(a)], &n = normal_[face_index(b)];
    const glm::dvec3 nothing(0);  // a face of zero area makes no angle
    return m == nothing || n == nothing || glm::dot(m, n) >= min_cos_;
  }

  const PolyMesh& mesh_;
  std::vector<glm::dvec3> normal_;  // by face
  double min_cos_;
};

/// The mesh's own normal at a corner, normalised; zero where it has none.
glm::vec3 own_normal(const PolyMesh& mesh, HalfedgeHandle h) {
  if (mesh.has_halfedge_normals()) return unit_or_zero(to_glm(mesh.normal(h)));
  if (mesh.has_vertex_normals()) return unit_or_zero(to_glm(mesh.normal(mesh.to_vertex_handle(h))));
  return glm::vec3(0);
}

glm::vec2 own_texcoord(const PolyMesh& mesh, HalfedgeHandle h) {
  const glm::vec2 t =
      to_glm(mesh.has_halfedge_texcoords2D() ? mesh.texcoord2D(h)
                                             : mesh.texcoord2D(mesh.to_vertex_handle(h)));
  return {std::isfinite(t.x) ? t.x : 0, std::isfinite(t.y) ? t.y : 0};
}

/// Gives out flat vertices: corners of one mesh vertex with equal attributes share one.
class VertexPool {
 public:
  VertexPool(std::size_t mesh_vertices, bool texcoords, Mesh& out)
      : first_(mesh_vertices, none), texcoords_(texcoords), out_(out) {}

  std::uint32_t vertex(std::uint32_t mesh_vertex, const glm::vec3& position,
                       const glm::vec3& normal, const glm::vec2& texcoord) {
    std::uint32_t* link = &first_[mesh_vertex];
    for (; *link != none; link = &next_[*link])
      if (out_.normals[*link] == normal && (!texcoords_ || out_.texcoords[*link] == texcoord))
        return *link;
    const auto made = std::uint32_t(out_.positions.size());
    *link = made;
    next_.push_back(none);
    out_.positions.push_back(position);
    out_.normals.push_back(normal);
    if (texcoords_) out_.texcoords.push_back(texcoord);
    return made;
  }

 private:
  std::vector<std::uint32_t> first_;  // by mesh vertex
  std::vector<std::uint32_t> next_;   // by flat vertex: the next one of the same mesh vertex
  bool texcoords_;
  Mesh& out_;
};

}  // namespace

Mesh flatten(const PolyMesh& mesh, std::span<const std::uint32_t> originals, std::string name,
             const MeshOptions& options) {
  if (options.crease_deg && !(*options.crease_deg >= 0 && *options.crease_deg <= 180))
    throw Error(name, "a crease angle is 0 to 180 degrees");
  if (mesh.n_faces() == 0) throw Error(name, "there is no face");
  const std::vector<glm::vec3> points = points_of(mesh, name);
  const Corners corners = corners_of(mesh);
  const bool has_normals =
      !options.crease_deg && (mesh.has_halfedge_normals() || mesh.has_vertex_normals());
  const bool has_texcoords = mesh.has_halfedge_texcoords2D() || mesh.has_vertex_texcoords2D();

  Mesh result;
  result.name = std::move(name);
  std::vector<glm::vec3> computed;
  Groups groups;
  const auto compute = [&] {
    groups = options.crease_deg
                 ? Creases(mesh, corners, points, *options.crease_deg).groups(corners)
                 : groups_by_vertex(corners, originals, points.size());
    computed = group_normals(points, corners.vertex, groups.of_corner, groups.count,
                             options.normal_weight);
  };
  if (!has_normals) compute();

  std::size_t replaced = 0;
  VertexPool pool(points.size(), has_texcoords, result);
  result.indices.reserve(corners.halfedge.size());
  for (std::size_t i = 0; i < corners.halfedge.size(); ++i) {
    const HalfedgeHandle h = halfedge(corners.halfedge[i]);
    glm::vec3 normal = has_normals ? own_normal(mesh, h) : glm::vec3(0);
    if (normal == glm::vec3(0)) {
      if (computed.empty()) compute();
      if (has_normals) ++replaced;
      normal = computed[groups.of_corner[i]];
    }
    const std::uint32_t v = corners.vertex[i];
    result.indices.push_back(
        pool.vertex(v, points[v], normal, has_texcoords ? own_texcoord(mesh, h) : glm::vec2(0)));
    if (mesh.has_vertex_colors() && result.colours.size() < result.positions.size())
      result.colours.push_back(to_glm(mesh.color(VertexHandle(int(v)))));
  }
  if (has_texcoords) result.tangents = texcoord_tangents(result);
  if (replaced > 0)
    result.warnings.push_back(counted(replaced, "triangle corner") +
                              " without a normal (none, zero or not finite) where others have one: "
                              "computed");
  if (corners.badly_cut > 0)
    result.warnings.push_back(counted(corners.badly_cut, "polygon") +
                              " whose outline crosses itself, or is concave and has more than 1000 "
                              "corners: drawn as fan");
  return result;
}

}  // namespace scanlit::detail
