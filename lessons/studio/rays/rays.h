// Rays through a scene: which surface one hits, and whether one gets through. Embree answers. It is
// what global illumination needs, and what local reflection does without.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <random>

#include "rasterizer/camera.h"
#include "rasterizer/framebuffer.h"
#include "rasterizer/scene.h"

namespace scanlit::studio {

struct Ray {
  glm::dvec3 origin, direction;  // world space; the direction is unit
};

struct Hit {
  const Object* object = nullptr;   // null: the ray hits nothing
  glm::dvec3 position{}, normal{};  // world space; the vertices' normal interpolated, as in Phong
                                    // shading, and turned to the ray's side; unit
};

class Rays {
 public:
  /// The scene outlives it, unchanged. Throws Error where Embree fails.
  explicit Rays(const Scene& scene);
  ~Rays();
  Rays(const Rays&) = delete;
  Rays& operator=(const Rays&) = delete;

  Hit first_hit(const Ray& ray) const;
  /// Whether nothing stands between.
  bool free(const glm::dvec3& from, const glm::dvec3& to) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
  const Scene& scene_;
};

/// pi f_r (N.L) of the model at the hit, from l to v (world space, unit), both its parts. Tangents
/// are any: for models that are isotropic.
Rgb<double> reflected(const Hit& hit, const glm::dvec3& l, const glm::dvec3& v);

/// The numbers of one pixel, the same each time.
using Random = std::mt19937;
/// In [0, 1).
double uniform(Random& random);
/// A point in the ball of radius 1, all of its volume alike.
glm::dvec3 in_ball(Random& random);
/// A direction above a surface, with the density (N.L) / pi.
glm::dvec3 diffuse_direction(const glm::dvec3& normal, Random& random);

/// A picture of the light along the camera's rays: of each pixel the mean of so many, through
/// random points of it.
Framebuffer trace(const Camera& camera, int width, int height, int rays_per_pixel,
                  const std::function<Rgb<double>(const Ray&, Random&)>& light_along);

}  // namespace scanlit::studio
