// Stages of the engine, one mesh, triangle or pixel at a time, for lessons that take one of them
// apart and leave the others to it.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "rasterizer/framebuffer.h"
#include "rasterizer/pipeline.h"
#include "rasterizer/scan_conversion.h"

namespace scanlit::studio {

/// Linear light into one pixel, covered.
inline void put(Framebuffer& image, int x, int y, const Rgb<double>& colour) {
  float* pixel = &image.colour[4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x))];
  pixel[0] = float(colour.r), pixel[1] = float(colour.g), pixel[2] = float(colour.b), pixel[3] = 1;
}

/// (3) The object's vertices in clip space.
std::vector<ClipVertex> clip_space(const Object& object, const Camera& camera, double aspect);

/// (5) Triangle number t on the screen. All three vertices have to be before the eye.
ScreenTriangle on_screen(const std::vector<ClipVertex>& vertices, const Mesh& mesh, std::size_t t,
                         const Framebuffer& image);

/// (7) Calls pixel(x, y) for every pixel of the image that the triangle covers, if it is a front
/// face.
template <class F>
void for_each_pixel(const ScreenTriangle& triangle, const Framebuffer& image, const F& pixel) {
  if (triangle.twice_area <= 0) return;
  for_each_span(triangle, 0, image.height, [&](int y, int x_begin, int x_end) {
    for (int x = std::max(0, x_begin); x < std::min(x_end, image.width); ++x) pixel(x, y);
  });
}

/// (7), (8) What is seen at a pixel's centre: a triangle, and where in it.
struct VisiblePoint {
  int x, y;                 // the pixel
  std::uint32_t triangle;   // of the mesh
  std::uint32_t corner[3];  // its vertices
  glm::dvec3 weight;        // of each: barycentric coordinates in the triangle itself; sum 1

  /// The mean of what the corners have, weighted. Not of unit length, where they are directions.
  template <class T>
  glm::dvec3 interpolated(const std::vector<T>& of_vertices) const {
    return weight.x * glm::dvec3(of_vertices[corner[0]]) +
           weight.y * glm::dvec3(of_vertices[corner[1]]) +
           weight.z * glm::dvec3(of_vertices[corner[2]]);
  }
};
/// Of one object alone, row by row.
std::vector<VisiblePoint> visible_points(const Object& object, const Camera& camera, int width,
                                         int height);

/// (9) The light that the scene's first object sends towards a viewer, by its material, where its
/// normal is this; under far lights only, by a model that is the same everywhere. Unit directions
/// in world space. In double.
Rgb<double> reflected_light(const Scene& scene, const glm::dvec3& normal,
                            const glm::dvec3& to_viewer);

}  // namespace scanlit::studio
