#include "rasterizer/scan_conversion.h"

#include <bit>

#include "rasterizer/batch.h"
#include "rasterizer/coarse_depth.h"
#include "rasterizer/row_spans.h"
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

  /// Pixels [first, end) of a row, counted from the one whose depth is `anchor`, at depth and id.
  void write(int first, int end, float anchor, float* depth, TriangleId* id) const {
    // The compiler cannot know that what is written is not what it reads.
    const Batch start(anchor), per_pixel = per_pixel_, least = min_, most = max_, past(end);
    const auto own_id = id_;
    Batch steps = Batch::iota(float(first));
    for (int i = first; i < end; i += lanes, depth += lanes, id += lanes) {
      const Batch z = min(max(start + steps * per_pixel, least), most);
      const Batch stored = Batch::load(depth);
      const Batch::Mask covered = steps < past;
      steps += Batch(lanes);
      const Batch::Mask not_behind = covered & (z >= stored);
      if (none(not_behind)) continue;
      Batch::Mask nearer = covered & (z > stored);
      if (bits_of(nearer) != bits_of(not_behind))
        nearer = nearer | first_of_equals(not_behind & (z <= stored) & (z > Batch(0)), id);
      select(nearer, z, stored).store(depth);
      auto* id_bits = reinterpret_cast<std::int32_t*>(id);
      const auto mask = hn::RebindMask(ints, nearer.raw);
      hn::StoreU(hn::IfThenElse(mask, own_id, hn::LoadU(ints, id_bits)), ints, id_bits);
    }
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

void draw(const ScreenTriangle& triangle, const Drawn& drawn, const Target& target) {
  const DepthPlane plane(triangle);
  const RowWriter writer(plane, drawn);
  const RowSpans spans(triangle, plane);
  Rect part = intersection(target.rect, centre_bounds(triangle));
  if (target.columns) {
    part.y_begin = std::max(part.y_begin, target.columns->first_row);
    part.y_end = std::min(part.y_end, target.columns->end_row);
  }
  for (int first_row = part.y_begin; first_row < part.y_end; first_row += lanes) {
    const RowSpans::Rows rows = spans.from(first_row);
    for (int y = first_row; y < std::min(first_row + lanes, part.y_end); ++y) {
      const int begin = rows.begin[y - first_row], end = rows.end[y - first_row];
      int first = std::max(begin, part.x_begin), last = std::min(end, part.x_end);
      if (target.columns) {
        const auto& range = target.columns->at_row(y);
        first = std::max(first, range.begin), last = std::min(last, range.end);
      }
      // Anchored at the span's own first pixel, also where that is left of the tile: depth does not
      // depend on how the picture is cut into tiles.
      const float anchor = rows.depth[y - first_row];
      if (first >= last) continue;
      const auto at = target.offset(first, y);
      writer.write(first - begin, last - begin, anchor, target.depth + at, target.triangle + at);
    }
  }
}

}  // namespace

void VisibilityTile::reset(const Rect& tile, const Rect& touched_pixels, int sample_count) {
  rect = tile;
  touched = touched_pixels;
  triangles.clear();
  only_draw = no_id;
  samples = sample_count;
  const int width = tile.x_end - tile.x_begin, height = tile.y_end - tile.y_begin;
  // Rows begin at a line of the cache; a vector that starts at a row's last pixel must stay inside
  // the arrays.
  stride = (width + 2 * lanes - 1) / lanes * lanes;
  const auto size = std::size_t(stride) * std::size_t(height * samples);
  if (depth.size() < size) depth.resize(size), triangle.resize(size);
  const auto none = hn::Set(ints, std::int32_t(no_triangle));
  const int first_x = touched.x_begin - (touched.x_begin - rect.x_begin) % lanes;
  for (int s = 0; s < samples; ++s)
    for (int y = touched.y_begin; y < touched.y_end; ++y) {
      const std::size_t first = row(s, y) - std::size_t(rect.x_begin);
      for (int x = first_x; x < touched.x_end; x += lanes) {
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
  const ScreenTriangle triangle = screen_triangle(v[0], v[1], v[2]);
  const auto draw_sample = [&](const ScreenTriangle& seen, int sample) {
    const std::size_t row = visibility.row(sample, visibility.rect.y_begin);
    draw(seen, {visibility.triangles, id},
         {visibility.rect, visibility.depth.data() + row, visibility.triangle.data() + row,
          visibility.stride, columns});
  };
  if (visibility.samples == 1) return draw_sample(triangle, 0);
  for (int sample = 0; sample < visibility.samples; ++sample)
    draw_sample(moved(triangle, offsets[std::size_t(sample)]), sample);
}

}  // namespace scanlit
