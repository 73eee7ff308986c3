#include "rasterizer/camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/trigonometric.hpp>
#include <string>

#include "rasterizer/error.h"

namespace scanlit {

namespace {

// Beyond it squares of distances leave float (see outcodes in vertex_stage.cpp).
constexpr double largest = 1e18;

bool in_range(const glm::dvec3& v) {
  return std::abs(v.x) <= largest && std::abs(v.y) <= largest && std::abs(v.z) <= largest;
}

glm::dmat4 view_from_world(const Camera& camera) {
  const glm::dvec3 back = towards_viewer(camera);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::normalize(camera.up), back));
  const glm::dvec3 up = glm::cross(back, right);
  glm::dmat4 view(1.0);
  const glm::dvec3 axes[3] = {right, up, back};
  for (int i = 0; i < 3; ++i)
    view = glm::row(view, i, glm::dvec4(axes[i], -glm::dot(axes[i], camera.eye)));
  return view;
}

}  // namespace

void validate(const Camera& camera) {
  const auto refuse = [](const std::string& what) { throw Error("camera", what); };
  if (!in_range(camera.eye)) refuse("eye must be finite, each coordinate at most 1e18");
  if (!in_range(camera.target)) refuse("target must be finite, each coordinate at most 1e18");
  if (!in_range(camera.up)) refuse("up must be finite, each coordinate at most 1e18");
  const glm::dvec3 direction = camera.target - camera.eye;
  const double length = glm::length(direction);
  if (!(length > 0) || !std::isfinite(length)) refuse("eye and target must differ");
  // Below this sine the right-hand vector is mostly rounding error and the picture would spin.
  const double up_length = glm::length(camera.up);
  if (!(glm::length(glm::cross(direction / length, camera.up / up_length)) > 1e-9))
    refuse("up must not be zero or parallel to the viewing direction");
  // Nearer, clip() could not tell a point before the near plane from what cancellation leaves.
  if (!(camera.near >= 1e-12 && camera.near <= largest)) refuse("near must be 1e-12 to 1e18");
  if (!(camera.far > camera.near)) refuse("far must be beyond near");
  if (camera.projection == Projection::perspective) {
    if (!(camera.fov_deg >= 1e-6 && camera.fov_deg < 180))
      refuse("field of view must be between 0 (1e-6 at least) and 180 degrees");
  } else {
    if (!(camera.height >= 1e-30 && camera.height <= largest))
      refuse("height must be above 0: 1e-30 to 1e18");
    if (!(camera.far <= largest)) refuse("an orthographic camera needs a finite far, at most 1e18");
  }
}

glm::dvec3 towards_viewer(const Camera& camera) {
  return glm::normalize(camera.eye - camera.target);
}

Viewer viewer_of(const Camera& camera, int width, int height) {
  const glm::dmat4 view = view_from_world(camera);
  const auto axis = [&](int i) { return glm::dvec3(glm::row(view, i)); };
  // Half of a pixel, at distance 1.
  const double half = std::tan(glm::radians(camera.fov_deg) / 2) / height;
  return {.far = camera.viewer_at_infinity || camera.projection == Projection::orthographic,
          .direction = axis(2),
          .eye = camera.eye,
          .first = axis(2) + axis(0) * (half * (width - 1)) - axis(1) * (half * (height - 1)),
          .right = axis(0) * (-2 * half),
          .below = axis(1) * (2 * half)};
}

glm::dmat4 clip_from_world(const Camera& camera, double aspect) {
  const double n = camera.near, f = camera.far;
  glm::dmat4 clip_from_view(0.0);
  if (camera.projection == Projection::perspective) {
    const double cot = 1.0 / std::tan(glm::radians(camera.fov_deg) / 2);
    const bool infinite = std::isinf(f);
    clip_from_view[0][0] = cot / aspect;
    clip_from_view[1][1] = cot;
    // depth = z / w = n (f - d) / (d (f - n)) at distance d = w; n / d where f is infinite.
    clip_from_view[2][2] = infinite ? 0.0 : n / (f - n);
    clip_from_view[3][2] = infinite ? n : n * f / (f - n);
    clip_from_view[2][3] = -1;
  } else {
    clip_from_view[0][0] = 2 / (camera.height * aspect);
    clip_from_view[1][1] = 2 / camera.height;
    // depth = (f - d) / (f - n), linear in the distance; w = 1.
    clip_from_view[2][2] = 1 / (f - n);
    clip_from_view[3][2] = f / (f - n);
    clip_from_view[3][3] = 1;
  }
  return clip_from_view * view_from_world(camera);
}

Camera framed(const Camera& camera, const Sphere& bounds, double aspect) {
  const double margin = 1.05;
  // A single point has no size; any frame around it will do.
  const double radius = bounds.radius > 0 ? bounds.radius * margin : 1.0;
  Camera result = camera;
  result.target = bounds.centre;
  double distance = 2 * radius;
  if (camera.projection == Projection::perspective) {
    const double half_vertical = glm::radians(camera.fov_deg) / 2;
    const double half_horizontal = std::atan(std::tan(half_vertical) * aspect);
    distance = radius / std::sin(std::min(half_vertical, half_horizontal));
  } else {
    result.height = 2 * radius / std::min(1.0, aspect);
  }
  result.eye = bounds.centre + towards_viewer(camera) * distance;
  result.near = distance - radius;
  result.far = distance + radius;
  // A field of view near 180 degrees would put the near plane into the eye.
  result.near = std::max(result.near, distance * 1e-3);
  return result;
}

}  // namespace scanlit
