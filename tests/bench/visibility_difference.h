// Whether rasterizer and ray tracer see the same surfaces.
#pragma once

#include "embree_peer.h"
#include "rasterizer/framebuffer.h"

namespace scanlit::bench {

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

/// The picture has depth and ids, and the comparison's camera.
VisibilityDifference compare(const Framebuffer& picture, const Hits& hits);

}  // namespace scanlit::bench
