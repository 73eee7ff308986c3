#include "rasterizer/scan_conversion.h"

#include <bit>

#include "rasterizer/batch.h"
#include "rasterizer/coarse_depth.h"
#include "rasterizer/scalar_math.h"

namespace scanlit {

namespace {

constexpr int lanes = Batch::lanes;
using Ints = hn::RebindToSigned<Batch::Tag>;
constexpr Ints ints;

/// A triangle of a tile.
struct Drawn {
  const std::vector<const DrawnTriangle*>& triangles;  // of the tile
  TriangleId id;                                       // in them

  /// Whether this one stays where it is as deep as another.
  bool drawn_before(TriangleId other) const {
    return scanlit::drawn_before(*triangles[id], *triangles[other]);
  }
};

/// Writes the nearer of what a row holds and what a triangle puts there. Vectors are loaded,
/// blended and stored whole: masked stores are many times slower on some processors.
class RowWriter {
 public:
  RowWriter(const DepthPlane& plane, const Drawn& drawn)
      : per_pixel_(plane.per_pixel()),
        min_(plane.min()),
        max_(plane.max()),
        drawn_(drawn),
        id_(hn::Set(ints, std::int32_t(drawn.id))) {}

  /// Lanes `covered` of the `lanes` pixels at depth and id; `steps` is each lane's distance in
  /// pixels from the one whose depth is `anchor`.
  void write(Batch::Mask covered, Batch steps, float anchor, float* depth, TriangleId* id) const {
    const Batch z = min(max(Batch(anchor) + steps * per_pixel_, min_), max_);
    const Batch stored = Batch::load(depth);
    Batch::Mask nearer = covered & (z > stored);
    const Batch::Mask equal = covered & Batch::Mask{hn::Eq(z.raw, stored.raw)};
    if (!none(equal)) nearer = nearer | first_of_equals(equal & (z > Batch(0)), id);
    if (none(nearer)) return;
    select(nearer, z, stored).store(depth);
    auto* id_bits = reinterpret_cast<std::int32_t*>(id);
    const auto mask = hn::RebindMask(ints, nearer.raw);
    hn::StoreU(hn::IfThenElse(mask, id_, hn::LoadU(ints, id_bits)), ints, id_bits);
  }

 private:
  /// The lanes of `equal` where this triangle was drawn before the one that is there. Triangles
  /// come in any order, and rarely meet at equal depth.
  Batch::Mask first_of_equals(Batch::Mask equal, const TriangleId* ids) const {
    float before[lanes] = {};
    for (unsigned bits = bits_of(equal); bits != 0; bits &= bits - 1) {
      const int i = std::countr_zero(bits);
      before[i] = drawn_.drawn_before(ids[i]) ? 1.0f : 0.0f;
    }
    return Batch::load(before) > Batch(0);
  }

  Batch per_pixel_, min_, max_;
  const Drawn& drawn_;
  hn::Vec<Ints> id_;
};

/// Where one sample's plane of a tile is, and which rows and columns it has.
struct Target {
  Rect rect;
  float* depth;
  TriangleId* triangle;
  int stride;
  const VisibleColumns* columns;  // outside of which nothing need be drawn; or null

  std::ptrdiff_t offset(int x, int y) const {
    return std::ptrdiff_t(y - rect.y_begin) * stride + (x - rect.x_begin);
  }
};

/// Span by span: for triangles that are wide.
void draw_spans(const ScreenTriangle& triangle, const Drawn& drawn, const Target& target) {
  const DepthPlane plane(triangle);
  const RowWriter writer(plane, drawn);
  const DepthPlane::Rows depth(plane);
  Rect rows = target.rect;
  if (target.columns) {
    rows.y_begin = std::max(rows.y_begin, target.columns->first_row);
    rows.y_end = std::min(rows.y_end, target.columns->end_row);
  }
  for_each_span(triangle, rows.y_begin, rows.y_end, [&](int y, int begin, int end) {
    int first = std::max(begin, target.rect.x_begin), last = std::min(end, target.rect.x_end);
    if (target.columns) {
      const auto& range = target.columns->at_row(y);
      first = std::max(first, range.begin), last = std::min(last, range.end);
    }
    if (first >= last) return;
    // Anchored at the span's own first pixel, also where that is left of the tile: depth does not
    // depend on how the picture is cut into tiles.
    const float anchor = depth.at(begin, y);
    for (int x = first; x < last; x += lanes) {
      const Batch steps = Batch::iota(float(x - begin));
      const auto at = target.offset(x, y);
      writer.write(steps < Batch(float(last - begin)), steps, anchor, target.depth + at,
                   target.triangle + at);
    }
  });
}

/// The three edge functions of a triangle over a small box, positive or zero inside.
struct SmallEdges {
  std::int32_t first[3];  // at the box's first pixel centre
  std::int32_t per_column[3], per_row[3];

  SmallEdges(const ScreenTriangle& triangle, const Rect& box) {
    const auto& v = triangle.vertices;
    const int sign = triangle.twice_area > 0 ? 1 : -1;
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const ScreenVertex &from = v[i], &to = v[i == 2 ? 0 : i + 1];
      const std::int32_t dx = sign * (to.x - from.x), dy = sign * (to.y - from.y);
      // A centre exactly on an edge counts for left edges (running down) and the top edge (running
      // left) alone: for the others 0 becomes -1.
      const bool top_left = (dy > 0) | ((dy == 0) & (dx < 0));
      first[i] = dy * (box.x_begin * subpixel + half_pixel - from.x) -
                 dx * (box.y_begin * subpixel + half_pixel - from.y) - (top_left ? 0 : 1);
      per_column[i] = dy * subpixel;
      per_row[i] = -dx * subpixel;
    }
  }
};

/// Lanes where none of three edge functions is negative.
Batch::Mask inside(const hn::Vec<Ints> (&edge)[3]) {
  // The sign bit of the three together is set where any of them is negative.
  const auto any_negative = hn::Or(edge[0], hn::Or(edge[1], edge[2]));
  return {hn::RebindMask(Batch::tag, hn::Gt(any_negative, hn::Set(ints, -1)))};
}

/// Row by row with the edge functions of all of a row's pixels at once: for triangles so small that
/// following their edges costs more than testing every pixel of their box. Covers exactly what
/// draw_spans covers, at the same depths.
void draw_small(const ScreenTriangle& triangle, const Drawn& drawn, const Rect& box,
                const Target& target) {
  const DepthPlane plane(triangle);
  const RowWriter writer(plane, drawn);
  const SmallEdges edges(triangle, box);
  hn::Vec<Ints> per_lane[3];
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i)
    per_lane[i] = hn::Mul(hn::Iota(ints, 0), hn::Set(ints, edges.per_column[i]));
  for (int y = box.y_begin; y < box.y_end; ++y) {
    float anchor = 0;
    int anchor_x = box.x_end;
    for (int x = box.x_begin; x < box.x_end; x += lanes) {
      hn::Vec<Ints> edge[3];
#pragma GCC unroll 3
      for (int i = 0; i < 3; ++i)
        edge[i] = hn::Add(hn::Set(ints, edges.first[i] + (y - box.y_begin) * edges.per_row[i] +
                                            (x - box.x_begin) * edges.per_column[i]),
                          per_lane[i]);
      const Batch::Mask in_box =
          Batch::iota(float(x - box.x_begin)) < Batch(float(box.x_end - box.x_begin));
      const Batch::Mask covered = inside(edge) & in_box;
      if (none(covered)) continue;
      if (anchor_x == box.x_end) {
        anchor_x = x + int(hn::FindFirstTrue(Batch::tag, covered.raw));
        anchor = plane.at(anchor_x, y);
      }
      const auto at = target.offset(x, y);
      writer.write(covered, Batch::iota(float(x - anchor_x)), anchor, target.depth + at,
                   target.triangle + at);
    }
  }
}

void draw(const ScreenTriangle& triangle, const Drawn& drawn, const Target& target) {
  const Rect box = centre_bounds(triangle);
  if (!in_small_box(box, target.rect)) return draw_spans(triangle, drawn, target);
  const Rect part{box.x_begin, std::max(box.y_begin, target.rect.y_begin),
                  std::min(box.x_end, target.rect.x_end), std::min(box.y_end, target.rect.y_end)};
  draw_small(triangle, drawn, part, target);
}

}  // namespace

void VisibilityTile::reset(const Rect& tile, const Rect& touched_pixels, int sample_count) {
  rect = tile;
  touched = touched_pixels;
  triangles.clear();
  samples = sample_count;
  const int width = tile.x_end - tile.x_begin, height = tile.y_end - tile.y_begin;
  // A vector that starts at a row's last pixel must stay inside the arrays.
  stride = width + lanes;
  const auto size = std::size_t(stride) * std::size_t(height * samples);
  if (depth.size() < size) depth.resize(size), triangle.resize(size);
  const auto none = hn::Set(ints, std::int32_t(no_triangle));
  for (int s = 0; s < samples; ++s)
    for (int y = touched.y_begin; y < touched.y_end; ++y) {
      const std::size_t first = row(s, y) - std::size_t(rect.x_begin);
      for (int x = touched.x_begin; x < touched.x_end; x += lanes) {
        Batch(0).store(&depth[first + std::size_t(x)]);
        hn::StoreU(none, ints, reinterpret_cast<std::int32_t*>(&triangle[first + std::size_t(x)]));
      }
    }
}

std::span<const SampleOffset> sample_offsets(int samples) {
  static constexpr SampleOffset one[] = {{0, 0}};
  static constexpr SampleOffset four[] = {{-32, -96}, {96, -32}, {-96, 32}, {32, 96}};
  static constexpr SampleOffset eight[] = {{16, -48}, {-16, 48},   {80, 16},  {-48, -80},
                                           {-80, 80}, {-112, -16}, {48, 112}, {112, -112}};
  static constexpr SampleOffset sixteen[] = {{16, 16},   {-16, -48}, {-48, 32},  {64, -16},
                                             {-80, -32}, {32, 80},   {80, 48},   {48, -80},
                                             {-32, 96},  {0, -112},  {-64, -96}, {-96, 64},
                                             {-128, 0},  {112, -64}, {96, 112},  {-112, -128}};
  switch (samples) {
    case 4: return four;
    case 8: return eight;
    case 16: return sixteen;
    default: return one;
  }
}

void scan_convert(TriangleId id, VisibilityTile& visibility, const VisibleColumns* columns) {
  const DrawnTriangle& record = *visibility.triangles[id];
  const auto offsets = sample_offsets(visibility.samples);
  const auto& v = record.vertices;
  ScreenTriangle triangle = screen_triangle(v[0], v[1], v[2]);
  const auto draw_sample = [&](int sample) {
    const std::size_t row = visibility.row(sample, visibility.rect.y_begin);
    draw(triangle, {visibility.triangles, id},
         {visibility.rect, visibility.depth.data() + row, visibility.triangle.data() + row,
          visibility.stride, columns});
  };
  if (visibility.samples == 1) return draw_sample(0);
  // Moving the triangle by minus the offset puts the sample where the centre was.
  SampleOffset moved{0, 0};
  for (int sample = 0; sample < visibility.samples; ++sample) {
    const SampleOffset& to = offsets[std::size_t(sample)];
    for (ScreenVertex& vertex : triangle.vertices)
      vertex.x += moved.x - to.x, vertex.y += moved.y - to.y;
    moved = to;
    draw_sample(sample);
  }
}

}  // namespace scanlit
