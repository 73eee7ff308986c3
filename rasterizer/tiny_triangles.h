// (7) Scan conversion of triangles that are hardly larger than pixels: a vector of them at a time.
#pragma once

#include <span>

#include "rasterizer/batch.h"
#include "rasterizer/pipeline.h"

namespace scanlit {

constexpr auto tiny_at_once = std::size_t(Batch::lanes);

/// Boxes of as many pixels on average, or more, are hardly ever tiny.
constexpr int most_pixels_if_tiny = 64;

/// Scan-converts those of at most tiny_at_once triangles of the tile whose box is tiny and not cut
/// by the tile's left side: pixels and depths are scan_convert's. The ids of all of them are
/// `first`, first + 1, ...; bit i of the result is set where triangle i is left to scan_convert.
unsigned scan_convert_tiny(std::span<const DrawnTriangle> triangles, TriangleId first,
                           VisibilityTile& visibility);

}  // namespace scanlit
