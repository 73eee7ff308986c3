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
  glm::dvec2 high(-infinity), low(-infinity);
  double nearest = -infinity, farthest = infinity;
  for_each_position(scene, [&](const glm::dvec3& position) {
    const glm::dvec3 p = viewer_from_world * position;
    high = glm::max(high, glm::dvec2(p) + slope * p.z);
    low = glm::max(low, -glm::dvec2(p) + slope * p.z);
    nearest = std::max(nearest, p.z);
    farthest = std::min(farthest, p.z);
  });
  if (nearest == -infinity) return camera;

  const glm::dvec2 extent = high + low;
  // What has no extent (a point, or a line along the view) still gets a picture around it.
  const double size = std::max({extent.x, extent.y, nearest - farthest, 1e-6});
  const double step_back = 0.01 * size;
  double e_z = nearest + size;
  Camera result = camera;
  if (perspective)
    e_z = std::max({extent.x / (2 * slope.x), extent.y / (2 * slope.y), nearest + 10 * step_back});
  else
    result.height = margin * std::max({extent.y, extent.x / aspect, step_back});
  result.eye = world_from_viewer * glm::dvec3((high - low) / 2.0, e_z);
  result.target = world_from_viewer * glm::dvec3((high - low) / 2.0, (nearest + farthest) / 2);
  result.near = e_z - nearest - step_back;
  result.far = e_z - farthest + step_back;
  return result;
}

}  // namespace scanlit::studio
