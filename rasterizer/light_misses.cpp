#include "rasterizer/light_misses.h"

namespace scanlit {

namespace {

/// How a part ends where its light sets. All 0 where the light does not.
struct Horizon {
  Batch crossed;  // 1: some of the triangle's pixels may lie beyond it
  Batch jump;     // the part's size there
  Batch rise;     // at most jump + rise h^2 / 8 before and after a set of less than h pixels
};

/// By how much a straight line over h pixels misses a part that is known above the horizon and 0
/// beyond. Its slope S jumps there. Crossed once, a pixels on, the line from 0 to at most S (h - a)
/// misses the kink by at most S a (h - a) / h <= S h / 4. Crossed twice, with both ends lit, N.L at
/// the ends is so low that the line between them lies at most h^2 / 8 times the curvature of N.L
/// above 0. Where the light is up, the curve bends besides.
Batch missed(const Bounded& part, const Horizon& horizon, float h) {
  const Batch eighth(h * h / 8), kink = max(Batch(h / 4) * part.slope, eighth * horizon.rise);
  const Batch bent = mul_add(eighth, part.curvature, min(kink, Batch(h / 2) * part.slope));
  const Batch across = Batch(Bounded::rounding_slack) * min(bent, part.hi) + Batch(0) * part.slope;
  return select(horizon.crossed > Batch(0), across, missed_by(part, h)) + horizon.jump;
}

/// One part of what a light adds to one channel; no horizon: the light does not set.
void add_part(const Bounded& part, const Horizon* horizon, int channel, Misses& sum) {
  sum.least[channel] += max(part.lo, Batch(0));
#pragma GCC unroll 4
  for (int s = 0; s < stride_count; ++s) {
    const float h = float(strides[s]);
    sum.missed[s][channel] += horizon ? missed(part, *horizon, h) : missed_by(part, h);
  }
}

/// s x, s >= 0.
Bounded scaled(const Bounded& x, float s) {
  const Batch by(s);
  return Bounded::rounded_outwards(x.lo * by, x.hi * by, Bounded::padding, x.slope * by,
                                   x.curvature * by);
}

/// What the formula says where the light sets: of the parts there, and of how fast they grow with
/// N.L alone.
struct Setting {
  BoundedReflection there{}, growing{};

  void find(const ReflectionModel& model, const Cosines<Bounded>& c) {
    const auto at_rest = [](const Bounded& x) { return Bounded(x.lo, x.hi, Batch(0), Batch(0)); };
    BoundedCosines in{{.n_l = Bounded(0),
                       .n_v = at_rest(c.n_v),
                       .n_h = {.cos = at_rest(c.n_h.cos), .versine = at_rest(c.n_h.versine)},
                       .v_h = at_rest(c.v_h),
                       .n_l_versine = Bounded(1),
                       .n_v_versine = at_rest(c.n_v_versine)}};
    model.bounds(in, there);
    in.cosines.n_l = {Batch(0), c.n_l.hi, Batch(1), Batch(0)};
    in.cosines.n_l_versine = {c.n_l_versine.lo, Batch(1), Batch(1), Batch(0)};
    model.bounds(in, growing);
  }
};

/// Certainly: not where nothing is known.
Batch::Mask never_positive(const Bounded& x) { return (x.hi <= Batch(0)) & (x.slope >= Batch(0)); }

/// The share of a light that arrives, as arriving() of radiance.h has it.
Bounded arriving_share(const LightSource& light, const BoundedVector& to_light,
                       const BoundedDirection& l) {
  const Bounded distance = length(to_light);
  const Bounded fall_off =
      mul_add(mul_add(Bounded(light.quadratic), distance, Bounded(light.linear)), distance,
              Bounded(light.constant));
  const Bounded share = reciprocal(min(max(fall_off, Bounded(1e-8f)), Bounded(1e30f)));
  if (!light.cone) return share;
  const BoundedDirection axis{.centre = broadcast(light.axis)};
  const Bounded inside =
      (cosine(axis, l).cos - Bounded(light.cos_outer)) * Bounded(light.inverse_width);
  // Smoothstep: its slope grows to 3/2 and falls again; where it begins and ends it has no kink.
  const Batch t0 = min(max(inside.lo, Batch(0)), Batch(1)),
              t1 = min(max(inside.hi, Batch(0)), Batch(1));
  const auto step = [](const Batch& t) { return t * t * (Batch(3) - Batch(2) * t); };
  const Bounded value = Bounded::rounded_outwards(step(t0), step(t1), Batch(1e-6f));
  const auto outside = (inside.hi <= Batch(0)) | (inside.lo >= Batch(1));
  return share *
         pick(outside,
              Bounded::rounded_outwards(value.lo, value.hi, Batch(1e-6f), Batch(0) * inside.slope),
              chain(inside, value, 1.5f, 6.0f));
}

}  // namespace

bool add_light(const ReflectionModel& model, const LightSource& light, const ScreenGroup& group,
               const BoundedDirection& n, const BoundedDirection& v, const BoundedVector& position,
               Misses& sum) {
  BoundedDirection l{.centre = broadcast(light.to_light)};
  Bounded share(1);
  if (!light.far) {
    const BoundedVector to_light = towards(broadcast(light.position), position);
    l = direction(to_light);
    share = arriving_share(light, to_light, l);
  }
  BoundedCosines in{cosines(n, l, v)};
  Cosines<Bounded>& c = in.cosines;
  const auto dark = never_positive(c.n_l) | never_positive(share);
  const Batch lit = select(dark, Batch(0), Batch(1));
  if (none(lit > Batch(0))) return true;
  const auto horizon = c.n_l.lo <= Batch(0), crossed = horizon & (lit > Batch(0));
  // As it is above the horizon: without a kink.
  c.n_l.lo = max(c.n_l.lo, Batch(0)), c.n_l.hi = max(c.n_l.hi, Batch(0));
  c.n_l_versine.lo = min(c.n_l_versine.lo, Batch(1));
  c.n_l_versine.hi = min(c.n_l_versine.hi, Batch(1));
  BoundedReflection reflection;
  if (!model.bounds(in, reflection)) return false;
  Setting setting;
  if (!none(crossed)) setting.find(model, c);
  const auto where_crossed = [&](const Batch& x) {
    return group.largest(select(crossed, x, Batch(0)));
  };
  Horizon edge{};
  const bool sets = !none(crossed);
  if (sets) edge.crossed = where_crossed(Batch(1));
  const auto add = [&](const Bounded& part, const Bounded& there, const Bounded& growing,
                       float tint, int channel) {
    // What a model has not costs nothing.
    const auto nothing = (part.magnitude() <= Batch(1e-30f)) & (part.slope >= Batch(0));
    if (bits_of(nothing) == (1u << Batch::lanes) - 1) return;
    Bounded weighted = scaled(light.far ? part : part * share, tint);
    weighted.lo = select(horizon, Batch(0), weighted.lo);
    if (sets) {
      const Batch weight = share.hi * Batch(Bounded::rounding_slack * tint);
      edge.jump = where_crossed(there.magnitude() * weight + Batch(0) * there.slope);
      edge.rise = where_crossed(growing.slope * weight * c.n_l.curvature);
    }
    add_part(group.of_triangle(pick(dark, Bounded(0), weighted)), sets ? &edge : nullptr, channel,
             sum);
  };
  const Reflection<Bounded>&here = reflection.value, &there = setting.there.value,
        &growing = setting.growing.value;
  const auto add_channel = [&](Bounded Rgb<Bounded>::*of, float Rgb<float>::*of_light,
                               int channel) {
    add(here.diffuse.*of, there.diffuse.*of, growing.diffuse.*of, light.diffuse.*of_light, channel);
    add(here.glossy.*of, there.glossy.*of, growing.glossy.*of, light.glossy.*of_light, channel);
  };
  add_channel(&Rgb<Bounded>::r, &Rgb<float>::r, 0);
  add_channel(&Rgb<Bounded>::g, &Rgb<float>::g, 1);
  add_channel(&Rgb<Bounded>::b, &Rgb<float>::b, 2);
  return true;
}

}  // namespace scanlit
