#include "models/inputs/image.h"
#include "models/inputs/image_library.h"
#include "rasterizer/on_demand.h"

namespace scanlit::models {

std::shared_ptr<const Input> make_image_input(const std::filesystem::path& file,
                                              const std::string& space, const std::string& wrap) {
  static const auto make = *static_cast<const ImageInputMaker*>(
      on_demand("libscanlit_image_input.so", "scanlit_image_input"));
  return make(file, space, wrap);
}

}  // namespace scanlit::models
