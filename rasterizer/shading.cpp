#include "rasterizer/shading.h"

#include <algorithm>

#include "rasterizer/batch.h"
#include "rasterizer/scalar_math.h"

namespace scanlit {

namespace {

/// A lit site's colour, with its parts where sites have room for them. Clamped, if asked for, so
/// that the parts still add up to the colour.
void store_site(const LitSpan& lit, int i, bool clamped, LitSites& sites, std::size_t site) {
  float* value = &sites.values[site * std::size_t(sites.channels)];
  for (int c = 0; c < 3; ++c) {
    const float ambient = lit.ambient[c][i];
    float diffuse = lit.diffuse[c][i], glossy = lit.glossy[c][i];
    if (clamped) {
      diffuse = min(diffuse, max(1.0f - ambient, 0.0f));
      glossy = min(glossy, max((1.0f - ambient) - diffuse, 0.0f));
    }
    value[LitSites::colour + c] = ambient + (diffuse + glossy);
    if (sites.channels == 3) continue;
    value[LitSites::ambient + c] = ambient;
    value[LitSites::diffuse + c] = diffuse;
    value[LitSites::glossy + c] = glossy;
  }
}

}  // namespace

void light_sites(const Frame& frame, const Draw& draw, LitSites& lit_sites, FrameStats& stats) {
  SurfaceSpan surface;
  LitSpan lit;
  const std::size_t count = lit_sites.sites.size();
  lit_sites.channels = frame.with_parts ? 12 : 3;
  lit_sites.values.resize(count * std::size_t(lit_sites.channels));
  for (std::size_t begin = 0; begin < count; begin += SurfaceSpan::capacity) {
    surface.size = int(std::min<std::size_t>(SurfaceSpan::capacity, count - begin));
    for (int i = 0; i < surface.size; ++i)
      put_site(draw, lit_sites.sites[begin + std::size_t(i)], i, surface);
    light(frame, draw, surface, lit, stats);
    for (int i = 0; i < surface.size; ++i)
      store_site(lit, i, frame.settings.clamp_vertex_colours, lit_sites, begin + std::size_t(i));
  }
}

// ------------------------------------------------- the one place where the three shadings differ

void SpanShader::shade(const Frame& frame, const FragmentSpan& span, Framebuffer& framebuffer) {
  const bool parts = !framebuffer.ambient.empty();
  switch (span.draw->object->shading) {
    case Shading::flat: flat(frame, span, parts); break;        // evaluated once per face
    case Shading::gouraud: gouraud(frame, span, parts); break;  // at vertices; colour interpolated
    case Shading::phong: phong(frame, span); break;             // normal interpolated; per fragment
  }
  stats.fragments += span.size;
  write(span, framebuffer);
  if (!framebuffer.normal.empty()) write_normals(frame, span, framebuffer);
}

void SpanShader::phong(const Frame& frame, const FragmentSpan& span) {
  interpolate_surface(span, surface_);
  light(frame, *span.draw, surface_, lit_, stats);
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < span.size; i += Batch::lanes)
      (Batch::load(lit_.ambient[c] + i) +
       (Batch::load(lit_.diffuse[c] + i) + Batch::load(lit_.glossy[c] + i)))
          .store(colour_[c] + i);
}

void SpanShader::gouraud(const Frame& frame, const FragmentSpan& span, bool parts) {
  for (int r = 0; r < span.run_count; ++r) {
    const Run& run = span.runs[r];
    const Chunk& chunk = frame.chunks[run.drawn->chunk];
    const LitSites& sites = chunk.lit;
    const std::uint32_t* const site = &sites.corners[3 * chunk.number_of(*run.drawn)];
    const float* corner[3];
    for (int k = 0; k < 3; ++k) corner[k] = &sites.values[site[k] * std::size_t(sites.channels)];
    const auto channel = [&](int c, float* out) {
      interpolate(span, run, {corner[0] + c, corner[1] + c, corner[2] + c}, 1, out);
    };
    for (int c = 0; c < 3; ++c) {
      channel(LitSites::colour + c, colour_[c]);
      if (!parts) continue;
      channel(LitSites::ambient + c, lit_.ambient[c]);
      channel(LitSites::diffuse + c, lit_.diffuse[c]);
      channel(LitSites::glossy + c, lit_.glossy[c]);
    }
  }
}

void SpanShader::flat(const Frame& frame, const FragmentSpan& span, bool parts) {
  for (int r = 0; r < span.run_count; ++r) {
    const Run& run = span.runs[r];
    const Chunk& chunk = frame.chunks[run.drawn->chunk];
    const LitSites& sites = chunk.lit;
    const float* value = &sites.values[chunk.number_of(*run.drawn) * std::size_t(sites.channels)];
    for (int c = 0; c < 3; ++c) {
      std::fill_n(colour_[c] + run.first, run.size, value[LitSites::colour + c]);
      if (!parts) continue;
      std::fill_n(lit_.ambient[c] + run.first, run.size, value[LitSites::ambient + c]);
      std::fill_n(lit_.diffuse[c] + run.first, run.size, value[LitSites::diffuse + c]);
      std::fill_n(lit_.glossy[c] + run.first, run.size, value[LitSites::glossy + c]);
    }
  }
}

// -------------------------------------------------------------------------------------------------

void SpanShader::write(const FragmentSpan& span, Framebuffer& framebuffer) const {
  for (int i = 0; i < span.size; ++i) {
    const float weight = span.weight[i];
    float* pixel = &framebuffer.colour[4 * std::size_t(span.pixel[i])];
    for (int c = 0; c < 3; ++c) pixel[c] += weight * colour_[c][i];
    pixel[3] += weight;
  }
  if (framebuffer.ambient.empty()) return;
  for (int i = 0; i < span.size; ++i) {
    const std::size_t pixel = 3 * std::size_t(span.pixel[i]);
    for (std::size_t c = 0; c < 3; ++c) {
      framebuffer.ambient[pixel + c] += span.weight[i] * lit_.ambient[c][i];
      framebuffer.diffuse[pixel + c] += span.weight[i] * lit_.diffuse[c][i];
      framebuffer.glossy[pixel + c] += span.weight[i] * lit_.glossy[c][i];
    }
  }
}

void SpanShader::write_normals(const Frame& frame, const FragmentSpan& span,
                               Framebuffer& framebuffer) {
  const Shading shading = span.draw->object->shading;
  if (shading != Shading::phong) {  // which has them already
    interpolate_surface(span, surface_);
    for (int r = 0; r < span.run_count && shading == Shading::flat; ++r) {
      const Run& run = span.runs[r];
      const glm::vec3 normal =
          face(*span.draw->mesh, run.drawn->triangle).normal * (run.back_facing ? -1.0f : 1.0f);
      for (int c = 0; c < 3; ++c) std::fill_n(surface_.normal[c] + run.first, run.size, normal[c]);
    }
    place_normals(frame, *span.draw, surface_);
  }
  for (int i = 0; i < span.size; ++i)
    for (int c = 0; c < 3; ++c)
      framebuffer.normal[3 * std::size_t(span.pixel[i]) + std::size_t(c)] +=
          span.weight[i] * surface_.normal[c][i];
}

}  // namespace scanlit
