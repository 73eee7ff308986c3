#include "rasterizer/image.h"

#include "rasterizer/image/openimageio.h"
#include "rasterizer/on_demand.h"

namespace scanlit {

const openimageio::Functions& openimageio::functions() {
  static const auto* const all =
      static_cast<const Functions*>(on_demand("libscanlit_images.so", "scanlit_images"));
  return *all;
}

ImageReport write_image(const std::filesystem::path& file, const Framebuffer& framebuffer,
                        const ImageOptions& options) {
  return openimageio::functions().write_image(file, framebuffer, options);
}

void check_image_target(const std::filesystem::path& file, int width, int height) {
  openimageio::functions().check_image_target(file, width, height);
}

void write_aovs(const std::filesystem::path& file, const Framebuffer& framebuffer) {
  openimageio::functions().write_aovs(file, framebuffer);
}

Framebuffer read_image(const std::filesystem::path& file, Encoding encoding) {
  return openimageio::functions().read_image(file, encoding);
}

void check_animation(const std::filesystem::path& file, int width, int height, int frames) {
  openimageio::functions().check_animation(file, width, height, frames);
}

void write_animation(const std::filesystem::path& file, int frames,
                     const std::function<Framebuffer(int)>& frame, double frames_per_second,
                     Encoding encoding) {
  openimageio::functions().write_animation(file, frames, frame, frames_per_second, encoding);
}

}  // namespace scanlit
