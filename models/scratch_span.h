// Room for the arrays of a span that a model made of models has evaluated.
#pragma once

#include <cstddef>
#include <vector>

#include "rasterizer/reflection_model.h"

namespace scanlit::models {

/// `count` arrays for a span of `size` points, up to whole vectors.
class ScratchArrays {
 public:
  ScratchArrays(std::size_t size, std::size_t count)
      : padded_((size + max_lanes - 1) / max_lanes * max_lanes), values_(padded_ * count) {}

  float* operator[](std::size_t array) { return values_.data() + array * padded_; }

 private:
  std::size_t padded_;
  std::vector<float> values_;
};

struct ScratchReflection {
  explicit ScratchReflection(std::size_t size) : arrays(size, 6) {
    for (std::size_t c = 0; c < 3; ++c) span.diffuse[c] = arrays[c], span.glossy[c] = arrays[3 + c];
  }

  ScratchArrays arrays;
  ReflectionSpan span;
};

}  // namespace scanlit::models
