#include "rasterizer/occlusion.h"

#include <algorithm>

#include "rasterizer/coarse_depth.h"
#include "rasterizer/parallel.h"
#include "rasterizer/stage_timer.h"
#include "rasterizer/triangle_culling.h"

namespace scanlit {

void Occlusion::reset(const Frame& frame) {
  picture_ = picture_rect(frame.viewport);
  columns_ = (picture_.x_end + block_width - 1) / block_width;
  const int rows = (picture_.y_end + block_height - 1) / block_height;
  least_.assign(std::size_t(columns_) * std::size_t(rows), 0.0f);
}

void Occlusion::put(const VisibilityTile& tile) {
  // Blocks that triangles may touch in part alone are left at 0, as are those of the picture's
  // edge.
  const Rect& in = tile.touched;
  const int first_column = (in.x_begin + block_width - 1) / block_width,
            end_column = in.x_end / block_width;
  for (int y = (in.y_begin + block_height - 1) / block_height * block_height;
       y + block_height <= in.y_end; y += block_height)
    for (int column = first_column; column < end_column; ++column) {
      const int x = column * block_width;
      least_[std::size_t(y / block_height * columns_ + column)] =
          least_depth({x, y, x + block_width, y + block_height}, tile);
    }
}

bool Occlusion::hides(const ScreenBounds& bounds) const {
  const Rect pixels = intersection(bounds.pixels, picture_);
  if (pixels.empty()) return false;  // the least depth of no pixel is not known
  for (int row = pixels.y_begin / block_height; row <= (pixels.y_end - 1) / block_height; ++row)
    for (int column = pixels.x_begin / block_width; column <= (pixels.x_end - 1) / block_width;
         ++column)
      if (!(bounds.nearest < double(least_[std::size_t(row * columns_ + column)]))) return false;
  return true;
}

namespace {

/// Marks them, if there are any and it is likely to pay.
bool choose_occluders(Frame& frame) {
  std::int64_t triangles = 0, others = 0;
  for (Draw& draw : frame.draws) {
    if (draw.outside) continue;
    const auto& clusters = draw.clusters->clusters;
    draw.occluder = clusters.size() == 1;
    if (draw.occluder)
      triangles += clusters[0].triangle_count;
    else
      others += std::int64_t(clusters.size());
  }
  // Measured: a cluster that is skipped saves .6 microseconds, as much as 500 pixels of the
  // occluders' depth take, or six of their triangles. It pays if half of the clusters are hidden.
  const std::int64_t pixels = std::int64_t(frame.viewport.width) * frame.viewport.height;
  const bool pays = triangles > 0 && others / 2 >= pixels / 500 + triangles / 6;
  for (Draw& draw : frame.draws) draw.occluder = draw.occluder && pays;
  return pays;
}

}  // namespace

void find_hidden(Frame& frame, Workers& workers, Occlusion& occlusion) {
  if (!choose_occluders(frame)) return;
  parallel(frame.chunks.size(), [&](std::size_t i) {
    Chunk& chunk = frame.chunks[i];
    chunk.bins.clear();
    if (chunk.draw->occluder) assemble(frame, chunk, workers.local().shader.stats);
  });
  occlusion.reset(frame);
  frame.occlusion = &occlusion;
  parallel(std::size_t(frame.grid.count()), [&](std::size_t i) {
    Worker& worker = workers.local();
    const StageTimer timer(worker.shader.stats, Stage::scan_conversion);
    FrameStats not_counted;  // these triangles are going to be drawn again
    worker.triangles.gather(frame, int(i), worker.visibility);
    worker.triangles.scan_convert_all(frame, worker.visibility, not_counted,
                                      [](TriangleId, const VisibleColumns*) {});
    occlusion.put(worker.visibility);
  });
  parallel(frame.draws.size(), [&](std::size_t i) {
    Draw& draw = frame.draws[i];
    if (draw.outside || draw.occluder) return;
    const ClusterCuller culler(draw, frame.viewport);
    const Sphere& bounds = draw.clusters->bounds;
    draw.hidden =
        culler.view(bounds) == ClusterView::inside && occlusion.hides(culler.screen_bounds(bounds));
  });
}

}  // namespace scanlit
