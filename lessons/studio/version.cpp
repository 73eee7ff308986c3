#include "lessons/studio/version.h"

#include "rasterizer/vector_level.h"

namespace scanlit::studio {

std::string version_text() {
  return "scanlit " SCANLIT_VERSION "\nvectors: " + vector_level() +
         "\ncompiler: " SCANLIT_COMPILER "\nlibraries: " SCANLIT_LIBRARIES;
}

}  // namespace scanlit::studio
