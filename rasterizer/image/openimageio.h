// Stage (11) as far as OpenImageIO does it: the library libscanlit_images.so, loaded when the first
// image is read or written (see on_demand.h). Nothing else includes or links OpenImageIO but the
// input `image`. The functions do what those of the same name do outside of the namespace.
#pragma once

#include <optional>

#include "rasterizer/image.h"
#include "rasterizer/image/animation.h"
#include "rasterizer/image/labels.h"

namespace scanlit::openimageio {

ImageReport write_image(const std::filesystem::path& file, const Framebuffer& framebuffer,
                        const ImageOptions& options);
void check_image_target(const std::filesystem::path& file, int width, int height);
void write_aovs(const std::filesystem::path& file, const Framebuffer& framebuffer);
Framebuffer read_image(const std::filesystem::path& file, Encoding encoding);
void check_animation(const std::filesystem::path& file, int width, int height, int frames);
void write_animation(const std::filesystem::path& file, int frames,
                     const std::function<Framebuffer(int)>& frame, double frames_per_second,
                     Encoding encoding);

/// In pixels; none where the font file cannot be read, or there is nothing to see.
std::optional<int> text_width(const std::string& font_file, const std::string& text, int size);
void draw_text(Framebuffer& picture, const std::string& font_file, int x, int y,
               const std::string& text, int size, Align align, const Rgb<float>& colour);

/// What the library hands out, under the name scanlit_images.
struct Functions {
  decltype(&openimageio::write_image) write_image;
  decltype(&openimageio::check_image_target) check_image_target;
  decltype(&openimageio::write_aovs) write_aovs;
  decltype(&openimageio::read_image) read_image;
  decltype(&openimageio::check_animation) check_animation;
  decltype(&openimageio::write_animation) write_animation;
  decltype(&openimageio::text_width) text_width;
  decltype(&openimageio::draw_text) draw_text;
};

/// Loads the library the first time.
const Functions& functions();

}  // namespace scanlit::openimageio
