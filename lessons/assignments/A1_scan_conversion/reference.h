// A1 as it should be, for any variant.
#pragma once

#include <vector>

#include "lessons/assignments/A1_scan_conversion/scan_conversion.h"
#include "rasterizer/stages.h"

namespace scanlit::assignments::scan {

struct ScanVariant {
  bool y_up, centres_at_integers, owns_left, owns_top;

  int centre() const { return centres_at_integers ? 0 : 128; }  // of pixel (0, 0), in 1/256 pixel
};

/// Never the engine's own fill rule, which is the top-left one.
ScanVariant scan_variant(std::uint64_t seed);

a1::Edge right_edge(a1::Point from, a1::Point to, a1::Point third);
bool right_owns(const ScanVariant& variant, const a1::Edge& edge);
std::int64_t value_at(const ScanVariant& variant, const a1::Edge& edge, int column, int row);
bool right_covers(const ScanVariant& variant, const a1::Edge (&edges)[3], int column, int row);
a1::Span right_span(const ScanVariant& variant, const a1::Edge (&edges)[3], int row, int width);

/// False where the triangle has no area.
bool right_edges(const ScanVariant& variant, const a1::Triangle& triangle, a1::Edge (&edges)[3]);
std::vector<a1::Fragment> right_fragments(const ScanVariant& variant, const a1::Triangle& triangle,
                                          const a1::Picture& picture);

/// The engine's triangle and fragments in the variant's coordinates, and back.
a1::Triangle in_variant(const ScanVariant& variant, const ScreenTriangle& triangle, int height);
int engine_row(const ScanVariant& variant, int row, int height);

}  // namespace scanlit::assignments::scan
