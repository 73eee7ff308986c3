// (9) From reflection to radiance: the sum over all lights, a few vectors of points at a time, so
// that it stays in registers. ReflectionModel::radiance() is what the engine calls.
#pragma once

#include <algorithm>
#include <span>

#include "rasterizer/batch_vec.h"
#include "rasterizer/cosines.h"

namespace scanlit {

/// What of a light arrives at a vector of points, as a share of LightSource::diffuse and glossy.
struct ArrivingLight {
  Vec3<Batch> to_light;
  Batch share;
};

inline ArrivingLight arriving(const LightSource& light, const Vec3<Batch>& position,
                              const Vec3<Batch>& normal) {
  if (light.far) return {broadcast(light.to_light), Batch(1)};
  const Vec3<Batch> offset = broadcast(light.position) - position;
  const Batch distance2 = dot(offset, offset), inverse = inverse_sqrt(distance2);
  const auto apart = has_direction(distance2);
  const Vec3<Batch> to_light = select(apart, offset * inverse, normal);
  const Batch distance = select(apart, distance2 * inverse, Batch(0));
  // At the light itself an inverse-square light would be infinite; from 1e-4 units on it stays as
  // it is there. Beyond 1e30 it gives nothing that float could show.
  const Batch fall_off = mul_add(Batch(light.quadratic), distance2,
                                 mul_add(Batch(light.linear), distance, Batch(light.constant)));
  Batch share = reciprocal(min(max(fall_off, Batch(1e-8f)), Batch(1e30f)));
  if (light.cone) {
    // Smoothstep between the two angles' cosines.
    const Batch inside = (dot(broadcast(light.axis), to_light) - Batch(light.cos_outer)) *
                         Batch(light.inverse_width);
    const Batch t = min(max(inside, Batch(0)), Batch(1));
    share = share * (t * t * (Batch(3) - Batch(2) * t));
  }
  return {to_light, share};
}

/// sum + light * reflection, where the light's share is not 0.
inline void add_light(const LightSource& light, const Batch& share, const Reflection<Batch>& value,
                      Batch (&sum)[6]) {
  const auto lit = share > Batch(0);
  const auto add = [&](float tint, const Batch& part, Batch& to) {
    // A far light's share is 1: the product is the tint itself.
    const Batch weight = light.far ? Batch(tint) : share * Batch(tint);
    to = select(lit, mul_add(weight, part, to), to);
  };
  add(light.diffuse.r, value.diffuse.r, sum[0]);
  add(light.diffuse.g, value.diffuse.g, sum[1]);
  add(light.diffuse.b, value.diffuse.b, sum[2]);
  add(light.glossy.r, value.glossy.r, sum[3]);
  add(light.glossy.g, value.glossy.g, sum[4]);
  add(light.glossy.b, value.glossy.b, sum[5]);
}

inline void store(const Rgb<Batch>& value, float* const (&out)[3], std::size_t i) {
  value.r.store(out[0] + i), value.g.store(out[1] + i), value.b.store(out[2] + i);
}

inline void store(const Batch (&sum)[6], const RadianceSpan& out, std::size_t i) {
  const Rgb<Batch> ambient{out.ambient.r, out.ambient.g, out.ambient.b};
  const Rgb<Batch> diffuse{sum[0], sum[1], sum[2]}, glossy{sum[3], sum[4], sum[5]};
  if (out.diffuse[0]) store(diffuse, out.diffuse, i);
  if (out.glossy[0]) store(glossy, out.glossy, i);
  if (out.colour[0]) store(ambient + (diffuse + glossy), out.colour, i);
}

/// The vectors of points that begin at at[0 .. count) and end before `end` were evaluated once
/// more. Not inlined: the loops that rarely want it would run short of registers.
[[gnu::noinline]] inline void count_evaluations(float* evaluations, const std::size_t* at,
                                                std::size_t count, std::size_t end) {
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t i = at[k]; i < std::min(at[k] + Batch::lanes, end); ++i) evaluations[i] += 1;
}

/// Vectors of directions or of cosines, kept from one loop to the next. Not initialised, and one
/// array a component: of those that a formula does not look at, nothing is left.
template <std::size_t vectors>
struct DirectionVectors {
  Batch x[vectors], y[vectors], z[vectors];

  void put(std::size_t k, const Vec3<Batch>& v) { x[k] = v.x, y[k] = v.y, z[k] = v.z; }
  Vec3<Batch> operator[](std::size_t k) const { return {x[k], y[k], z[k]}; }
};

/// The radiance of up to `vectors` whole vectors of points from point `first` on. For each light,
/// first all cosines, then all formulas, only where the light reaches: each is one long chain of
/// dependent operations, and in short loops the processor works on several points' at a time.
/// `reflect(i, cosines, to_light, h)` is the model at the vector of points from i on. Returns at
/// how many (point, light) pairs it was evaluated.
template <std::size_t vectors, class Reflect>
std::size_t radiance_of_block(const ViewedSpan& in, std::span<const LightSource> lights,
                              const RadianceSpan& out, std::size_t first, const Reflect& reflect) {
  constexpr std::size_t lanes = Batch::lanes;
  const std::size_t end = std::min(first + vectors * lanes, in.size);
  const bool viewer_far = !in.to_viewer[0];
  std::size_t evaluations = 0;
  // Begun where the first light reaches: to clear all before would take a tenth of a light's time.
  Batch sums[vectors][6];
  bool begun[vectors] = {};
  const auto load_sum = [&](std::size_t v, Batch(&sum)[6]) {
#pragma GCC unroll 6
    for (int c = 0; c < 6; ++c) sum[c] = begun[v] ? sums[v][c] : Batch(0);
  };

  for (const LightSource& light : lights) {
    std::size_t at[vectors], reached = 0;
    Batch share[vectors], n_l[vectors], n_v[vectors], n_h[vectors], n_h_versine[vectors],
        v_h[vectors], n_l_versine[vectors], n_v_versine[vectors];
    DirectionVectors<vectors> to_light, h;
    for (std::size_t i = first; i < end; i += lanes) {
      const Vec3<Batch> n = load_vec3(in.normal, i);
      const Vec3<Batch> position = light.far ? Vec3<Batch>{} : load_vec3(in.position, i);
      const ArrivingLight arrives = arriving(light, position, n);
      const Vec3<Batch> l = arrives.to_light;
      const Batch reaching = select(dot(n, l) > Batch(0), arrives.share, Batch(0));
      if (in.skip_dark && none(reaching > Batch(0))) continue;
      const Vec3<Batch> v = viewer_far ? broadcast(in.far_viewer) : load_vec3(in.to_viewer, i);
      const HalfWay<Batch> half =
          viewer_far && light.far
              ? HalfWay<Batch>{broadcast(light.half.h), light.half.v_h, light.half.s2}
              : half_way(l, v);
      const Cosines<Batch> c = cosines(n, l, v, half);
      const std::size_t k = reached++;
      at[k] = i, share[k] = reaching;
      n_l[k] = c.n_l, n_v[k] = c.n_v, v_h[k] = c.v_h;
      n_h[k] = c.n_h.cos, n_h_versine[k] = c.n_h.versine;
      n_l_versine[k] = c.n_l_versine, n_v_versine[k] = c.n_v_versine;
      to_light.put(k, l), h.put(k, half.h);
      evaluations += std::min(lanes, end - i);
    }
    if (out.evaluations) count_evaluations(out.evaluations, at, reached, end);
    for (std::size_t k = 0; k < reached; ++k) {
      const Cosines<Batch> c{.n_l = n_l[k],
                             .n_v = n_v[k],
                             .n_h = {.cos = n_h[k], .versine = n_h_versine[k]},
                             .v_h = v_h[k],
                             .n_l_versine = n_l_versine[k],
                             .n_v_versine = n_v_versine[k]};
      const std::size_t v = (at[k] - first) / lanes;
      Batch sum[6];
      load_sum(v, sum);
      add_light(light, share[k], reflect(at[k], c, to_light[k], h[k]), sum);
      std::ranges::copy(sum, sums[v]);
      begun[v] = true;
    }
  }
  for (std::size_t i = first; i < end; i += lanes) {
    Batch sum[6];
    load_sum((i - first) / lanes, sum);
    store(sum, out, i);
  }
  return evaluations;
}

}  // namespace scanlit
