#include "lessons/studio/watch/scan_story.h"

#include <algorithm>
#include <mutex>

#include "rasterizer/frame_probe.h"
#include "rasterizer/scan_conversion.h"

namespace scanlit::studio {
namespace {

ScreenTriangle on_screen(const DrawnTriangle& triangle) {
  const auto& v = triangle.vertices;
  return screen_triangle(v[0], v[1], v[2]);
}

/// Collects the triangles that scan conversion sees in the part.
class Collector final : public FrameProbe {
 public:
  explicit Collector(const Rect& part) : part_(part) {}

  void tile_drawn(const Frame&, const VisibilityTile& visibility) override {
    if (intersection(visibility.rect, part_).empty()) return;
    const std::lock_guard lock(mutex_);
    for (const DrawnTriangle* triangle : visibility.triangles)
      if (!intersection(centre_bounds(on_screen(*triangle)), part_).empty())
        triangles_.push_back(*triangle);
  }

  /// Each once, though several tiles may have it.
  std::vector<DrawnTriangle> in_order() {
    const auto place = [](const DrawnTriangle& t) {
      return std::tuple(t.draw, t.triangle, t.chunk, t.piece);
    };
    std::ranges::sort(triangles_, {}, place);
    const auto repeats = std::ranges::unique(triangles_, {}, place);
    triangles_.erase(repeats.begin(), repeats.end());
    return std::move(triangles_);
  }

 private:
  Rect part_;
  std::mutex mutex_;
  std::vector<DrawnTriangle> triangles_;
};

/// Whether a pixel's centre lies exactly on an edge, and on no other edge's outer side.
bool on_edge(const ScreenTriangle& t, int x, int y) {
  const std::int64_t px = std::int64_t(x) * subpixel + half_pixel;
  const std::int64_t py = std::int64_t(y) * subpixel + half_pixel;
  bool exactly = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t edge = edge_function(t.vertices[k], t.vertices[(k + 1) % 3], px, py);
    if (t.twice_area > 0 ? edge < 0 : edge > 0) return false;
    exactly |= edge == 0;
  }
  return exactly;
}

ScannedRow scanned_row(const ScreenTriangle& triangle, int y, const Rect& part) {
  int begin = 0, end = 0;
  for_each_span(triangle, y, y + 1, [&](int, int first, int last) { begin = first, end = last; });
  ScannedRow row{.y = y};
  row.x_begin = std::max(begin, part.x_begin);
  row.x_end = std::max(row.x_begin, std::min(end, part.x_end));
  for (int x = part.x_begin; x < part.x_end; ++x)
    if (on_edge(triangle, x, y)) row.edge.push_back({x, begin <= x && x < end});
  return row;
}

}  // namespace

ScanStory watch_scan_conversion(const Scene& scene, const Camera& camera,
                                const RenderSettings& settings, int width, int height,
                                const Rect& part) {
  ScanStory story{.part = part, .picture = Framebuffer(width, height)};
  Collector collector(part);
  RenderSettings watched = settings;
  watched.samples = 1;
  watched.probe = &collector;
  watched.skips.hidden_triangles = false;  // to see them lose
  render(scene, camera, watched, story.picture);

  const std::vector<DrawnTriangle> drawn = collector.in_order();
  VisibilityTile tile;
  tile.reset(part, part, 1);
  for (const DrawnTriangle& triangle : drawn) {
    const auto id = TriangleId(tile.triangles.size());
    tile.triangles.push_back(&triangle);
    scan_convert(id, tile, nullptr);
    ScannedTriangle scanned{triangle.draw, triangle.triangle, on_screen(triangle), {}};
    for (int y = part.y_begin; y < part.y_end; ++y) {
      ScannedRow row = scanned_row(scanned.screen, y, part);
      for (int x = row.x_begin; x < row.x_end; ++x)
        row.nearer.push_back(tile.triangle[tile.row(0, y) + std::size_t(x - part.x_begin)] == id);
      if (!row.nearer.empty() || !row.edge.empty()) scanned.rows.push_back(std::move(row));
    }
    if (!scanned.rows.empty()) story.triangles.push_back(std::move(scanned));
  }
  return story;
}

}  // namespace scanlit::studio
