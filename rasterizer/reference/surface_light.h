// (9) in double: what one surface point sends to the viewer. The plain counterpart of lighting.cpp,
// radiance.h and tangents.cpp, point by point and light by light, with nothing skipped.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

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
};

/// The normal in world space, unit: by the inverse transpose of world_from_object (times its
/// determinant, for it exists where the inverse does not). `otherwise` where it has no length.
glm::dvec3 world_normal(const Object& object, const ObjectPoint& point,
                        const glm::dvec3& otherwise);

/// Linear radiance towards the viewer under all the scene's lights, with the ambient part.
/// Parameters that vary over the surface are taken as the model's inputs give them, in float.
Rgb<double> radiance_in_double(const Scene& scene, const Camera& camera, const Object& object,
                               const ObjectPoint& point);

}  // namespace scanlit
