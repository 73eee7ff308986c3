#include "rasterizer/light_misses.h"

#include "rasterizer/pixel_codes.h"

namespace scanlit {

namespace {

/// By how much a colour that is at least `least` may be off.
Batch allowed(const Frame& frame, const Batch& least) {
  const Batch codes = Batch((frame.settings.tolerance - rounding_codes - near_codes) / 255);
  if (frame.format == ColourFormat::linear_8bit) return codes;
  // 1 over the slope of sRGB's encoding, IEC 61966-2-1: 12.92, or that of 1.055 c^(1/2.4).
  const Batch power = exp(Batch(1 - 1 / 2.4) * log(max(least, Batch(0.003f))));
  const Batch inverse_slope =
      select(least <= Batch(0.0031308f), Batch(1 / 12.92), power * Batch(2.4 / 1.055));
  return codes * inverse_slope * Batch(0.9999f);
}

/// s x, s >= 0.
Bounded scaled(const Bounded& x, float s) {
  const Batch by(s);
  return Bounded::rounded_outwards(x.lo * by, x.hi * by, Bounded::padding, x.slope * by,
                                   x.curvature * by, x.kink * by);
}

/// Certainly, but for what rounding outwards adds to 0: not where nothing is known.
Batch::Mask never_positive(const Bounded& x) {
  return (x.hi <= Batch(1e-30f)) & (x.slope >= Batch(0));
}

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

/// As cosines() of bounded_directions.h, where N.L is known, and N.V, which all lights share.
Cosines<Bounded> cosines(const Cosine<Bounded>& n_l, const BoundedSurface& surface,
                         const BoundedDirection& l) {
  const BoundedVector s = sum(l, surface.v);
  return {.n_l = n_l.cos,
          .n_v = max(surface.n_v.cos, Bounded(min_n_v)),
          .n_h = cosine(surface.n, direction(s)),
          .v_h = min(Bounded(1), Bounded(0.5f) * length(s)),
          .n_l_versine = n_l.versine,
          .n_v_versine = min(surface.n_v.versine, Bounded(1 - min_n_v))};
}

/// Adds a light; false where nothing is known of the model.
///
/// Where it sets, the formula's value ends. It is taken as it is above the horizon and, beyond, at
/// N.L = 0: without a jump, but with N.L's kink. What that is beyond the horizon, where 0 is shown,
/// a straight line misses by at most its size.
///
/// Inlined whole (flatten): calls would pass bounds, five vectors each, through memory.
[[gnu::flatten]] bool add_light(const ReflectionModel& model, const LightSource& light,
                                const ScreenGroup& group, const BoundedSurface& surface,
                                std::span<const Spacing> spacings, Misses& sum) {
  BoundedDirection l{.centre = broadcast(light.to_light)};
  Bounded share(1);
  if (!light.far) {
    const BoundedVector to_light = towards(broadcast(light.position), surface.position);
    l = direction(to_light);
    share = arriving_share(light, to_light, l);
  }
  const Cosine<Bounded> n_l = cosine(surface.n, l);
  const auto dark = never_positive(n_l.cos) | never_positive(share);
  const Batch lit = select(dark, Batch(0), Batch(1));
  if (none(lit > Batch(0))) return true;
  BoundedCosines in{cosines(n_l, surface, l), surface.framed ? &surface.axes : nullptr, l,
                    surface.v};
  Cosines<Bounded>& c = in.cosines;
  const auto horizon = c.n_l.lo <= Batch(0), crossed = horizon & (lit > Batch(0));
  c.n_l = max(c.n_l, Bounded(0)), c.n_l_versine = min(c.n_l_versine, Bounded(1));
  BoundedReflection above, at_horizon;
  if (!model.bounds(in, above)) return false;
  const bool sets = !none(crossed);
  if (sets) {
    c.n_l = Bounded(0), c.n_l_versine = Bounded(1);
    model.bounds(in, at_horizon);
  }
  const auto add = [&](const Bounded& part, const Bounded& there, float tint, int channel) {
    // What a model has not costs nothing.
    const auto nothing = (part.magnitude() <= Batch(1e-30f)) & (part.slope >= Batch(0));
    if (bits_of(nothing) == (1u << Batch::lanes) - 1) return;
    Bounded weighted = scaled(light.far ? part : part * share, tint);
    weighted.lo = select(horizon, min(weighted.lo, Batch(0)), weighted.lo);
    weighted = group.of_triangle(pick(dark, Bounded(0), weighted));
    Batch jump = 0;
    if (sets) {
      const Batch size = there.magnitude() * share.hi * Batch(Bounded::rounding_slack * tint);
      jump = group.largest(select(crossed, size + Batch(0) * there.slope, Batch(0)));
    }
    sum.least[channel] += max(weighted.lo, Batch(0));
    for (std::size_t s = 0; s < spacings.size(); ++s)
      sum.missed[s][channel] += missed_by(weighted, spacings[s]) + jump;
  };
  const auto add_channel = [&](Bounded Rgb<Bounded>::*of, float Rgb<float>::*of_light,
                               int channel) {
    const Reflection<Bounded>&here = above.value, &there = at_horizon.value;
    add(here.diffuse.*of, there.diffuse.*of, light.diffuse.*of_light, channel);
    add(here.glossy.*of, there.glossy.*of, light.glossy.*of_light, channel);
  };
  add_channel(&Rgb<Bounded>::r, &Rgb<float>::r, 0);
  add_channel(&Rgb<Bounded>::g, &Rgb<float>::g, 1);
  add_channel(&Rgb<Bounded>::b, &Rgb<float>::b, 2);
  return true;
}

}  // namespace

bool add_lights(const Frame& frame, const Draw& draw, const ScreenGroup& group,
                const BoundedSurface& surface, std::span<const Spacing> spacings, Misses& sum) {
  const Rgb<float>& ambient = draw.illumination.ambient;
  sum.least[0] = ambient.r, sum.least[1] = ambient.g, sum.least[2] = ambient.b;
  for (auto& of_spacing : sum.missed)
    for (Batch& channel : of_spacing) channel = Batch(0);
  // Most that fail do so after a few lights.
  const Batch hopeless = allowed(frame, Batch(1));
  for (const LightSource& light : draw.illumination.lights) {
    if (!add_light(*draw.object->material.model, light, group, surface, spacings, sum))
      return false;
    const auto& missed = sum.missed[0];
    if (none((missed[0] <= hopeless) & (missed[1] <= hopeless) & (missed[2] <= hopeless)))
      return false;
  }
  return true;
}

Batch::Mask within_tolerance(const Frame& frame, const Misses& sum, std::size_t spacing) {
  auto within = sum.missed[spacing][0] <= allowed(frame, sum.least[0]);
  for (int c = 1; c < 3; ++c)
    within = within & (sum.missed[spacing][c] <= allowed(frame, sum.least[c]));
  return within;
}

}  // namespace scanlit
