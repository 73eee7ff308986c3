#include "rasterizer/planes.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "rasterizer/doubles.h"

namespace scanlit {

namespace {

using Ints = hn::RebindToSigned<Batch::Tag>;
using IntVector = hn::Vec<Ints>;
constexpr Ints ints;

IntVector centre(IntVector pixel) {
  return hn::Add(hn::ShiftLeft<8>(pixel), hn::Set(ints, half_pixel));
}
IntVector least(const IntVector (&v)[3]) { return hn::Min(v[0], hn::Min(v[1], v[2])); }
IntVector most(const IntVector (&v)[3]) { return hn::Max(v[0], hn::Max(v[1], v[2])); }
Batch in_float(IntVector v) { return hn::ConvertTo(Batch::tag, v); }

/// The edge functions of a vector of triangles at the pixel in the middle of their boxes, where
/// numbers stay small, and by how much they grow with the pixel on the right and the one below.
/// Exact before they are rounded (see Viewport).
struct Edges {
  IntVector column, row;  // of that pixel
  Batch at_origin[3], right[3], below[3];
  Batch twice_area;  // their sum, everywhere

  Edges(const IntVector (&x)[3], const IntVector (&y)[3])
      : column(hn::ShiftRight<9>(hn::Add(least(x), most(x)))),
        row(hn::ShiftRight<9>(hn::Add(least(y), most(y)))) {
    const auto to_corner = [](IntVector corner, IntVector pixel) {
      return Doubles::from(hn::Sub(corner, centre(pixel)));
    };
    const Doubles dx[3] = {to_corner(x[0], column), to_corner(x[1], column),
                           to_corner(x[2], column)};
    const Doubles dy[3] = {to_corner(y[0], row), to_corner(y[1], row), to_corner(y[2], row)};
    Doubles sum = 0;
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
      const int from = (k + 1) % 3, to = (k + 2) % 3;
      const Doubles exact = dx[to] * dy[from] - dy[to] * dx[from];
      sum = sum + exact;
      at_origin[k] = exact.rounded();
      right[k] = in_float(hn::Sub(y[to], y[from])) * Batch(subpixel);
      below[k] = in_float(hn::Sub(x[from], x[to])) * Batch(subpixel);
    }
    twice_area = sum.rounded();
  }
};

}  // namespace

/// Of a vector of triangles.
struct TrianglePlanes::Corners {
  IntVector x[3], y[3];
  Batch inv_w[3];

  Corners(const ScreenVertex (&vertices)[3][FragmentSpan::padded], int i, bool perspective) {
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
      Batch::Vector vx, vy, depth, w;
      hn::LoadInterleaved4(Batch::tag, reinterpret_cast<const float*>(&vertices[k][i]), vx, vy,
                           depth, w);
      x[k] = hn::BitCast(ints, vx), y[k] = hn::BitCast(ints, vy);
      inv_w[k] = perspective ? Batch(w) : Batch(1);
    }
  }

  /// Where distances differ by more than a factor of 2, or a plane grows by more than 8 times what
  /// the attribute differs by over the width of the triangle's box: rounding errors grow as much.
  Batch::Mask imprecise(const Batch& twice_area) const {
    const auto& [a, b, c] = inv_w;
    const Batch width = in_float(hn::Sub(most(x), least(x)));
    const Batch height = in_float(hn::Sub(most(y), least(y)));
    return (max(a, max(b, c)) > Batch(2) * min(a, min(b, c))) |
           (width * height > Batch(16) * abs(twice_area));
  }
};

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
  const std::int32_t* const numbers = number_.data();
  const int base = base_, runs = span.run_count;
  for (int r = 0; r < runs; ++r) {
    const int i = numbers[span.triangle[r]] - base;
    of_run_[0][r] = at_origin_[i], of_run_[1][r] = per_column_[i];
    of_run_[2][r] = per_row_[i], of_run_[3][r] = origin_[i];
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
    new_[count] = id;
    numbers[id] = number < base ? next + count : number;
    count += number < base;
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
    const Corners corners(vertices_, i, perspective);
    const auto& [x, y, inv_w] = corners;
    const Edges edges(x, y);
    const Batch& twice_area = edges.twice_area;
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
    const auto& e = edges.at_origin;
    store_plane(e[0] * share[0] + (e[1] * share[1] + e[2] * share[2]), e, at_origin_);
    store_plane(growth(edges.right), edges.right, per_column_);
    store_plane(growth(edges.below), edges.below, per_row_);
    const Batch inexact = select(corners.imprecise(twice_area), Batch(1), Batch::load(cut_ + i));
    store({in_float(edges.column), in_float(edges.row), facing, inexact}, origin_);
  }
}

/// What is the same along each run.
void TrianglePlanes::put_rows(FragmentSpan& span) {
  const hn::RebindToUnsigned<Batch::Tag> unsigneds;
  for (int r = 0; r < span.run_count; r += Batch::lanes) {
    const auto load = [&](int part, Batch(&v)[4]) {
      hn::LoadInterleaved4(Batch::tag, of_run_[part][r].v, v[0].raw, v[1].raw, v[2].raw, v[3].raw);
    };
    Batch at_origin[4], per_column[4], per_row[4], origin[4];
    load(0, at_origin), load(1, per_column), load(2, per_row), load(3, origin);
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
