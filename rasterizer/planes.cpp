#include "rasterizer/planes.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "rasterizer/corner_vectors.h"
#include "rasterizer/quads.h"

namespace scanlit {

namespace {

constexpr auto ints = CornerVectors::ints;

Batch in_float(CornerVectors::IntVector v) { return hn::ConvertTo(Batch::tag, v); }

/// Where distances differ by more than a factor of 2, or a plane grows by more than 16 times what
/// the attribute differs by over the triangle's box: rounding errors grow as much. Within these
/// limits they are at most 2e-6 of the attribute (ColoursAndNormalsEqualRayAndPlane).
Batch::Mask imprecise(const CornerVectors& corners, const Batch& twice_area) {
  const auto& [a, b, c] = corners.inv_w;
  const Batch box = in_float(corners.width()) * in_float(corners.height());
  return (max(a, max(b, c)) > Batch(2) * min(a, min(b, c))) | (box > Batch(16) * abs(twice_area));
}

}  // namespace

void TrianglePlanes::begin(std::size_t triangles) {
  if (next_ > 1 << 30) number_.clear(), next_ = 0;
  if (number_.size() < triangles) number_.resize(triangles, -1);
  base_ = next_;
}

void TrianglePlanes::put(const Frame& frame, const VisibilityTile& visibility, FragmentSpan& span) {
  if (next_ - base_ + span.run_count > capacity) base_ = next_;
  const int first = next_ - base_, count = number(span);
  if (count > 0) {
    copy_corners(frame, visibility, span, count);
    make(frame, span, count, first);
  }
  put_rows(span);
}

/// Numbers triangles that have no planes yet; returns how many.
int TrianglePlanes::number(const FragmentSpan& span) {
  const int base = base_, next = next_;
  std::int32_t* const numbers = number_.data();
  int count = 0;
  for (int r = 0; r < span.run_count; ++r) {  // whether one is new cannot be foreseen: no branch
    const TriangleId id = span.triangle[r];
    const std::int32_t number = numbers[id];
    const bool is_new = number < base;
    const std::int32_t now = is_new ? next + count : number;
    new_[count] = id;
    numbers[id] = now;
    place_[r] = now - base;
    count += is_new;
  }
  next_ += count;
  return count;
}

void TrianglePlanes::copy_corners(const Frame& frame, const VisibilityTile& visibility,
                                  const FragmentSpan& span, int count) {
  constexpr int ahead = 16;  // about as long as memory takes to answer
  const bool gouraud = span.draw->object->shading == Shading::gouraud;
  const Mesh& mesh = *span.draw->mesh;
  for (int i = 0; i < count; ++i) {
    hwy::Prefetch(visibility.triangles[new_[std::min(i + ahead, count - 1)]]);
    const DrawnTriangle& drawn = *visibility.triangles[new_[i]];
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) vertices_[k][i] = drawn.vertices[k];
    cut_[i] = drawn.piece == DrawnTriangle::not_cut ? 0 : 1;
    if (gouraud) {
      const Chunk& chunk = frame.chunks[drawn.chunk];
      hwy::Prefetch(&chunk.lit.corners[3 * chunk.number_of(drawn)]);
    } else {
      hwy::Prefetch(&mesh.indices[3 * std::size_t(drawn.triangle)]);
    }
  }
  const auto vertices = [&](int i) {
    return &mesh.indices[3 * std::size_t(visibility.triangles[new_[i]]->triangle)];
  };
  for (int i = 0; i < count; ++i) {
    if (gouraud) {
      const DrawnTriangle& drawn = *visibility.triangles[new_[i]];
      const Chunk& chunk = frame.chunks[drawn.chunk];
      const std::uint16_t* const site = &chunk.lit.corners[3 * chunk.number_of(drawn)];
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        std::memcpy(&values_[k][i], &chunk.lit.colour[site[k]], sizeof(glm::vec4));
    } else {
      const std::uint32_t* const vertex = vertices(i);
      const std::uint32_t* const later = vertices(std::min(i + ahead / 2, count - 1));
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k) hwy::Prefetch(&mesh.normals[later[k]]);
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        std::memcpy(&values_[k][i], &mesh.normals[vertex[k]], sizeof(glm::vec3));
    }
  }
}

/// From place `first` on. At a point of the screen an attribute is q0 + b1 (q1 - q0) + b2 (q2 - q0)
/// with b_k = e_k / (e_0 + e_1 + e_2), e_k the edge function over w of the corner: the sum, and the
/// attribute times the sum, are planes.
void TrianglePlanes::make(const Frame& frame, const FragmentSpan& span, int count, int first) {
  const bool perspective = frame.settings.interpolation == Interpolation::perspective;
  const bool colours = span.draw->object->shading == Shading::gouraud;
  const float front = span.draw->mirrored ? -1 : 1;
  for (int i = 0; i < count; i += Batch::lanes) {
    const CornerVectors corners(vertices_, i, perspective);
    const auto& inv_w = corners.inv_w;
    // In the middle of the box: numbers stay small.
    const auto column = corners.middle_column(), row = corners.middle_row();
    const auto [f0, f1, f2] = corners.edges_at(column, row);
    const Batch edges[3] = {f0.rounded(), f1.rounded(), f2.rounded()};
    const Batch right[3] = {corners.growth_right(0), corners.growth_right(1),
                            corners.growth_right(2)};
    const Batch below[3] = {corners.growth_below(0), corners.growth_below(1),
                            corners.growth_below(2)};
    const Batch twice_area = (f0 + f1 + f2).rounded();
    const Batch scale = Batch(1) / twice_area / max(inv_w[0], max(inv_w[1], inv_w[2]));
    const Batch share[3] = {inv_w[0] * scale, inv_w[1] * scale, inv_w[2] * scale};
    const Batch facing = select(twice_area < Batch(0), -front, front);
    const Batch sign = colours ? Batch(1) : facing;
    Batch q[3][4];
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
      hn::LoadInterleaved4(Batch::tag, values_[k][i].v, q[k][0].raw, q[k][1].raw, q[k][2].raw,
                           q[k][3].raw);
    const auto store = [&](const Batch(&v)[4], Quad* to) {
      hn::StoreInterleaved4(v[0].raw, v[1].raw, v[2].raw, v[3].raw, Batch::tag, to[first + i].v);
    };
    const auto store_plane = [&](const Batch& all, const Batch(&e)[3], Quad* to) {
      const Batch e1 = e[1] * share[1], e2 = e[2] * share[2];
      Batch plane[4] = {0, 0, 0, all};
#pragma GCC unroll 3
      for (int c = 0; c < 3; ++c)
        plane[c] =
            sign * mul_add(q[0][c], all, mul_add(q[1][c] - q[0][c], e1, (q[2][c] - q[0][c]) * e2));
      store(plane, to);
    };
    // The sum grows by differences of 1/w alone: where they are equal, not at all.
    const auto growth = [&](const Batch(&e)[3]) {
      return e[1] * (share[1] - share[0]) + e[2] * (share[2] - share[0]);
    };
    store_plane(edges[0] * share[0] + (edges[1] * share[1] + edges[2] * share[2]), edges,
                at_origin_);
    store_plane(growth(right), right, per_column_);
    store_plane(growth(below), below, per_row_);
    const Batch inexact = select(imprecise(corners, twice_area), Batch(1), Batch::load(cut_ + i));
    store({in_float(column), in_float(row), facing, inexact}, origin_);
  }
}

/// What is the same along each run.
void TrianglePlanes::put_rows(FragmentSpan& span) {
  const hn::RebindToUnsigned<Batch::Tag> unsigneds;
  for (int r = 0; r < span.run_count; r += Batch::lanes) {
    const auto load = [&](const Quad* quads, Batch(&v)[4]) {
      load_quads([&](int lane) { return quads[place_[r + lane]].v; }, v);
    };
    Batch at_origin[4], per_column[4], per_row[4], origin[4];
    load(at_origin_, at_origin), load(per_column_, per_column);
    load(per_row_, per_row), load(origin_, origin);
    const auto pixel = hn::LoadU(unsigneds, span.first_pixel + r);
    const Batch row = hn::ConvertTo(Batch::tag, hn::BitCast(ints, hn::ShiftRight<16>(pixel)));
    const Batch rows = row - origin[1];
    origin[0].store(span.planes.column + r);
    origin[2].store(span.facing + r);
#pragma GCC unroll 4
    for (int c = 0; c < 4; ++c) {
      mul_add(rows, per_row[c], at_origin[c]).store(span.planes.start[c] + r);
      per_column[c].store(span.planes.per_column[c] + r);
    }
    for (unsigned inexact = bits_of(origin[3] > Batch(0)); inexact != 0; inexact &= inexact - 1)
      if (const int run = r + std::countr_zero(inexact); run < span.run_count)
        span.exact.push_back(run);
  }
}

}  // namespace scanlit
