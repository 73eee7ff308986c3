// The reference renderer: what a picture should be, in double, by the plainest way there is. Each
// triangle is tested at every pixel centre of its box on the screen; the nearest hit is kept; at
// each pixel attributes are interpolated and the reflection model is evaluated. No acceleration
// structure, no vector code, no shortcut.
//
// Two steps are the engine's own, so that the same triangles are seen and colours can be compared:
// the vertices as the vertex stage has snapped them to 1/256 pixel (transform(), project()) and the
// near-plane and guard-band cuts (clip()). All that follows is done anew: coverage by three edge
// functions in whole numbers, depth, perspective, normals, lights and models in double.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "rasterizer/framebuffer.h"
#include "rasterizer/scene.h"

namespace scanlit {

/// A picture in double. Pixel (x, y) is element y * width + x; row 0 on top.
struct ExactPicture {
  int width = 0, height = 0;
  std::vector<Rgb<double>> colour;      // linear radiance; the background where nothing is seen
  std::vector<std::uint32_t> object;    // in Scene::objects; no_id where nothing is seen
  std::vector<std::uint32_t> triangle;  // in its mesh
  std::vector<double> distance;    // from the eye along the viewing direction, world units; 0 where
                                   // nothing is seen
  std::vector<glm::dvec3> normal;  // world space, unit, on the viewer's side, interpolated whatever
                                   // the shading; (0,0,0) where nothing is seen

  ExactPicture() = default;
  ExactPicture(int width_pixels, int height_pixels, const Rgb<double>& background);

  std::size_t pixel_count() const { return colour.size(); }
};

/// One sample a pixel; flat, Gouraud and Phong shading as the objects ask for it. Throws Error as
/// Renderer::render does.
ExactPicture render_reference(const Scene& scene, const Camera& camera, int width, int height);

/// What the engine drew, in linear_float, with ids where it has them; without distances and
/// normals.
ExactPicture exact_picture(const Framebuffer& framebuffer);

}  // namespace scanlit
