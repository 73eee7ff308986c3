#include "rasterizer/light_misses.h"

namespace scanlit {

namespace {

/// One part of what a light adds to one channel; `jump` is its size at the horizon, where it ends.
void add_part(const Bounded& part, const Batch& jump, int channel, Misses& sum) {
  sum.least[channel] += max(part.lo, Batch(0));
  for (int s = 0; s < stride_count; ++s)
    sum.missed[s][channel] += missed_by(part, float(strides[s])) + jump;
}

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
  const auto horizon = c.n_l.lo <= Batch(0);
  c.n_l = max(c.n_l, Bounded(0));
  c.n_l_versine = min(c.n_l_versine, Bounded(1));
  BoundedReflection reflection, ending{};
  if (!model.bounds(in, reflection)) return false;
  if (!none((lit > Batch(0)) & horizon)) {
    c.n_l = Bounded(0), c.n_l_versine = Bounded(1);
    model.bounds(in, ending);
  }
  const auto add = [&](const Bounded& part, const Bounded& at_horizon, float tint, int channel) {
    const Bounded weight = share * Bounded(tint), none(0);
    Bounded weighted = part * weight;
    weighted.lo = select(horizon, Batch(0), weighted.lo);
    const Batch jump = at_horizon.magnitude() * weight.hi + Batch(0) * at_horizon.slope;
    add_part(group.of_triangle(pick(dark, none, weighted)),
             group.largest(select(dark, Batch(0), select(horizon, jump, Batch(0)))), channel, sum);
  };
  const auto &a = reflection.value, &b = ending.value;
  add(a.diffuse.r, b.diffuse.r, light.diffuse.r, 0), add(a.glossy.r, b.glossy.r, light.glossy.r, 0);
  add(a.diffuse.g, b.diffuse.g, light.diffuse.g, 1), add(a.glossy.g, b.glossy.g, light.glossy.g, 1);
  add(a.diffuse.b, b.diffuse.b, light.diffuse.b, 2), add(a.glossy.b, b.glossy.b, light.glossy.b, 2);
  return true;
}

}  // namespace scanlit
