// One pixel, and what each stage made for it: for programs that explain a picture. Every number is
// the engine's own, computed by its stage functions in its own precision; nothing here is a second
// implementation.
#pragma once

#include "rasterizer/point_record.h"

namespace scanlit {

/// A triangle's contribution to the pixel.
struct FragmentRecord {
  std::uint32_t object = 0, triangle = 0;  // in the scene, in its mesh
  bool back_facing = false;                // its normals are flipped
  bool clipped = false;                    // `screen` is a piece of it
  ScreenTriangle screen{};
  int x_begin = 0, x_end = 0;  // its span in the pixel's row; empty if it covers no centre there
  float b1 = 0, b2 = 0;        // barycentric coordinates in the mesh's triangle
  float weight = 0;            // share of the pixel's samples
  Vec3<float> normal{};        // as shaded: Framebuffer::normal
  std::vector<PointRecord> points{};                    // one, or Gouraud's three vertices
  Rgb<float> ambient{}, diffuse{}, glossy{}, colour{};  // of weight 1
};

/// A triangle at a sample.
struct LayerRecord {
  std::uint32_t object = 0, triangle = 0;
  float depth = 0;
};

struct SampleRecord {
  SampleOffset offset{};              // from the pixel's centre
  std::vector<LayerRecord> layers{};  // drawn triangles that cover it, nearest first: the visible
                                      // one, and what it hides
};

struct PixelRecord {
  int x = 0, y = 0;
  std::vector<SampleRecord> samples{};
  std::vector<FragmentRecord>
      fragments{};        // in the order in which they were added; none: background
  float covered[4] = {};  // their weighted sum, RGBA
  float colour[4] = {};   // and the background behind it
  float drawn[4] = {};    // what the Renderer wrote for the whole picture: `colour`, to the bit
};

/// Draws a picture and records one of its pixels. All of the settings' skips but those that say
/// which triangles are drawn are off. Throws Error as Renderer::render() does, and where the pixel
/// is not in the picture.
PixelRecord record_pixel(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                         int width, int height, int x, int y);

}  // namespace scanlit
