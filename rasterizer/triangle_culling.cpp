#include "rasterizer/triangle_culling.h"

#include <algorithm>
#include <limits>

#include "rasterizer/batch.h"
#include "rasterizer/compress.h"
#include "rasterizer/scan_conversion.h"

namespace scanlit {

namespace {

using Ints = hn::RebindToSigned<Batch::Tag>;
using IntVector = hn::Vec<Ints>;
using IntMask = hn::Mask<Ints>;
constexpr Ints ints;
constexpr int lanes = Batch::lanes;

/// Triangles whose box is smaller than this have exact edge functions in 32 bits: differences of
/// coordinates are below 2^15, and a difference of two of their products below 2^31.
constexpr std::int32_t small_extent = 1 << 15;

/// One corner of a vector of triangles.
struct Corner {
  IntVector x, y;

  Corner(const ClusterVertices& v, const std::uint8_t* local) {
    const auto index = hn::PromoteTo(ints, hn::LoadU(hn::Rebind<std::uint8_t, Ints>(), local));
    x = hn::GatherIndex(ints, v.x, index);
    y = hn::GatherIndex(ints, v.y, index);
  }
};

/// edge_function(a, b, p).
IntVector edge(const Corner& a, const Corner& b, IntVector px, IntVector py) {
  return hn::Sub(hn::Mul(hn::Sub(b.y, a.y), hn::Sub(px, a.x)),
                 hn::Mul(hn::Sub(b.x, a.x), hn::Sub(py, a.y)));
}

/// Whether the point lies on the inner side of the edge a -> b, or on it where the fill rule
/// (scan_conversion.h) counts that as inside. `flip` is -1 for triangles that go around the other
/// way, else 0.
IntMask covers(const Corner& a, const Corner& b, IntVector px, IntVector py, IntVector flip) {
  const auto oriented = [flip](IntVector v) { return hn::Sub(hn::Xor(v, flip), flip); };
  const auto zero = hn::Zero(ints);
  const IntVector e = oriented(edge(a, b, px, py));
  const IntVector dx = oriented(hn::Sub(b.x, a.x)), dy = oriented(hn::Sub(b.y, a.y));
  const IntMask top_left = hn::Or(hn::Gt(dy, zero), hn::And(hn::Eq(dy, zero), hn::Lt(dx, zero)));
  return hn::Or(hn::Gt(e, zero), hn::And(hn::Eq(e, zero), top_left));
}

IntMask at_least(IntVector a, IntVector b) { return hn::Not(hn::Lt(a, b)); }

template <class Use>
void for_each_lane(IntMask mask, const Use& use) {
  unsigned bits = bits_of(Batch::Mask{hn::RebindMask(Batch::tag, mask)});
  for (; bits != 0; bits &= bits - 1) use(std::countr_zero(bits));
}

}  // namespace

Fate cull(const ScreenTriangle& triangle, const Draw& draw, const Viewport& viewport, int samples) {
  if (triangle.twice_area == 0) return Fate::no_pixel;
  if (!draw.draw_back_faces && (triangle.twice_area < 0) != draw.mirrored) return Fate::back_facing;
  const Rect bounds = pixel_bounds(triangle, samples);
  if (bounds.empty()) return Fate::no_pixel;
  return intersection(bounds, picture_rect(viewport)).empty() ? Fate::outside : Fate::drawn;
}

void cull_cluster(const Draw& draw, const Cluster& cluster, const ClusterVertices& vertices,
                  const Viewport& viewport, int samples, CulledCluster& result) {
  const auto& corners = draw.clusters->corners;
  const int count = int(cluster.triangle_count);
  const auto zero = hn::Zero(ints), one = hn::Set(ints, 1);
  // From a coordinate to the first pixel whose centre (or, of several samples, any) is beyond it.
  const auto up = hn::Set(ints, samples == 1 ? half_pixel - 1 : 0);
  const auto past = hn::Set(ints, samples == 1 ? 0 : 1);
  const auto width = hn::Set(ints, viewport.width), height = hn::Set(ints, viewport.height);
  const auto largest = hn::Set(ints, std::numeric_limits<std::int32_t>::max());
  IntVector least_x = largest, least_y = largest, most_x = zero, most_y = zero, pixels = zero;
  const auto mirrored = hn::Set(ints, draw.mirrored ? -1 : 0);

  for (int k = 0; k < count; k += lanes) {
    const std::size_t first = cluster.first_triangle + std::size_t(k);
    const Corner a(vertices, &corners[0][first]), b(vertices, &corners[1][first]),
        c(vertices, &corners[2][first]);
    IntMask left = hn::Lt(hn::Iota(ints, k), hn::Set(ints, count));
    const auto x_min = hn::Min(a.x, hn::Min(b.x, c.x)), x_max = hn::Max(a.x, hn::Max(b.x, c.x));
    const auto y_min = hn::Min(a.y, hn::Min(b.y, c.y)), y_max = hn::Max(a.y, hn::Max(b.y, c.y));

    const auto extent = hn::Max(hn::Sub(x_max, x_min), hn::Sub(y_max, y_min));
    const IntMask large = hn::And(left, hn::Gt(extent, hn::Set(ints, small_extent - 1)));
    for_each_lane(large,
                  [&](int lane) { result.large[result.large_count++] = std::uint8_t(k + lane); });
    left = hn::AndNot(large, left);

    const auto drop = [&left](IntMask reason, int& counter) {
      const IntMask dropped = hn::And(left, reason);
      counter += int(hn::CountTrue(ints, dropped));
      left = hn::AndNot(dropped, left);
    };
    const auto area = edge(a, b, c.x, c.y);
    drop(hn::Eq(area, zero), result.no_pixel);
    if (!draw.draw_back_faces)
      drop(draw.mirrored ? hn::Gt(area, zero) : hn::Lt(area, zero), result.back_facing);
    const auto x0 = hn::ShiftRight<8>(hn::Add(x_min, up));
    const auto y0 = hn::ShiftRight<8>(hn::Add(y_min, up));
    const auto x1 = hn::Add(hn::ShiftRight<8>(hn::Add(x_max, up)), past);
    const auto y1 = hn::Add(hn::ShiftRight<8>(hn::Add(y_max, up)), past);
    drop(hn::Or(at_least(x0, x1), at_least(y0, y1)), result.no_pixel);
    drop(hn::Or(hn::Or(at_least(x0, width), at_least(zero, x1)),
                hn::Or(at_least(y0, height), at_least(zero, y1))),
         result.outside);
    if (hn::AllFalse(ints, left)) continue;
    if (samples == 1) {
      const IntMask single = hn::And(hn::Eq(hn::Sub(x1, x0), one), hn::Eq(hn::Sub(y1, y0), one));
      const auto px = hn::Add(hn::ShiftLeft<8>(x0), hn::Set(ints, half_pixel));
      const auto py = hn::Add(hn::ShiftLeft<8>(y0), hn::Set(ints, half_pixel));
      const auto flip = hn::ShiftRight<31>(area);
      const IntMask covered =
          hn::And(covers(a, b, px, py, flip),
                  hn::And(covers(b, c, px, py, flip), covers(c, a, px, py, flip)));
      drop(hn::AndNot(covered, single), result.no_pixel);
    }
    const auto x_begin = hn::Max(x0, zero), x_end = hn::Min(x1, width);
    const auto y_begin = hn::Max(y0, zero), y_end = hn::Min(y1, height);
    least_x = hn::Min(least_x, hn::IfThenElse(left, x_begin, largest));
    least_y = hn::Min(least_y, hn::IfThenElse(left, y_begin, largest));
    most_x = hn::Max(most_x, hn::IfThenElseZero(left, x_end));
    most_y = hn::Max(most_y, hn::IfThenElseZero(left, y_end));
    const auto box_pixels = hn::Mul(hn::Sub(x_end, x_begin), hn::Sub(y_end, y_begin));
    pixels = hn::Add(pixels, hn::IfThenElseZero(left, box_pixels));
    const auto store = [&](IntVector v, CulledCluster::Numbers& to) {
      hn::StoreU(compressed(v, left), ints, to + result.drawn_count);
    };
    store(hn::Iota(ints, k), result.drawn);
    store(hn::Xor(hn::ShiftRight<31>(area), mirrored), result.from_behind);
    store(x_begin, result.x_begin), store(x_end, result.x_end);
    store(y_begin, result.y_begin), store(y_end, result.y_end);
    result.drawn_count += int(hn::CountTrue(ints, left));
  }
  const auto lane = [](IntVector v) { return int(hn::GetLane(v)); };
  result.box = {lane(hn::MinOfLanes(ints, least_x)), lane(hn::MinOfLanes(ints, least_y)),
                lane(hn::MaxOfLanes(ints, most_x)), lane(hn::MaxOfLanes(ints, most_y))};
  result.pixels = lane(hn::SumOfLanes(ints, pixels));
}

TilesOfTriangles::TilesOfTriangles(const CulledCluster& culled, const TileGrid& grid)
    : count_(culled.drawn_count) {
  const auto one = hn::Set(ints, 1), columns = hn::Set(ints, grid.columns);
  const auto in_x = [&](IntVector x) { return hn::ShiftRightSame(x, grid.width_shift); };
  const auto in_y = [&](IntVector y) { return hn::ShiftRightSame(y, grid.height_shift); };
  for (int i = 0; i < count_; i += lanes) {
    const auto load = [i](const CulledCluster::Numbers& v) { return hn::LoadU(ints, v + i); };
    const auto column = in_x(load(culled.x_begin)), row = in_y(load(culled.y_begin));
    const auto last_column = in_x(hn::Sub(load(culled.x_end), one));
    const auto last_row = in_y(hn::Sub(load(culled.y_end), one));
    const auto in_one = hn::And(hn::Eq(column, last_column), hn::Eq(row, last_row));
    const auto tile = hn::Add(hn::Mul(row, columns), column);
    hn::StoreU(hn::IfThenElse(in_one, tile, hn::Set(ints, several)), ints, tile_ + i);
  }
}

std::span<const std::int32_t> TilesOfTriangles::in(int tile) {
  std::size_t found = 0;
  for (int i = 0; i < count_; i += lanes) {
    const IntMask there = hn::Lt(hn::Iota(ints, i), hn::Set(ints, count_));
    const IntMask mask = hn::And(there, hn::Eq(hn::LoadU(ints, tile_ + i), hn::Set(ints, tile)));
    hn::StoreU(compressed(hn::Iota(ints, i), mask), ints, found_ + found);
    found += hn::CountTrue(ints, mask);
  }
  return {found_, found};
}

}  // namespace scanlit
