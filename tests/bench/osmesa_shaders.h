// The comparison's shading (bench_scenes.h) in GLSL 3.30.
#pragma once

#include <string>

#include "bench_scenes.h"

namespace scanlit::bench {

struct ShaderTexts {
  std::string vertex, fragment;
};
ShaderTexts shader_texts(Shader shader);

}  // namespace scanlit::bench
