#include "rasterizer/shading.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "rasterizer/batch.h"
#include "rasterizer/cost.h"
#include "rasterizer/interpolated_run.h"
#include "rasterizer/placement.h"
#include "rasterizer/planes.h"

namespace scanlit {

namespace {

/// Colours of lit sites from `first` on, with their parts where those are asked for. Clamped, if
/// asked for, so that the parts still add up to the colour.
void store_sites(const LitSpan& lit, int size, bool clamped, LitSites& sites, std::size_t first) {
  for (int i = 0; i < size; i += Batch::lanes) {
    Batch ambient[3], diffuse[3], glossy[3], colour[3];
#pragma GCC unroll 3
    for (int c = 0; c < 3; ++c) {
      ambient[c] = Batch::load(lit.ambient[c] + i);
      diffuse[c] = Batch::load(lit.diffuse[c] + i), glossy[c] = Batch::load(lit.glossy[c] + i);
      if (clamped) {
        diffuse[c] = min(diffuse[c], max(Batch(1) - ambient[c], Batch(0)));
        glossy[c] = min(glossy[c], max((Batch(1) - ambient[c]) - diffuse[c], Batch(0)));
      }
      colour[c] = ambient[c] + (diffuse[c] + glossy[c]);
    }
    const auto store = [&](const Batch(&v)[3], std::vector<glm::vec4>& to) {
      if (!to.empty())
        hn::StoreInterleaved4(v[0].raw, v[1].raw, v[2].raw, Batch(0).raw, Batch::tag,
                              &to[first + std::size_t(i)].x);
    };
    store(colour, sites.colour);
    store(ambient, sites.ambient), store(diffuse, sites.diffuse), store(glossy, sites.glossy);
  }
}

/// Whether a whole vector of the span's fragments, each its pixel's only one, lies side by side in
/// the picture.
bool consecutive(const FragmentSpan& span, int first) {
  const int last = first + Batch::lanes - 1;
  return last < span.size && span.pixel[last] - span.pixel[first] == unsigned(Batch::lanes - 1);
}

/// A fragment's share of its pixel; one of weight 1 replaces what was there.
void add(float weight, float value, float& sum) { sum = weight < 1 ? sum + weight * value : value; }

/// Into a plane of three channels.
void add_to(std::vector<float>& plane, const Framebuffer& f, const ColourTarget& target,
            const FragmentSpan& span, const float (&values)[3][SurfaceSpan::padded]) {
  for (int i = 0; i < span.size; ++i) {
    const std::size_t index = index_of_pixel(span.pixel[i], std::size_t(f.width));
    float* const pixel = &plane[3 * (index - target.first_in_planes)];
    for (int c = 0; c < 3; ++c) add(span.weight[i], values[c][i], pixel[c]);
  }
}

}  // namespace

void light_sites(const Frame& frame, const Draw& draw, LitSites& lit_sites, FrameStats& stats) {
  SurfaceSpan surface;
  LitSpan lit;
  const Needs needs = draw.object->material.model->needs();
  const std::size_t count = lit_sites.sites.size();
  const std::size_t padded = count + max_lanes;
  lit_sites.colour.resize(padded);
  for (auto* part : {&lit_sites.ambient, &lit_sites.diffuse, &lit_sites.glossy})
    part->resize(frame.with_parts ? padded : 0);
  for (std::size_t begin = 0; begin < count; begin += SurfaceSpan::capacity) {
    const std::size_t size = std::min<std::size_t>(SurfaceSpan::capacity, count - begin);
    put_sites(draw, needs, std::span(lit_sites.sites).subspan(begin, size), surface);
    light(frame, draw, surface, lit, stats);
    store_sites(lit, surface.size, frame.settings.clamp_vertex_colours, lit_sites, begin);
  }
}

// ------------------------------------------------- the one place where the three shadings differ

void SpanShader::shade(const Frame& frame, const FragmentSpan& span, const ColourTarget& target,
                       Framebuffer& framebuffer) {
  if (span.size == 0) return;
  const bool parts = !framebuffer.ambient.empty();
  lit_.with_evaluations = !framebuffer.cost.empty();
  switch (span.draw->object->shading) {
    case Shading::flat: flat(frame, span, parts); break;        // evaluated once per face
    case Shading::gouraud: gouraud(frame, span, parts); break;  // at vertices; colour interpolated
    case Shading::phong: phong(frame, span, parts); break;      // normal interpolated; per fragment
  }
  stats.fragments += span.pixels;
  write(span, target);
  if (parts) {
    add_to(framebuffer.ambient, framebuffer, target, span, lit_.ambient);
    add_to(framebuffer.diffuse, framebuffer, target, span, lit_.diffuse);
    add_to(framebuffer.glossy, framebuffer, target, span, lit_.glossy);
  }
  if (!framebuffer.normal.empty()) write_normals(frame, span, target, framebuffer);
  if (!framebuffer.cost.empty() && span.draw->object->shading == Shading::phong)
    add_evaluations(span, lit_.evaluations, framebuffer);
}

void SpanShader::phong(const Frame& frame, const FragmentSpan& span, bool parts) {
  if (!span.draw->illumination.constant) interpolate_surface(span, surface_);
  surface_.size = span.size;
  lit_.with_parts = parts;
  light(frame, *span.draw, surface_, lit_, stats);
}

void SpanShader::gouraud(const Frame& frame, const FragmentSpan& span, bool parts) {
  // Of each corner of a run's triangle.
  const auto values = [&](int r, const auto& part) {
    const DrawnTriangle& drawn = *span.runs[r].drawn;
    const Chunk& chunk = frame.chunks[drawn.chunk];
    const std::uint16_t* const site = &chunk.lit.corners[3 * chunk.number_of(drawn)];
    const glm::vec4* const colour = (chunk.lit.*part).data();
    return std::array{colour[site[0]], colour[site[1]], colour[site[2]]};
  };
  for (int i = 0; i < span.size; i += Batch::lanes) {
    const OnPlanes at(span, i);
    const Batch w = reciprocal(at(3));
#pragma GCC unroll 3
    for (int c = 0; c < 3; ++c) (at(c) * w).store(lit_.colour[c] + i);
  }
  for (const int r : span.exact) {
    const auto [a, b, c] = values(r, &LitSites::colour);
    interpolate_run(span, span.runs[r], a, b, c, lit_.colour);
  }
  if (!parts) return;
  const auto interpolate = [&](const auto& part, auto& out) {
    RunAttribute attribute;
    for (int r = 0; r < span.run_count; ++r) {
      const auto [a, b, c] = values(r, part);
      attribute.put(r, a, b, c);
    }
    attribute.interpolate(span, out);
  };
  interpolate(&LitSites::ambient, lit_.ambient);
  interpolate(&LitSites::diffuse, lit_.diffuse);
  interpolate(&LitSites::glossy, lit_.glossy);
}

void SpanShader::flat(const Frame& frame, const FragmentSpan& span, bool parts) {
  const auto fill = [&](const auto& part, auto& out) {
    for (int r = 0; r < span.run_count; ++r) {
      const Run& run = span.runs[r];
      const Chunk& chunk = frame.chunks[run.drawn->chunk];
      const glm::vec4& colour = (chunk.lit.*part)[chunk.number_of(*run.drawn)];
      for (int c = 0; c < 3; ++c) std::fill_n(out[c] + run.first, run.size, colour[c]);
    }
  };
  fill(&LitSites::colour, lit_.colour);
  if (!parts) return;
  fill(&LitSites::ambient, lit_.ambient);
  fill(&LitSites::diffuse, lit_.diffuse);
  fill(&LitSites::glossy, lit_.glossy);
}

// -------------------------------------------------------------------------------------------------

void SpanShader::write(const FragmentSpan& span, const ColourTarget& target) const {
  if (span.pixels != span.size) return write_runs(span, target);
  if (target.codes) return write_codes(span, target);
  const Batch one(1);
  for (int i = 0; i < span.size; i += Batch::lanes) {
    const auto partial = Batch::load(span.weight + i) < one;
    if (!none(partial) || !consecutive(span, i)) {
      write_linear(span, i, std::min(Batch::lanes, span.size - i), target);
      continue;
    }
    const auto channel = [&](int c) { return Batch::load(lit_.colour[c] + i).raw; };
    hn::StoreInterleaved4(channel(0), channel(1), channel(2), one.raw, Batch::tag,
                          target.linear + target.element(span.pixel[i]));
  }
}

/// Where some runs were not shaded at every pixel.
void SpanShader::write_runs(const FragmentSpan& span, const ColourTarget& target) const {
  const PixelEncoder encoder(target.codes ? target.format : ColourFormat::linear_8bit, target.near);
  // `count` pixels of a row, at most a vector.
  const auto put = [&](std::uint32_t pixel, int count, const Rgb<Batch>& colour) {
    if (target.codes) {
      const auto codes = encoder.opaque(colour.r, colour.g, colour.b);
      auto* const to = reinterpret_cast<std::uint32_t*>(target.codes + target.element(pixel));
      const PixelEncoder::Tag tag;
      if (count == Batch::lanes) return hn::StoreU(codes, tag, to);
      hn::BlendedStore(codes, hn::FirstN(tag, std::size_t(count)), tag, to);
    } else {
      float rgba[4 * Batch::lanes];
      hn::StoreInterleaved4(colour.r.raw, colour.g.raw, colour.b.raw, Batch(1).raw, Batch::tag,
                            rgba);
      std::memcpy(target.linear + target.element(pixel), rgba, 16 * std::size_t(count));
    }
  };
  // The last vector of a run lies over the one before it, where that spares a partial one.
  const auto put_run = [&](const Run& run, const auto& colour) {
    const std::uint32_t pixel = span.pixel[run.first];
    const int size = run.pixels;
    for (int i = 0; i < size; i += Batch::lanes) {
      const int from = std::max(0, std::min(i, size - Batch::lanes));
      put(pixel + unsigned(from), std::min(Batch::lanes, size - from), colour(from));
    }
  };
  for (int r = 0; r < span.run_count; ++r) {
    const Run& run = span.runs[r];
    if (run.stride > 1) {
      const InterpolatedRun colours(run, lit_.colour);
      put_run(run, [&](int i) { return colours.at(i); });
    } else if (target.codes) {
      const auto channel = [&](int c, int i) {
        return Batch::load(lit_.colour[c] + run.first + i);
      };
      put_run(run, [&](int i) -> Rgb<Batch> {
        return {channel(0, i), channel(1, i), channel(2, i)};
      });
    } else {
      write_linear(span, run.first, run.size, target);
    }
  }
}

void SpanShader::write_linear(const FragmentSpan& span, int first, int count,
                              const ColourTarget& target) const {
  for (int i = first; i < first + count; ++i) {
    const float weight = span.weight[i];
    float* const pixel = target.linear + target.element(span.pixel[i]);
    for (int c = 0; c < 3; ++c) add(weight, lit_.colour[c][i], pixel[c]);
    add(weight, 1, pixel[3]);
  }
}

void SpanShader::write_codes(const FragmentSpan& span, const ColourTarget& target) const {
  const PixelEncoder encoder(target.format, target.near);
  const PixelEncoder::Tag tag;
  for (int i = 0; i < span.size; i += Batch::lanes) {
    const auto channel = [&](int c) { return Batch::load(lit_.colour[c] + i); };
    std::uint32_t pixels[Batch::lanes];
    hn::StoreU(encoder.opaque(channel(0), channel(1), channel(2)), tag, pixels);
    const auto at = [&](int k) { return target.codes + target.element(span.pixel[k]); };
    if (consecutive(span, i)) {
      std::memcpy(at(i), pixels, sizeof pixels);
      continue;
    }
    for (int k = i; k < std::min(i + Batch::lanes, span.size); ++k)
      std::memcpy(at(k), pixels + (k - i), 4);
  }
}

void SpanShader::write_normals(const Frame& frame, const FragmentSpan& span,
                               const ColourTarget& target, Framebuffer& framebuffer) {
  const Shading shading = span.draw->object->shading;
  if (shading != Shading::phong || span.draw->illumination.constant) {  // Phong has them already
    interpolate_surface(span, surface_);
    for (int r = 0; r < span.run_count && shading == Shading::flat; ++r) {
      const Run& run = span.runs[r];
      const glm::vec3 normal = face(*span.draw->mesh, run.drawn->triangle).normal * span.facing[r];
      for (int c = 0; c < 3; ++c) std::fill_n(surface_.normal[c] + run.first, run.size, normal[c]);
    }
    Places unused;
    place(frame, *span.draw, surface_, unused);
  }
  add_to(framebuffer.normal, framebuffer, target, span, surface_.normal);
}

}  // namespace scanlit
