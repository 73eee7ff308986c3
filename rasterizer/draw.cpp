#include "rasterizer/draw.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace scanlit {

Draw make_draw(const Object& object, std::uint32_t index, const glm::dmat4& clip_from_world,
               ClusterCache& clusters) {
  const glm::dmat4 world_from_object(object.world_from_object);
  const glm::dmat3 linear(world_from_object);
  const double determinant = glm::determinant(linear);
  // The cofactor matrix is the inverse transpose times the determinant, and exists where the
  // inverse does not. Scaled to about 1, so that no length of a normal leaves float's range.
  glm::dmat3 cofactor(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                      glm::cross(linear[0], linear[1]));
  double largest = 0;
  for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(cofactor[i / 3][i % 3]));
  if (largest > 0) cofactor *= (determinant < 0 ? -1 : 1) / largest;

  const bool both =
      object.sides == Sides::both || (object.sides == Sides::automatic && !object.mesh->closed);
  return {.object = &object,
          .mesh = object.mesh.get(),
          .clusters = clusters.of(object.mesh),
          .index = index,
          .clip_from_object = glm::mat4(clip_from_world * world_from_object),
          .normal_from_object = glm::mat3(cofactor),
          .draw_back_faces = both,
          .mirrored = determinant < 0};
}

}  // namespace scanlit
