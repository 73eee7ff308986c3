// Pictures of the true surface that a mesh stands for: what flat, Gouraud and Phong shading of the
// mesh approximate. The mesh says which surface a pixel sees and roughly where; from there the ray
// through the pixel's centre is intersected with the surface itself, in double.
//
//   sphere    |p| = 1, solved as a quadratic
//   torus     the distance to the tube, sqrt((sqrt(x^2 + y^2) - R)^2 + z^2) - r, by Newton's method
//             along the ray
//   teapot    S(u, v) = o + t d on a bicubic Bezier patch, by Newton's method in u, v and t
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "rasterizer/reference/reference.h"
#include "rasterizer/reference/surface_light.h"

namespace scanlit {

/// Object space; direction of any length but 0.
struct Ray {
  glm::dvec3 origin, direction;
};

class AnalyticSurface {
 public:
  virtual ~AnalyticSurface() = default;

  /// Where the ray meets the surface near origin + t direction: position and outward unit normal.
  /// Nothing where it passes by, or where Newton's method does not come to rest within .1 units of
  /// that point, as happens near contours.
  virtual std::optional<ObjectPoint> meet(const Ray& ray, double t) const = 0;
};

/// Of a built-in shape's specification or name, as Mesh::name has it ("sphere:64"); null for a
/// shape that has none.
std::unique_ptr<AnalyticSurface> analytic_surface(std::string_view shape);

/// The scene with every mesh replaced by its surface; triangle ids are those of the meshes, which
/// should be fine. Nothing is seen where a ray misses mesh or surface. Throws Error where an object
/// is no sphere, icosphere, torus or teapot, and as render_reference does.
ExactPicture render_analytic(const Scene& scene, const Camera& camera, int width, int height);

}  // namespace scanlit
