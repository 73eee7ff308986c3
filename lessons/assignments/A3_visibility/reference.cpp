#include "lessons/assignments/A3_visibility/reference.h"

#include <algorithm>

#include "lessons/assignments/judge/dice.h"

namespace scanlit::assignments::visibility {

DepthVariant depth_variant(std::uint64_t seed) {
  Dice dice(seed, "A3");
  return {.smaller_is_nearer = dice.coin(),
          .bits = dice.between(7, 10),
          .rounds = dice.coin(),
          .last_wins = dice.coin()};
}

double right_depth_of(const DepthVariant& variant, double distance, double near, double far) {
  // 0 at the far plane, 1 at the near plane; linear in 1 / distance.
  const double reversed = (1 / distance - 1 / far) / (1 / near - 1 / far);
  return variant.smaller_is_nearer ? 1 - reversed : reversed;
}

double right_depth_at(const Corner (&triangle)[3], double x, double y) {
  const auto& [a, b, c] = triangle;
  // depth = a.depth + right (x - a.x) + down (y - a.y), by Cramer's rule
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const double to_b = b.depth - a.depth, to_c = c.depth - a.depth;
  const double determinant = bx * cy - cx * by;
  const double right = (to_b * cy - to_c * by) / determinant;
  const double down = (bx * to_c - cx * to_b) / determinant;
  return a.depth + right * (x - a.x) + down * (y - a.y);
}

StoredDepth right_stored(const DepthVariant& variant, double depth) {
  const double scaled = std::clamp(depth, 0.0, 1.0) * variant.most();
  return StoredDepth(variant.rounds ? scaled + 0.5 : scaled);
}

StoredDepth right_farthest(const DepthVariant& variant) {
  return variant.smaller_is_nearer ? variant.most() : 0;
}

bool right_replaces(const DepthVariant& variant, StoredDepth fresh, StoredDepth there) {
  if (fresh == there) return variant.last_wins;
  return variant.smaller_is_nearer ? fresh < there : fresh > there;
}

std::vector<int> right_draw(const DepthVariant& variant, const std::vector<Fragment>& fragments,
                            int width, int height) {
  std::vector<int> seen(std::size_t(width * height), -1);
  std::vector<StoredDepth> depth(seen.size(), right_farthest(variant));
  for (const Fragment& f : fragments) {
    if (f.column < 0 || f.column >= width || f.row < 0 || f.row >= height) continue;
    const auto pixel = std::size_t(f.row * width + f.column);
    const StoredDepth fresh = right_stored(variant, f.depth);
    if (right_replaces(variant, fresh, depth[pixel])) depth[pixel] = fresh, seen[pixel] = f.id;
  }
  return seen;
}

}  // namespace scanlit::assignments::visibility
