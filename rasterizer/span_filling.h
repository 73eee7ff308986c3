// (8) How visible pixels become the fragments and runs of a span.
#pragma once

#include "rasterizer/fragment_span.h"

namespace scanlit {

/// Appends pixels [begin, end) of a row, as many as the span has room for at most: those that see a
/// triangle, all of the span's draw. `row` is indexed by the pixel's column, and a vector may be
/// read from any of the pixels and from the one after it.
void append_fitting(int begin, int end, int y, const TriangleId* row, FragmentSpan& span);

/// Appends a run of one triangle, whose pixels stand behind the span's last already: up to a whole
/// vector, where the last ones may be any.
void append_run(TriangleId id, int size, float weight, FragmentSpan& span);

/// Of a span that is full: what follows from its runs' triangles.
void put_runs(const VisibilityTile& visibility, FragmentSpan& span);

}  // namespace scanlit
