// (3) Vertex stage, with (5) project and snap, which every vertex inside the guard band goes
// through at once.
#include <algorithm>
#include <cmath>

#include "rasterizer/batch.h"
#include "rasterizer/pipeline.h"
#include "rasterizer/scalar_math.h"

namespace scanlit {

namespace {

// Written once for float and Batch: the same operations in the same order give the same bits.
template <class T>
struct Homogeneous {
  T x, y, z, w;
};

template <class T>
Homogeneous<T> to_clip(const glm::mat4& m, const T& x, const T& y, const T& z) {
  const auto row = [&](int i) {
    return ((T(m[0][i]) * x + T(m[1][i]) * y) + T(m[2][i]) * z) + T(m[3][i]);
  };
  return {row(0), row(1), row(2), row(3)};
}

template <class T>
struct Projected {
  T x, y;  // in 1/256 pixel, not yet rounded
  T depth, inv_w;
};

template <class T>
Projected<T> to_screen(const Homogeneous<T>& p, const Viewport& viewport) {
  const T half_width(float(viewport.width) * half_pixel);
  const T half_height(float(viewport.height) * half_pixel);
  const T inv_w = T(1) / p.w;
  return {.x = half_width + (p.x * inv_w) * half_width,
          .y = half_height - (p.y * inv_w) * half_height,
          .depth = p.z * inv_w,
          .inv_w = inv_w};
}

using Ints = hn::RebindToSigned<Batch::Tag>;
using IntVector = hn::Vec<Ints>;

IntVector bit_where(Batch::Mask inside, int bit) {
  return hn::IfThenZeroElse(hn::RebindMask(Ints(), inside.raw), hn::Set(Ints(), bit));
}

// Each test asks "inside?", so that NaN counts as outside.
IntVector outcodes(const Homogeneous<Batch>& p, const Viewport& viewport) {
  const Batch limit_x = p.w * Batch(viewport.guard_x()), limit_y = p.w * Batch(viewport.guard_y());
  // Beyond 1e18 the squares of distances come near float's largest, and a direction to the viewer
  // or a light could not be normalised.
  const Batch magnitude = max(max(abs(p.x), abs(p.y)), max(abs(p.z), abs(p.w)));
  const Batch::Mask in_range =
      (magnitude <= Batch(1e18f)) & (p.x <= p.x) & (p.y <= p.y) & (p.z <= p.z) & (p.w <= p.w);
  const IntVector codes[] = {
      bit_where(p.z <= p.w, outside_near),        bit_where(p.z >= Batch(0), outside_far),
      bit_where(-limit_x <= p.x, outside_left),   bit_where(p.x <= limit_x, outside_right),
      bit_where(-limit_y <= p.y, outside_bottom), bit_where(p.y <= limit_y, outside_top),
      bit_where(in_range, out_of_range)};
  IntVector all = codes[0];
  for (int i = 1; i < 7; ++i) all = hn::Or(all, codes[i]);
  return all;
}

}  // namespace

void transform_vertices(const Draw& draw, const Cluster& cluster, const Viewport& viewport,
                        ClusterVertices& out) {
  static_assert(sizeof(glm::vec3) == 12 && sizeof(ScreenVertex) == 16, "interleaved as floats");
  constexpr std::size_t lanes = std::size_t(Batch::lanes);
  static_assert(ClusterVertices::capacity % max_lanes == 0);
  const hn::Rebind<std::uint8_t, Batch::Tag> bytes;
  const auto nearest = [](Batch v) { return hn::NearestInt(v.raw); };
  const auto as_floats = [](IntVector v) { return hn::BitCast(Batch::tag, v); };
  const glm::vec3* const positions = &draw.clusters->positions[cluster.first_vertex];
  const auto count = hn::Set(Ints(), std::int32_t(cluster.vertex_count));

  IntVector any_code = hn::Zero(Ints());
  Batch nearest_depth(0);
  for (std::size_t i = 0; i < cluster.vertex_count; i += lanes) {
    Batch px, py, pz;
    hn::LoadInterleaved3(Batch::tag, &positions[i].x, px.raw, py.raw, pz.raw);
    const Homogeneous<Batch> clip_position = to_clip(draw.clip_from_object, px, py, pz);
    const Projected<Batch> screen = to_screen(clip_position, viewport);
    const IntVector x = nearest(screen.x), y = nearest(screen.y);
    const IntVector codes = outcodes(clip_position, viewport);
    hn::StoreU(x, Ints(), out.x + i);
    hn::StoreU(y, Ints(), out.y + i);
    hn::StoreInterleaved4(as_floats(x), as_floats(y), screen.depth.raw, screen.inv_w.raw,
                          Batch::tag, reinterpret_cast<float*>(out.screen + i));
    hn::StoreU(hn::DemoteTo(bytes, codes), bytes, out.outcodes + i);
    const auto in_cluster = hn::Lt(hn::Iota(Ints(), std::int32_t(i)), count);
    any_code = hn::Or(any_code, hn::IfThenElseZero(in_cluster, codes));
    const auto depth_in_cluster =
        hn::IfThenElseZero(hn::RebindMask(Batch::tag, in_cluster), screen.depth.raw);
    nearest_depth = max(nearest_depth, depth_in_cluster);
  }
  out.nearest = hn::GetLane(hn::MaxOfLanes(Batch::tag, nearest_depth.raw));
  out.any_outcode = 0;
  std::int32_t lane_codes[max_lanes];
  hn::StoreU(any_code, Ints(), lane_codes);
  for (std::size_t k = 0; k < lanes; ++k) out.any_outcode |= std::uint8_t(lane_codes[k]);
}

ClipVertex transform(const Draw& draw, const glm::vec3& p) {
  const auto c = to_clip<float>(draw.clip_from_object, p.x, p.y, p.z);
  return {c.x, c.y, c.z, c.w};
}

ScreenVertex project(const ClipVertex& v, const Viewport& viewport) {
  const auto s = to_screen<float>({v.x, v.y, v.z, v.w}, viewport);
  // As NearestInt above: to nearest, ties to even.
  return {std::int32_t(std::lrintf(s.x)), std::int32_t(std::lrintf(s.y)), s.depth, s.inv_w};
}

}  // namespace scanlit
