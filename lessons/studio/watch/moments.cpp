#include "lessons/studio/watch/moments.h"

#include <algorithm>

namespace scanlit::studio {

std::vector<Moment> moments_of(const ScanStory& story, double frames_per_second) {
  const auto for_seconds = [&](double seconds) {
    return std::size_t(std::max(1.0, seconds * frames_per_second));
  };
  const std::size_t on_edges = for_seconds(0.75);
  std::size_t rows = 0;
  for (const ScannedTriangle& triangle : story.triangles) rows += triangle.rows.size() + on_edges;
  const bool each_row = rows <= most_moments;
  std::vector<Moment> moments;
  for (std::size_t k = 0; k < story.triangles.size(); ++k) {
    const int last = int(story.triangles[k].rows.size()) - 1;
    if (each_row) moments.insert(moments.end(), on_edges, {k, -1});
    for (int r = each_row ? 0 : last; r <= last; ++r) moments.push_back({k, r});
  }
  moments.insert(moments.end(), for_seconds(2), {story.triangles.size(), 0});
  moments.insert(moments.end(), for_seconds(3), {story.triangles.size(), 1});
  return moments;
}

}  // namespace scanlit::studio
