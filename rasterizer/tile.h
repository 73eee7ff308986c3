// (7) to (10) for one tile of the picture.
#pragma once

#include "rasterizer/pipeline.h"
#include "rasterizer/resolve.h"
#include "rasterizer/shading.h"

namespace scanlit {

/// What a thread keeps from tile to tile.
struct Worker {
  VisibilityTile visibility;
  SpanCollector collector;
  SpanShader shader;
  std::vector<float>
      colours;  // RGBA, where an 8-bit framebuffer cannot hold what is to be added up
};

/// Scan-converts, resolves and shades a tile, into its own part of the framebuffer, which is
/// cleared first.
void draw_tile(const Frame& frame, int tile, Worker& worker, Framebuffer& framebuffer);

}  // namespace scanlit
