// Clip space as pipeline.h says it, plainly, for tests to compare with.
#pragma once

#include <cmath>
#include <vector>

#include "rasterizer/pipeline.h"

namespace scanlit::test {

/// The planes it is outside of.
inline unsigned outcode(const ClipVertex& v, const Viewport& viewport) {
  const float limit_x = v.w * viewport.guard_x(), limit_y = v.w * viewport.guard_y();
  unsigned code = 0;
  const auto require = [&](bool inside, Outside bit) { code |= inside ? 0u : unsigned(bit); };
  require(v.z <= v.w, outside_near);
  require(v.z >= 0, outside_far);
  require(-limit_x <= v.x, outside_left);
  require(v.x <= limit_x, outside_right);
  require(-limit_y <= v.y, outside_bottom);
  require(v.y <= limit_y, outside_top);
  for (const float coordinate : {v.x, v.y, v.z, v.w})
    require(std::abs(coordinate) <= 1e18f, out_of_range);
  return code;
}

inline std::vector<ClipVertex> in_clip_space(const std::vector<glm::vec3>& positions,
                                             const Camera& camera, const Viewport& viewport) {
  Draw draw{};
  draw.clip_from_object =
      glm::mat4(clip_from_world(camera, double(viewport.width) / viewport.height));
  std::vector<ClipVertex> result;
  for (const glm::vec3& p : positions) result.push_back(transform(draw, p));
  return result;
}

}  // namespace scanlit::test
