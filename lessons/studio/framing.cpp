#include "lessons/studio/framing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

namespace scanlit::studio {
namespace {

constexpr double margin = 1.12;

template <class Use>
void for_each_position(const Scene& scene, const Use& use) {
  for (const Object& object : scene.objects) {
    const glm::dmat4 world_from_object(object.world_from_object);
    for (const glm::vec3& position : object.mesh->positions)
      use(glm::dvec3(world_from_object * glm::dvec4(position, 1.0)));
  }
}

}  // namespace

glm::dmat3 viewer_axes(const Camera& camera) {
  const glm::dvec3 back = towards_viewer(camera);
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, back));
  return {right, glm::cross(back, right), back};
}

// With all points p and the eye e on the viewer's axes, p is inside the right edge of the picture
// where p.x - e.x <= slope (e.z - p.z), that is e.x + slope e.z >= p.x + slope p.z; for the left
// edge the signs of x change. The largest right-hand sides of both give the smallest e.z and its
// e.x; likewise for y. Orthographic: slope 0, and the extents are what they leave apart.
Camera fitted(const Camera& camera, const Scene& scene, double aspect) {
  const bool perspective = camera.projection == Projection::perspective;
  const double slope_y = perspective ? std::tan(glm::radians(camera.fov_deg) / 2) / margin : 0;
  const glm::dvec2 slope(slope_y * aspect, slope_y);
  const glm::dmat3 world_from_viewer = viewer_axes(camera);
  const glm::dmat3 viewer_from_world = glm::transpose(world_from_viewer);

  constexpr double infinity = std::numeric_limits<double>::infinity();
  glm::dvec2 right_top(-infinity), left_bottom(-infinity);  // the largest right-hand sides
  glm::dvec3 low(infinity), high(-infinity);
  for_each_position(scene, [&](const glm::dvec3& position) {
    const glm::dvec3 p = viewer_from_world * position;
    right_top = glm::max(right_top, glm::dvec2(p) + slope * p.z);
    left_bottom = glm::max(left_bottom, -glm::dvec2(p) + slope * p.z);
    low = glm::min(low, p);
    high = glm::max(high, p);
  });
  if (low.x > high.x) return camera;

  const glm::dvec3 extent = high - low;
  // What has no extent (a point) still gets a picture around it.
  const double largest = std::max({extent.x, extent.y, extent.z});
  const double size = largest > 0 ? largest : 1.0;
  const glm::dvec2 middle = (right_top - left_bottom) / 2.0;
  const glm::dvec2 distance = (right_top + left_bottom) / (2.0 * slope);
  // Orthographic, any distance does; perspective, nothing comes nearer than a tenth of the scene.
  const double e_z =
      perspective ? std::max({distance.x, distance.y, high.z + 0.1 * size}) : high.z + size;
  Camera result = camera;
  result.height = margin * std::max({extent.y, extent.x / aspect, 0.01 * size});
  result.eye = world_from_viewer * glm::dvec3(middle, e_z);
  result.target = world_from_viewer * glm::dvec3(middle, (low.z + high.z) / 2);
  result.near = e_z - high.z - 0.01 * size;
  result.far = e_z - low.z + 0.01 * size;
  return result;
}

}  // namespace scanlit::studio
