#include "rasterizer/surface.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "rasterizer/batch.h"
#include "rasterizer/tangents.h"

namespace scanlit {

namespace {

struct Corners {
  std::size_t vertex[3];

  Corners(const Mesh& mesh, std::uint32_t triangle) {
    for (std::size_t i = 0; i < 3; ++i) vertex[i] = mesh.indices[3 * std::size_t(triangle) + i];
  }
};

template <class V, std::size_t components>
void put(const V& value, int i, float (&out)[components][SurfaceSpan::padded]) {
  for (int c = 0; c < int(components); ++c) out[c][i] = value[c];
}

/// The mean over some vertices (a face's, or one alone); `missing` where the mesh has no such
/// attribute.
template <class V>
V mean(const std::vector<V>& attribute, std::span<const std::size_t> vertices, const V& missing) {
  if (attribute.empty()) return missing;
  V sum(0);
  for (const std::size_t v : vertices) sum += attribute[v];
  return sum / float(vertices.size());
}

void put_point(const Mesh& mesh, const Needs& needs, std::span<const std::size_t> vertices,
               const glm::vec3& position, const glm::vec3& normal, int i, SurfaceSpan& surface) {
  put(position, i, surface.position);
  put(normal, i, surface.normal);
  if (needs_points(needs)) {
    put(mean(mesh.texcoords, vertices, glm::vec2(0)), i, surface.texcoord);
    put(mean(mesh.colours, vertices, glm::vec3(1)), i, surface.colour);
  }
  if (needs.frame) put(mean(mesh.tangents, vertices, glm::vec3(0)), i, surface.tangent);
}

template <std::size_t components>
void fill(float (&out)[components][SurfaceSpan::padded], float value) {
  for (auto& component : out) std::ranges::fill(component, value);
}

constexpr int ahead = 8;  // runs: about as long as memory takes to answer

void prefetch(const Mesh& mesh, std::uint32_t triangle, bool positions) {
  for (const std::size_t v : Corners(mesh, triangle).vertex) {
    if (positions) __builtin_prefetch(&mesh.positions[v]);
    __builtin_prefetch(&mesh.normals[v]);
  }
}

/// By how much the texture coordinates grow with one pixel.
void interpolate_growth(const FragmentSpan& span, const Run& run, const std::size_t (&vertex)[3],
                        SurfaceSpan& surface) {
  const auto& texcoords = span.draw->mesh->texcoords;
  const glm::vec2 edge_1 = texcoords[vertex[1]] - texcoords[vertex[0]];
  const glm::vec2 edge_2 = texcoords[vertex[2]] - texcoords[vertex[0]];
  for (int k = 0; k < 2; ++k) {
    const auto grow = [&](const FragmentSpan::Derivatives& db, float* out) {
      const Batch d1(edge_1[k]), d2(edge_2[k]);
      for (int i = run.first; i < run.first + run.size; i += Batch::lanes)
        mul_add(Batch::load(db.b2 + i), d2, Batch::load(db.b1 + i) * d1).store(out + i);
    };
    grow(span.dx, surface.texcoord_dx[k]);
    grow(span.dy, surface.texcoord_dy[k]);
  }
}

}  // namespace

Face face(const Mesh& mesh, std::uint32_t triangle) {
  const Corners corners(mesh, triangle);
  const glm::dvec3 a(mesh.positions[corners.vertex[0]]), b(mesh.positions[corners.vertex[1]]),
      c(mesh.positions[corners.vertex[2]]);
  // In double: the product of two edges of a very small face leaves float.
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  return {(a + b + c) / 3.0, length > 0 ? normal / length : glm::dvec3(0)};
}

void put_site(const Draw& draw, const Needs& needs, const LitSites::Site& site, int i,
              SurfaceSpan& surface) {
  const Mesh& mesh = *draw.mesh;
  const float sign = site.from_behind ? -1.0f : 1.0f;
  if (draw.object->shading == Shading::flat) {
    const auto [centroid, normal] = face(mesh, site.element);
    put_point(mesh, needs, Corners(mesh, site.element).vertex, centroid, sign * normal, i, surface);
  } else {
    const std::size_t v = site.element;
    put_point(mesh, needs, {&v, 1}, mesh.positions[v], sign * mesh.normals[v], i, surface);
  }
}

void interpolate_surface(const FragmentSpan& span, SurfaceSpan& surface) {
  const Mesh& mesh = *span.draw->mesh;
  const Needs needs = span.draw->object->material.model->needs();
  const bool points = needs_points(needs), tangents = needs.frame && follows_texcoord(*span.draw);
  const bool positions = span.draw->illumination.needs_position;
  const auto interpolate = [&](const auto& values, auto& out) {
    RunAttribute<int(std::extent_v<std::remove_reference_t<decltype(out)>>), true> runs;
    for (int r = 0; r < span.run_count; ++r) {
      const auto& v = Corners(mesh, span.runs[r].drawn->triangle).vertex;
      runs.put(r, {&values[v[0]].x, &values[v[1]].x, &values[v[2]].x}, 1);
    }
    runs.interpolate(span, out);
  };
  RunAttribute<3> normals;
  for (int r = 0; r < span.run_count; ++r) {
    const Run& run = span.runs[r];
    // In a fine mesh each run's vertices are elsewhere in memory.
    if (r + ahead < span.run_count) prefetch(mesh, span.runs[r + ahead].drawn->triangle, positions);
    const auto& v = Corners(mesh, run.drawn->triangle).vertex;
    normals.put(r, {&mesh.normals[v[0]].x, &mesh.normals[v[1]].x, &mesh.normals[v[2]].x},
                run.back_facing ? -1.0f : 1.0f);
  }
  normals.interpolate(span, surface.normal);
  if (positions) interpolate(mesh.positions, surface.position);
  if (tangents) interpolate(mesh.tangents, surface.tangent);
  if (points && !mesh.texcoords.empty()) interpolate(mesh.texcoords, surface.texcoord);
  if (points && !mesh.colours.empty()) interpolate(mesh.colours, surface.colour);
  if (points && span.with_derivatives && !mesh.texcoords.empty())
    for (int r = 0; r < span.run_count; ++r)
      interpolate_growth(span, span.runs[r], Corners(mesh, span.runs[r].drawn->triangle).vertex,
                         surface);
  surface.size = span.size;
  surface.pixel = span.pixel;
  surface.with_derivatives = span.with_derivatives;
  // The spans of other objects have left theirs there.
  if (points && mesh.texcoords.empty())
    for (auto* array : {&surface.texcoord, &surface.texcoord_dx, &surface.texcoord_dy})
      fill(*array, 0);
  if (points && mesh.colours.empty()) fill(surface.colour, 1);
}

}  // namespace scanlit
