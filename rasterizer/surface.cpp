#include "rasterizer/surface.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "rasterizer/planes.h"
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

/// What only some models need.
void put_others(const Mesh& mesh, const Needs& needs, std::span<const std::size_t> vertices, int i,
                SurfaceSpan& surface) {
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

constexpr int ahead = 8;  // runs, or vertices: about as long as memory takes to answer

/// An attribute of the mesh's vertices.
template <class V>
void interpolate(const std::vector<V>& values, const FragmentSpan& span,
                 float (&out)[std::size_t(V::length())][SurfaceSpan::padded],
                 const float* sign = nullptr) {
  RunAttribute attribute;
  const auto corners = [&](int r) {
    return &span.draw->mesh->indices[3 * std::size_t(span.runs[r].drawn->triangle)];
  };
  for (int r = 0; r < span.run_count; ++r) {
    if (r + ahead < span.run_count) {  // in a fine mesh each run's vertices are elsewhere in memory
      const std::uint32_t* const v = corners(r + ahead);
      hwy::Prefetch(&values[v[0]]), hwy::Prefetch(&values[v[1]]), hwy::Prefetch(&values[v[2]]);
    }
    const std::uint32_t* const v = corners(r);
    attribute.put(r, values[v[0]], values[v[1]], values[v[2]]);
  }
  attribute.interpolate(span, out, sign);
}

/// Of a mesh whose triangles have one normal each, on the viewer's side.
void spread_normals(const FragmentSpan& span, float (&out)[3][SurfaceSpan::padded]) {
  const Mesh& mesh = *span.draw->mesh;
  FragmentSpan::PerRun normals[3];
  for (int r = 0; r < span.run_count; ++r) {
    const glm::vec3 normal =
        mesh.normals[mesh.indices[3 * std::size_t(span.runs[r].drawn->triangle)]];
    for (int c = 0; c < 3; ++c) normals[c][r] = span.facing[r] * normal[c];
  }
  for (int i = 0; i < span.size; i += Batch::lanes) {
    const OfRuns of(span.run + i);
    for (int c = 0; c < 3; ++c) of(normals[c]).store(out[c] + i);
  }
}

/// On the viewer's side. Gouraud's planes are colours.
void interpolate_normals(const FragmentSpan& span, SurfaceSpan& surface) {
  const Mesh& mesh = *span.draw->mesh;
  if (span.draw->object->shading == Shading::gouraud)
    return interpolate(mesh.normals, span, surface.normal, span.facing);
  if (span.draw->clusters->flat) return spread_normals(span, surface.normal);
  for (int i = 0; i < span.size; i += Batch::lanes) {
    const OnPlanes at(span, i);
#pragma GCC unroll 3
    for (int c = 0; c < 3; ++c) at(c).store(surface.normal[c] + i);
  }
  for (const int r : span.exact) {
    const auto& [a, b, c] = Corners(mesh, span.runs[r].drawn->triangle).vertex;
    const float sign = span.facing[r];
    interpolate_run(span, span.runs[r], sign * mesh.normals[a], sign * mesh.normals[b],
                    sign * mesh.normals[c], surface.normal);
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

void put_sites(const Draw& draw, const Needs& needs, std::span<const LitSites::Site> sites,
               SurfaceSpan& surface) {
  const Mesh& mesh = *draw.mesh;
  const bool others = needs_points(needs) || needs.frame;
  surface.size = int(sites.size());
  for (int i = 0; i < surface.size; ++i) {
    const auto [element, from_behind] = sites[std::size_t(i)];
    const float sign = from_behind ? -1.0f : 1.0f;
    if (draw.object->shading == Shading::flat) {
      const auto [centroid, normal] = face(mesh, element);
      put(centroid, i, surface.position);
      put(sign * normal, i, surface.normal);
      if (others) put_others(mesh, needs, Corners(mesh, element).vertex, i, surface);
    } else {
      const std::uint32_t later = sites[std::size_t(std::min(i + ahead, surface.size - 1))].element;
      hwy::Prefetch(&mesh.positions[later]), hwy::Prefetch(&mesh.normals[later]);
      const std::size_t vertex = element;
      put(mesh.positions[vertex], i, surface.position);
      put(sign * mesh.normals[vertex], i, surface.normal);
      if (others) put_others(mesh, needs, {&vertex, 1}, i, surface);
    }
  }
}

void interpolate_surface(const FragmentSpan& span, SurfaceSpan& surface) {
  const Mesh& mesh = *span.draw->mesh;
  const Needs needs = span.draw->object->material.model->needs();
  const bool points = needs_points(needs), tangents = needs.frame && follows_texcoord(*span.draw);
  const bool positions = span.draw->illumination.needs_position;
  interpolate_normals(span, surface);
  if (positions) interpolate(mesh.positions, span, surface.position);
  if (tangents) interpolate(mesh.tangents, span, surface.tangent);
  if (points && !mesh.texcoords.empty()) interpolate(mesh.texcoords, span, surface.texcoord);
  if (points && !mesh.colours.empty()) interpolate(mesh.colours, span, surface.colour);
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
