// Whether rasterizer and ray tracer see the same surfaces.
#pragma once

#include <cstdint>
#include <vector>

#include "rasterizer/framebuffer.h"
#include "rasterizer/pipeline.h"

namespace scanlit::bench {

/// What each pixel of a width x height picture sees; pixel (x, y) is element y * width + x.
struct Hits {
  std::vector<std::uint32_t> object, triangle;  // no_id: nothing
  std::vector<float> distance;                  // along the viewing direction

  Hits(int width, int height)
      : object(std::size_t(width) * std::size_t(height), no_id),
        triangle(object),
        distance(object.size()) {}
};

/// The smallest rectangle that holds every covered pixel; needs ids.
Rect covered_rect(const Framebuffer& picture);

/// In pixels. Scanlit rounds vertices to 1/256 pixel, rays meet them where they are: along edges
/// neighbouring triangles change places.
struct VisibilityDifference {
  std::int64_t both = 0;                        // covered in both
  std::int64_t another_triangle = 0;            // of these
  std::int64_t another_surface = 0;             // of these, at a distance that differs by more than
  static constexpr double same_surface = 1e-3;  // this share of it
  std::int64_t coverage_differs = 0;
  std::int64_t coverage_differs_inside = 0;  // not at the silhouette: no pixel next to it, or all,
                                             // covered by Scanlit
  double max_distance = 0, mean_distance = 0;  // differences over distances, where both cover
};

/// The picture has depth and ids, of a camera between near_distance and far_distance.
VisibilityDifference compare(const Framebuffer& picture, const Hits& hits);

}  // namespace scanlit::bench
