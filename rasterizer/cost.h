// (10) Framebuffer::cost: what was done for each pixel. Only where it is asked for, and beside the
// stages that do it: they do not count.
#pragma once

#include "rasterizer/coarse_depth.h"
#include "rasterizer/fragment_span.h"

namespace scanlit {

/// The depth tests of scan_convert(id, visibility, columns).
void count_depth_tests(TriangleId id, const VisibilityTile& visibility,
                       const VisibleColumns* columns, Framebuffer& framebuffer);

/// How often the reflection model was evaluated for each fragment of a span.
void add_evaluations(const FragmentSpan& span, const float* evaluations, Framebuffer& framebuffer);

}  // namespace scanlit
