// (10) Framebuffer: what the pipeline fills, row 0 on top: linear light, or 8-bit codes of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rasterizer/aligned_vector.h"

namespace scanlit {

constexpr int max_framebuffer_size = 16384;   // per side, in pixels
constexpr std::uint32_t no_id = 0xffffffffu;  // object or triangle id where nothing is covered

/// Throws Error where a side is not 1..16384.
void validate_size(int width, int height);

/// What the colour plane is made of. 8-bit codes are what a screen or a file wants: rounded to
/// nearest, and clamped to [0, 1] before, R first in memory; a quarter of the memory to fill.
enum class ColourFormat { linear_float, linear_8bit, srgb_8bit };

/// Which planes a frame fills, and how colour is stored. A plane that is not asked for costs
/// nothing.
struct Planes {
  bool depth = false;   // larger is nearer; 0 where nothing is covered
  bool normal = false;  // world space, unit, as shaded; (0,0,0) where nothing is covered
  bool ids = false;     // object: index in Scene::objects; triangle: index in its Mesh
  bool parts = false;   // ambient, diffuse and glossy, whose sum is the colour
  bool cost = false;    // what was done for each pixel; counting it takes time
  ColourFormat format = ColourFormat::linear_float;

  friend bool operator==(const Planes&, const Planes&) = default;
};

/// Pixel (x, y) is element y * width + x of each plane; a plane with k channels has k consecutive
/// floats per pixel. With several samples a pixel, colour, parts and normal are the weighted sums
/// over the samples; depth and ids are those of sample 0.
struct Framebuffer {
  int width = 0, height = 0;
  // Which frame it holds, as a number that no other frame of this process has; 0: none.
  std::uint64_t frame = 0;
  ColourFormat format = ColourFormat::linear_float;
  std::vector<float> colour;  // RGBA, linear, premultiplied; alpha is the covered share 0..1
  AlignedVector<std::uint8_t> rgba8;  // the same in 8 bits, instead of colour; alpha is linear
  std::vector<float> depth;
  std::vector<float> normal;  // xyz
  std::vector<std::uint32_t> object_id, triangle_id;
  std::vector<float> ambient, diffuse, glossy;  // rgb
  std::vector<float> cost;  // depth tests of fragments at the pixel's samples; points at which a
                            // reflection model was evaluated for it, times lights. Of the frame
                            // that last drew the pixel's tile (RenderSettings::reuse)

  Framebuffer() = default;
  /// Allocates; cleared to nothing covered. Throws Error as validate_size does.
  Framebuffer(int width_pixels, int height_pixels, const Planes& planes = {});

  std::size_t pixel_count() const { return std::size_t(width) * std::size_t(height); }
  Planes planes() const {
    return {!depth.empty(),   !normal.empty(), !object_id.empty(),
            !ambient.empty(), !cost.empty(),   format};
  }
};

}  // namespace scanlit
