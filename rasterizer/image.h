// (11) Image: linear light becomes a file, through OpenImageIO; the suffix decides the format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "rasterizer/framebuffer.h"

namespace scanlit {

/// How integer formats (PNG, JPEG, BMP, TGA, TIFF, PPM; 8 bits a channel) hold linear light:
/// through the piecewise sRGB curve, or as it is. Float formats (EXR, HDR) always stay linear.
enum class Encoding { srgb, linear };

constexpr int max_exposure_ev = 32;

struct ImageOptions {
  Encoding encoding = Encoding::srgb;
  double exposure_ev = 0;  // radiance is multiplied by 2^exposure_ev before it is encoded;
                           // -max_exposure_ev..max_exposure_ev
};

struct ImageReport {
  std::int64_t clipped_pixels = 0;  // covered pixels of which a channel exceeded what an integer
                                    // format can hold; always 0 for float formats
};

/// Writes colour. EXR gets RGBA: alpha is coverage, colour is premultiplied by it and holds the
/// scene's background where that is not black. All other formats get RGB, the picture as it is seen
/// over that background: integer formats would want colour divided by alpha, and the background
/// with it. Output appears whole or not at all: it is written beside its place and renamed.
/// Throws Error naming the file: unknown suffix, folder missing or not writable, disk full,
/// exposure out of range.
ImageReport write_image(const std::filesystem::path& file, const Framebuffer& framebuffer,
                        const ImageOptions& options = {});

/// Throws the Error that write_image would throw for this name and size, where that can be known
/// before the picture is rendered, so that nobody waits for a picture that has nowhere to go.
void check_image_target(const std::filesystem::path& file, int width, int height);

/// Writes every plane the framebuffer holds as named channels of one EXR: R G B A; depth.Z;
/// normal.X .Y .Z; id.object, id.triangle (uint); ambient.R .., diffuse.R .., glossy.R ..;
/// cost.tests, cost.evaluations.
/// Throws Error as write_image, and where the suffix is not .exr.
void write_aovs(const std::filesystem::path& file, const Framebuffer& framebuffer);

/// Reads an image back as linear light: of an EXR every plane that write_aovs names, of any other
/// file its colour; alpha is 1 where the file has none. `encoding` says how integer formats are
/// meant. Throws Error naming the file: missing, no image, truncated, no R G B, larger than a
/// framebuffer can be.
Framebuffer read_image(const std::filesystem::path& file, Encoding encoding = Encoding::srgb);

}  // namespace scanlit
