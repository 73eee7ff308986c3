// (9) Shading: what flat, Gouraud and Phong are, and where the difference between them lies.
#pragma once

#include "rasterizer/lighting.h"

namespace scanlit {

/// Flat and Gouraud: evaluates the reflection model at every site.
void light_sites(const Frame& frame, const Draw& draw, LitSites& lit_sites, FrameStats& stats);

/// Colours a span of fragments and adds it, weighted by coverage, to the framebuffer. Not copied,
/// and one a thread: it holds the arrays that all its spans are shaded in.
class SpanShader {
 public:
  void shade(const Frame& frame, const FragmentSpan& span, Framebuffer& framebuffer);

  FrameStats stats;

 private:
  void flat(const Frame& frame, const FragmentSpan& span, bool parts);
  void gouraud(const Frame& frame, const FragmentSpan& span, bool parts);
  void phong(const Frame& frame, const FragmentSpan& span);
  void write(const FragmentSpan& span, Framebuffer& framebuffer) const;
  void write_normals(const Frame& frame, const FragmentSpan& span, Framebuffer& framebuffer);

  SurfaceSpan surface_;
  LitSpan lit_;  // parts; of flat and Gouraud, only where asked for
  float colour_[3][SurfaceSpan::padded] = {};
};

}  // namespace scanlit
