// The input `image` is in a library of its own, libscanlit_image_input.so, because OpenImageIO
// filters it: what it hands out, under the name scanlit_image_input. See rasterizer/on_demand.h.
#pragma once

#include "models/parameter.h"

namespace scanlit::models {

/// As make_image_input (image.h).
using ImageInputMaker = std::shared_ptr<const Input> (*)(const std::filesystem::path& file,
                                                         const std::string& space,
                                                         const std::string& wrap);

}  // namespace scanlit::models
