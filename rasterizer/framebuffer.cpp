#include "rasterizer/framebuffer.h"

#include <string>

#include "rasterizer/error.h"

namespace scanlit {

void validate_size(int width, int height) {
  if (width >= 1 && width <= max_framebuffer_size && height >= 1 && height <= max_framebuffer_size)
    return;
  throw Error("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
              " pixels is not possible; each side must be 1.." +
              std::to_string(max_framebuffer_size));
}

Framebuffer::Framebuffer(int width_pixels, int height_pixels, const Planes& planes) {
  validate_size(width_pixels, height_pixels);
  width = width_pixels;
  height = height_pixels;
  format = planes.format;
  if (format == ColourFormat::linear_float)
    colour.resize(4 * pixel_count());
  else
    rgba8.resize(4 * pixel_count());
  if (planes.depth) depth.resize(pixel_count());
  if (planes.normal) normal.resize(3 * pixel_count());
  if (planes.ids) {
    object_id.resize(pixel_count(), no_id);
    triangle_id.resize(pixel_count(), no_id);
  }
  if (planes.parts)
    for (auto* part : {&ambient, &diffuse, &glossy}) part->resize(3 * pixel_count());
  if (planes.cost) cost.resize(2 * pixel_count());
}

}  // namespace scanlit
