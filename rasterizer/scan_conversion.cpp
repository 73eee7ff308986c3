#include "rasterizer/scan_conversion.h"

#include "rasterizer/batch.h"
#include "rasterizer/scalar_math.h"

namespace scanlit {

namespace {

constexpr int lanes = Batch::lanes;
using Ints = hn::RebindToSigned<Batch::Tag>;
constexpr Ints ints;

/// Writes the nearer of what a row holds and what a triangle puts there. Vectors are loaded,
/// blended and stored whole: masked stores are many times slower on some processors.
class RowWriter {
 public:
  RowWriter(const DepthPlane& plane, TriangleId id)
      : per_pixel_(plane.per_pixel()),
        min_(plane.min()),
        max_(plane.max()),
        id_(hn::Set(ints, std::int32_t(id))) {}

  /// Lanes `covered` of the `lanes` pixels at depth and id; `steps` is each lane's distance in
  /// pixels from the one whose depth is `anchor`.
  void write(Batch::Mask covered, Batch steps, float anchor, float* depth, TriangleId* id) const {
    const Batch z = min(max(Batch(anchor) + steps * per_pixel_, min_), max_);
    const Batch stored = Batch::load(depth);
    const Batch::Mask nearer = covered & (z > stored);
    if (none(nearer)) return;
    select(nearer, z, stored).store(depth);
    auto* id_bits = reinterpret_cast<std::int32_t*>(id);
    const auto mask = hn::RebindMask(ints, nearer.raw);
    hn::StoreU(hn::IfThenElse(mask, id_, hn::LoadU(ints, id_bits)), ints, id_bits);
  }

 private:
  Batch per_pixel_, min_, max_;
  hn::Vec<Ints> id_;
};

/// Where one sample's plane of a tile is, and which rows and columns it has.
struct Target {
  Rect rect;
  float* depth;
  TriangleId* triangle;
  int stride;

  std::ptrdiff_t offset(int x, int y) const {
    return std::ptrdiff_t(y - rect.y_begin) * stride + (x - rect.x_begin);
  }
};

/// Span by span: for triangles that are wide.
void draw_spans(const ScreenTriangle& triangle, TriangleId id, const Target& target) {
  const DepthPlane plane(triangle);
  const RowWriter writer(plane, id);
  for_each_span(triangle, target.rect.y_begin, target.rect.y_end, [&](int y, int begin, int end) {
    // Anchored at the span's own first pixel, also where that is left of the tile: depth does not
    // depend on how the picture is cut into tiles.
    const float anchor = plane.at(begin, y);
    const int first = std::max(begin, target.rect.x_begin);
    const int last = std::min(end, target.rect.x_end);
    for (int x = first; x < last; x += lanes) {
      const Batch steps = Batch::iota(float(x - begin));
      const auto at = target.offset(x, y);
      writer.write(steps < Batch(float(last - begin)), steps, anchor, target.depth + at,
                   target.triangle + at);
    }
  });
}

/// A box of at most 16 x 16 pixels: edge functions are below 2^27 there, and 32 bits hold them.
constexpr int small_size = 16;

/// Row by row with the edge functions of all of a row's pixels at once: for triangles so small that
/// following their edges costs more than testing every pixel of their box. Covers exactly what
/// draw_spans covers, at the same depths.
void draw_small(const ScreenTriangle& triangle, TriangleId id, const Rect& box,
                const Target& target) {
  const DepthPlane plane(triangle);
  const RowWriter writer(plane, id);
  const auto& v = triangle.vertices;
  const int sign = triangle.twice_area > 0 ? 1 : -1;
  std::int32_t value[3], per_row[3];
  hn::Vec<Ints> per_lane[3];
  for (int i = 0; i < 3; ++i) {
    const ScreenVertex &from = v[i], &to = v[(i + 1) % 3];
    const std::int32_t dx = sign * (to.x - from.x), dy = sign * (to.y - from.y);
    // A centre exactly on an edge counts for left edges (running down) and the top edge (running
    // left) alone: for the others 0 becomes -1.
    const bool top_left = dy > 0 || (dy == 0 && dx < 0);
    value[i] = dy * (box.x_begin * subpixel + half_pixel - from.x) -
               dx * (box.y_begin * subpixel + half_pixel - from.y) - (top_left ? 0 : 1);
    per_row[i] = -dx * subpixel;
    per_lane[i] = hn::Mul(hn::Iota(ints, 0), hn::Set(ints, dy * subpixel));
  }
  for (int y = box.y_begin; y < box.y_end; ++y) {
    float anchor = 0;
    int anchor_x = box.x_end;
    for (int x = box.x_begin; x < box.x_end; x += lanes) {
      // The sign bit of the three together is set where any of them is negative.
      auto any_negative = hn::Zero(ints);
      for (int i = 0; i < 3; ++i) {
        const std::int32_t dy = sign * (v[(i + 1) % 3].y - v[i].y);
        const auto start = hn::Set(ints, value[i] + dy * subpixel * (x - box.x_begin));
        any_negative = hn::Or(any_negative, hn::Add(start, per_lane[i]));
      }
      const Batch steps_in_box = Batch::iota(float(x - box.x_begin));
      const Batch::Mask inside_box = steps_in_box < Batch(float(box.x_end - box.x_begin));
      const Batch::Mask covered =
          Batch::Mask{hn::RebindMask(Batch::tag, hn::Gt(any_negative, hn::Set(ints, -1)))} &
          inside_box;
      if (none(covered)) continue;
      if (anchor_x == box.x_end) {
        anchor_x = x + int(hn::FindFirstTrue(Batch::tag, covered.raw));
        anchor = plane.at(anchor_x, y);
      }
      const auto at = target.offset(x, y);
      writer.write(covered, Batch::iota(float(x - anchor_x)), anchor, target.depth + at,
                   target.triangle + at);
    }
    for (int i = 0; i < 3; ++i) value[i] += per_row[i];
  }
}

void draw(const ScreenTriangle& triangle, TriangleId id, const Target& target) {
  const Rect box = centre_bounds(triangle);
  if (box.x_end - box.x_begin > small_size || box.y_end - box.y_begin > small_size)
    return draw_spans(triangle, id, target);
  // The anchor must be the row's first covered pixel, so the box is cut at the tile's rows but, on
  // its left, not at its columns; boxes that straddle tiles go the general way.
  if (box.x_begin < target.rect.x_begin) return draw_spans(triangle, id, target);
  draw_small(triangle, id,
             {box.x_begin, std::max(box.y_begin, target.rect.y_begin),
              std::min(box.x_end, target.rect.x_end), std::min(box.y_end, target.rect.y_end)},
             target);
}

}  // namespace

void VisibilityTile::reset(const Rect& tile, int sample_count) {
  rect = tile;
  samples = sample_count;
  const int width = tile.x_end - tile.x_begin, height = tile.y_end - tile.y_begin;
  // A vector that starts at a row's last pixel must stay inside the arrays.
  stride = width + lanes;
  const auto size = std::size_t(stride) * std::size_t(height * samples);
  depth.assign(size, 0.0f);
  triangle.assign(size, no_triangle);
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

void scan_convert(const Frame& frame, int tile, VisibilityTile& visibility) {
  const auto offsets = sample_offsets(visibility.samples);
  for (const Chunk& chunk : frame.chunks) {
    if (chunk.bins.empty()) continue;
    for (TriangleId id : chunk.bins[std::size_t(tile)]) {
      if (id & is_piece) id += chunk.first_piece;
      const ScreenTriangle triangle = frame.triangle(id);
      for (std::size_t s = 0; s < offsets.size(); ++s) {
        // Moving the triangle by minus the offset puts the sample where the centre was.
        ScreenTriangle moved = triangle;
        for (ScreenVertex& v : moved.vertices) v.x -= offsets[s].x, v.y -= offsets[s].y;
        const std::size_t row = visibility.row(int(s), visibility.rect.y_begin);
        draw(moved, id,
             {visibility.rect, visibility.depth.data() + row, visibility.triangle.data() + row,
              visibility.stride});
      }
    }
  }
}

}  // namespace scanlit
