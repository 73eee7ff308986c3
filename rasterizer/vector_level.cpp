#include "rasterizer/vector_level.h"

#include "rasterizer/batch.h"

namespace scanlit {

std::string vector_level() {
  const char* name = HWY_TARGET == HWY_SSE4 ? "SSE4" : HWY_TARGET == HWY_AVX2 ? "AVX2" : "AVX-512";
  return std::string(name) + ", " + std::to_string(Batch::lanes) + " lanes";
}

}  // namespace scanlit
