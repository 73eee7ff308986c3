// Ten scenes made by chance, R0 to R9, frozen by their seeds before anything was tuned for them:
// one to five built-in shapes of any tessellation, one to 64 lights of all kinds, models and
// materials, seen from anywhere.
#pragma once

#include <string>
#include <vector>

#include "rasterizer/render.h"

namespace scanlit::bench {

struct FrozenScene {
  std::string name;
  Scene scene;
  Camera camera;
};

std::vector<FrozenScene> frozen_scenes();

}  // namespace scanlit::bench
