#include "visibility_difference.h"

#include <algorithm>
#include <cmath>

#include "bench_scenes.h"

namespace scanlit::bench {

namespace {

/// Depth is 1 at the near plane and 0 at the far plane, linear in 1 / distance.
double distance(double depth) {
  return near_distance * far_distance / (near_distance + depth * (far_distance - near_distance));
}

bool on_silhouette(const Framebuffer& picture, int x, int y) {
  int covered = 0, pixels = 0;
  for (int v = std::max(0, y - 1); v <= std::min(picture.height - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(picture.width - 1, x + 1); ++u) {
      covered +=
          picture.object_id[std::size_t(v) * std::size_t(picture.width) + std::size_t(u)] != no_id;
      ++pixels;
    }
  return covered > 0 && covered < pixels;
}

}  // namespace

Rect covered_rect(const Framebuffer& picture) {
  Rect rect{picture.width, picture.height, 0, 0};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      if (picture.object_id[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)] == no_id)
        continue;
      rect = {std::min(rect.x_begin, x), std::min(rect.y_begin, y), std::max(rect.x_end, x + 1),
              std::max(rect.y_end, y + 1)};
    }
  return rect;
}

VisibilityDifference compare(const Framebuffer& picture, const Hits& hits) {
  VisibilityDifference result;
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
    const bool here = picture.object_id[i] != no_id, there = hits.object[i] != no_id;
    if (here != there) {
      ++result.coverage_differs;
      const auto width = std::size_t(picture.width);
      if (!on_silhouette(picture, int(i % width), int(i / width))) ++result.coverage_differs_inside;
    }
    if (!here || !there) continue;
    ++result.both;
    const double difference = std::abs(distance(picture.depth[i]) / hits.distance[i] - 1);
    result.max_distance = std::max(result.max_distance, difference);
    result.mean_distance += difference;
    if (picture.object_id[i] == hits.object[i] && picture.triangle_id[i] == hits.triangle[i])
      continue;
    ++result.another_triangle;
    if (difference > VisibilityDifference::same_surface) ++result.another_surface;
  }
  if (result.both > 0) result.mean_distance /= double(result.both);
  return result;
}

}  // namespace scanlit::bench
