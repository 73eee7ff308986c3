// (9) Shading: what flat, Gouraud and Phong are, and where the difference between them lies.
#pragma once

#include "rasterizer/lighting.h"
#include "rasterizer/pixel_codes.h"

namespace scanlit {

/// Flat and Gouraud: evaluates the reflection model at every site.
void light_sites(const Frame& frame, const Draw& draw, LitSites& lit_sites, FrameStats& stats);

/// Colours a span of fragments and adds it, weighted by coverage, to the colour target and to the
/// framebuffer's planes. A fragment of weight 1 is its pixel's only one, and replaces what was
/// there. Not copied, and one a thread: it holds the arrays that all its spans are shaded in.
class SpanShader {
 public:
  void shade(const Frame& frame, const FragmentSpan& span, const ColourTarget& target,
             Framebuffer& framebuffer);

  FrameStats stats;

 private:
  void flat(const Frame& frame, const FragmentSpan& span, bool parts);
  void gouraud(const Frame& frame, const FragmentSpan& span, bool parts);
  void phong(const Frame& frame, const FragmentSpan& span, bool parts);
  void write(const FragmentSpan& span, const ColourTarget& target) const;
  void write_linear(const FragmentSpan& span, int first, int count,
                    const ColourTarget& target) const;
  void write_runs(const FragmentSpan& span, const ColourTarget& target) const;
  void write_codes(const FragmentSpan& span, const ColourTarget& target) const;
  void write_normals(const Frame& frame, const FragmentSpan& span, const ColourTarget& target,
                     Framebuffer& framebuffer);

  SurfaceSpan surface_;
  LitSpan lit_;
};

}  // namespace scanlit
