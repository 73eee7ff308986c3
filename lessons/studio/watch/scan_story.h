// What scan conversion does in a small part of a picture, step by step, for an animation. Triangles
// come from the engine while it draws the picture (frame_probe.h); spans, depth tests and which
// centres lie on an edge from its own stage (7).
#pragma once

#include <vector>

#include "rasterizer/pipeline.h"
#include "rasterizer/scene.h"

namespace scanlit::studio {

/// A pixel centre that lies exactly on an edge of the triangle.
struct EdgeCentre {
  int x;
  bool counts;  // by the fill rule
};

/// A row of the part: the triangle's span there, and what came of its pixels.
struct ScannedRow {
  int y = 0;
  int x_begin = 0, x_end = 0;      // pixels [x_begin, x_end), of the part
  std::vector<bool> nearer{};      // for each, whether it won the depth test
  std::vector<EdgeCentre> edge{};  // also outside of the span
};

struct ScannedTriangle {
  std::uint32_t object = 0, triangle = 0;  // in the scene, in its mesh
  ScreenTriangle screen{};                 // a piece of it where it had to be cut
  std::vector<ScannedRow> rows{};          // that have pixels, or centres on an edge
};

struct ScanStory {
  Rect part{};                               // of the picture, in pixels
  std::vector<ScannedTriangle> triangles{};  // in the order in which they are drawn
  Framebuffer picture{};                     // the whole, shaded
};

/// Draws the picture with one sample a pixel. Throws Error as render() does.
ScanStory watch_scan_conversion(const Scene& scene, const Camera& camera,
                                const RenderSettings& settings, int width, int height,
                                const Rect& part);

}  // namespace scanlit::studio
