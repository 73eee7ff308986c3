// Which vectors the engine runs on.
#pragma once

#include <string>

namespace scanlit {

/// "SSE4, 4 lanes", "AVX2, 8 lanes" or "AVX-512, 16 lanes": what this engine was compiled for, or,
/// where it is built for all of them, which of them the processor got.
std::string vector_level();

}  // namespace scanlit
