// (7) to (10) for one tile of the picture.
#pragma once

#include "rasterizer/pipeline.h"
#include "rasterizer/resolve.h"
#include "rasterizer/reuse.h"
#include "rasterizer/shading.h"
#include "rasterizer/tile_triangles.h"

namespace scanlit {

/// What a thread keeps from tile to tile.
struct Worker {
  TileTriangles triangles;
  VisibilityTile visibility;
  SpanCollector collector;
  SpanShader shader;
  std::vector<float>
      colours;  // RGBA, where an 8-bit framebuffer cannot hold what is to be added up
};

/// Puts the background behind pixels that are covered in part or not at all.
void put_behind(std::span<float> rgba, const Rgb<double>& background);

/// Scan-converts, resolves and shades a tile, into its own part of the framebuffer, which is
/// cleared first. With Redo::shading the visibility stands as it is.
void draw_tile(const Frame& frame, int tile, Redo redo, Worker& worker, VisibilityTile& visibility,
               Framebuffer& framebuffer);

}  // namespace scanlit
