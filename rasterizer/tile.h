// (7) to (10) for one tile of the picture.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include "rasterizer/occluder_depth.h"
#include "rasterizer/pipeline.h"
#include "rasterizer/resolve.h"
#include "rasterizer/reuse.h"
#include "rasterizer/shading.h"
#include "rasterizer/tile_colours.h"
#include "rasterizer/tile_triangles.h"

namespace scanlit {

/// What a thread keeps from tile to tile.
struct Worker {
  TileTriangles triangles;
  OccluderDepth occluders;
  VisibilityTile visibility;
  SpanCollector collector;
  SpanShader shader;
  TileColours colours;
};
using Workers = tbb::enumerable_thread_specific<Worker>;

/// Scan-converts, resolves and shades a tile, into its own part of the framebuffer, whatever that
/// held. With Redo::shading the visibility stands as it is.
void draw_tile(const Frame& frame, int tile, Redo redo, Worker& worker, VisibilityTile& visibility,
               Framebuffer& framebuffer);

}  // namespace scanlit
