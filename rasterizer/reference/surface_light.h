// (9) in double: what one surface point sends to the viewer. The plain counterpart of lighting.cpp,
// radiance.h and tangents.cpp, point by point and light by light, with nothing skipped.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "rasterizer/scene.h"

namespace scanlit {

/// A point of an object's surface, in object space.
struct ObjectPoint {
  glm::dvec3 position;
  glm::dvec3 normal;  // any length, on the viewer's side; (0,0,0): facing the viewer
  glm::dvec2 texcoord{0};
  glm::dvec3 colour{1};   // the vertex colour
  glm::dvec3 tangent{0};  // of the texture coordinates; looked at where `has_tangent`
  bool has_tangent = false;
  // By how much texcoord grows to the next pixel, on the right and below; only if `is_pixel`.
  glm::dvec2 texcoord_dx{0}, texcoord_dy{0};
  bool is_pixel = false;
  // World space, unit: V of what a pixel sees, which is seen along the pixel's own ray, though
  // snapping has moved the triangle by up to 1/512 pixel. None: from the position to the eye.
  std::optional<glm::dvec3> to_viewer{};
};

/// From what is seen at a pixel's centre towards the eye, in world space: not unit, but linear in x
/// and y. Of a perspective camera.
glm::dvec3 pixel_to_eye(const Camera& camera, int width, int height, double x, double y);

/// The normal in world space, unit: by the inverse transpose of world_from_object (times its
/// determinant, for it exists where the inverse does not). `otherwise` where it has no length.
glm::dvec3 world_normal(const Object& object, const ObjectPoint& point,
                        const glm::dvec3& otherwise);

/// Linear radiance towards the viewer under all the scene's lights, with the ambient part.
/// Parameters that vary over the surface are taken as the model's inputs give them, in float.
Rgb<double> radiance_in_double(const Scene& scene, const Camera& camera, const Object& object,
                               const ObjectPoint& point);

}  // namespace scanlit
