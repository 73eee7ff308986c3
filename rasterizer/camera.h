// (2) Camera: from world space to clip space.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace scanlit {

enum class Projection { perspective, orthographic };

/// World space is right-handed; the camera looks along its own -z. All lengths in world units.
struct Camera {
  glm::dvec3 eye{0, 0, 4};
  glm::dvec3 target{0, 0, 0};
  glm::dvec3 up{0, 1, 0};  // need not be perpendicular to the viewing direction, nor of unit length
  Projection projection = Projection::perspective;
  double fov_deg = 45;  // vertical field of view, 1e-6 <= fov < 180; perspective only
  double height = 2;    // vertical extent of the picture; orthographic only
  double near = 0.01;   // distance from the eye, 1e-12..1e18
  double far = std::numeric_limits<double>::infinity();  // > near; orthographic: at most 1e18
  bool viewer_at_infinity = false;  // V is the same for every point (an orthographic viewer's
                                    // always is)

  friend bool operator==(const Camera&, const Camera&) = default;
};

/// Throws Error naming the field: NaN or Inf, eye equal to target, up parallel to the viewing
/// direction, an angle, height, near or far out of range.
void validate(const Camera& camera);

/// The matrix of stage (3): clip_position = clip_from_world * world_position, computed in double
/// and rounded once. After division by w: x and y in [-1, 1] with +y up, depth 1 at near and 0 at
/// far (reversed: float is densest near 0, so far distances keep their precision).
glm::dmat4 clip_from_world(const Camera& camera, double aspect);

/// Unit vector from the scene towards a viewer at infinity.
glm::dvec3 towards_viewer(const Camera& camera);

/// The camera as a shaded point sees it: where V comes from. World space.
struct Viewer {
  bool far;             // infinitely far: V is `direction` everywhere
  glm::vec3 direction;  // unit, from the scene; also in place of a V that has none
  glm::vec3 eye;
  // From what is seen at a pixel's centre, in perspective: first + column right + row below. Not
  // unit. So a fragment's V needs no position.
  glm::vec3 first, right, below;
};
Viewer viewer_of(const Camera& camera, int width, int height);

struct Sphere {
  glm::dvec3 centre{0};
  double radius = 0;
};

/// A copy of `camera` moved along its viewing direction (and, orthographic, resized) so that the
/// sphere fills the picture with a margin of 5 %; near and far are set to clear the sphere.
Camera framed(const Camera& camera, const Sphere& bounds, double aspect);

}  // namespace scanlit
