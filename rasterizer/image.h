// (11) Image: linear light becomes a file, through OpenImageIO; the suffix decides the format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "rasterizer/framebuffer.h"

namespace scanlit {

/// How 8-bit (and 16-bit integer) formats hold linear light; float formats (EXR, HDR, PFM) always
/// stay linear.
enum class Encoding { srgb, linear };

struct ImageOptions {
  Encoding encoding = Encoding::srgb;
  double exposure_ev = 0;  // radiance is multiplied by 2^exposure_ev before it is encoded
};

struct ImageReport {
  std::int64_t clipped_pixels = 0;  // covered pixels of which a channel exceeded what an integer
                                    // format can hold; always 0 for float formats
};

/// Writes colour (RGBA; alpha is coverage). Output appears whole or not at all: it is written beside
/// its place and renamed. Throws Error naming the file: unknown suffix, folder missing or not
/// writable, disk full, picture too large for the format.
ImageReport write_image(const std::filesystem::path& file, const Framebuffer& framebuffer,
                        const ImageOptions& options = {});

/// Throws the Error that write_image would throw for this name and size, where that can be known
/// before the picture is rendered, so that nobody waits for a picture that has nowhere to go.
void check_image_target(const std::filesystem::path& file, int width, int height);

/// Writes every plane the framebuffer holds as named channels of one EXR: R G B A; depth.Z;
/// normal.X .Y .Z; id.object, id.triangle (uint); ambient.R .., diffuse.R .., glossy.R ...
/// Throws Error as write_image, and where the suffix is not .exr.
void write_aovs(const std::filesystem::path& file, const Framebuffer& framebuffer);

}  // namespace scanlit
