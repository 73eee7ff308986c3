// A3, depth and visibility. README.md says what each function is to do; `scanlit check .` says how
// far you are.
#include "visibility.h"

#include <algorithm>
#include <cmath>

#include "variant.h"

namespace a3 {

double depth_of(double distance, double near, double far) {
  //<< TODO(A3.1) From a distance along the viewing direction to a depth 0..1.
  if (variant::smaller_is_nearer) return far * (distance - near) / (distance * (far - near));
  return near * (far - distance) / (distance * (far - near));
  //== return 0.5;
  //>>
}

double depth_at(const Corner (&triangle)[3], double x, double y) {
  //<< TODO(A3.2) The depth of the triangle's plane at a point of the screen.
  const auto& [a, b, c] = triangle;
  const auto twice_area = [](double px, double py, double qx, double qy) {
    return px * qy - qx * py;
  };
  const double whole = twice_area(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
  const double of_b = twice_area(x - a.x, y - a.y, c.x - a.x, c.y - a.y) / whole;
  const double of_c = twice_area(b.x - a.x, b.y - a.y, x - a.x, y - a.y) / whole;
  return a.depth + of_b * (b.depth - a.depth) + of_c * (c.depth - a.depth);
  //== return triangle[0].depth;
  //>>
}

StoredDepth stored(double depth) {
  //<< TODO(A3.3) The whole number that stands for a depth; what leaves 0..1 is cut off.
  const double most = double((1u << variant::bits) - 1);
  const double scaled = std::clamp(depth, 0.0, 1.0) * most;
  return StoredDepth(variant::rounds ? std::floor(scaled + 0.5) : std::floor(scaled));
  //== return 0;
  //>>
}

StoredDepth farthest() {
  //<< TODO(A3.4) What the buffer holds before anything is drawn.
  return variant::smaller_is_nearer ? (1u << variant::bits) - 1 : 0;
  //== return 0;
  //>>
}

bool replaces(StoredDepth fresh, StoredDepth there) {
  //<< TODO(A3.4) Whether a fragment is drawn over what is there. For now: always.
  if (fresh == there) return variant::last_wins;
  return (fresh < there) == variant::smaller_is_nearer;
  //== return true;
  //>>
}

std::vector<int> draw(const std::vector<Fragment>& fragments, int width, int height,
                      const Stages& stages) {
  std::vector<int> seen(std::size_t(width * height), -1);
  //<< TODO(A3.5) The depth buffer. For now: each fragment is drawn over the one before.
  std::vector<StoredDepth> depth(seen.size(), stages.farthest());
  //== (void)stages;
  //>>
  for (const Fragment& f : fragments) {
    if (f.column < 0 || f.column >= width || f.row < 0 || f.row >= height) continue;
    const std::size_t pixel = std::size_t(f.row * width + f.column);
    //<<
    const StoredDepth fresh = stages.stored(f.depth);
    if (!stages.replaces(fresh, depth[pixel])) continue;
    depth[pixel] = fresh;
    //>>
    seen[pixel] = f.id;
  }
  return seen;
}

}  // namespace a3
