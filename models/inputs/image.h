// Input: an image file over the texture coordinates.
//
//   image(cow.png)    image(scratches.exr,wrap=mirror)    image(gloss.png,space=linear)
//
// (u, v) = (0, 0) is the image's lower left corner, (1, 1) its upper right one, as OBJ files have
// it: row 0 of an image is on top, v grows upwards. Beyond, `wrap` says what there is.
//
// space says how integer formats are meant: a colour is decoded by the sRGB curve (IEC 61966-2-1),
// a number (roughness, an exponent) is taken as it is; space=srgb or linear says so for both. Float
// formats (EXR, HDR) are linear. Grey images serve as colours; of a colour image a number takes the
// red channel. Alpha is not looked at.
//
// Where the engine knows the size of a pixel in texture coordinates (Phong shading), the image is
// averaged over that, by a trilinear MIP-map with an anisotropic filter; it neither flickers nor
// shows moire at a distance. Elsewhere the value is that of a point, bilinear between pixels.
#pragma once

#include "models/registry.h"

namespace scanlit::models {

/// Reads the file whole: what happens to it later has no effect. Throws Error naming it: missing,
/// no image, truncated, a pixel that is NaN or infinite, a side above 16384.
std::shared_ptr<const Input> make_image_input(const std::filesystem::path& file,
                                              const std::string& space, const std::string& wrap);

inline const bool image_registered = add(InputEntry{
    {.kind = Kind::input,
     .name = "image",
     .title = "an image over the texture coordinates",
     .example = "image(FILE)",
     .parameters = {{.key = "file",
                     .kind = ParameterKind::file,
                     .initial = std::string(),
                     .meaning = "image file, relative to the scene's"},
                    {.key = "space",
                     .kind = ParameterKind::choice,
                     .initial = std::string("automatic"),
                     .choices = {"automatic", "srgb", "linear"},
                     .meaning = "how integers are meant; automatic: srgb for colours alone"},
                    {.key = "wrap",
                     .kind = ParameterKind::choice,
                     .initial = std::string("periodic"),
                     .choices = {"periodic", "clamp", "mirror", "black"},
                     .meaning = "what there is beyond the image"}}},
    [](const Values& values) {
      const auto text = [&](const char* key) {
        return std::get<std::string>(value_of(values, key));
      };
      return make_image_input(text("file"), text("space"), text("wrap"));
    }});

}  // namespace scanlit::models
