// What `scanlit watch` shows without a scene.
#pragma once

#include "rasterizer/camera.h"
#include "rasterizer/scene.h"

namespace scanlit::studio {

/// Two triangles whose shared edge runs through pixel centres, and a third one that passes through
/// them; the picture's pixels are the units of world space.
struct WatchExample {
  int width = 32, height = 18;
  Scene scene;
  Camera camera;
};
WatchExample watch_example();

}  // namespace scanlit::studio
