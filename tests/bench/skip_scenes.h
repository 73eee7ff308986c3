// What the skip benchmark draws: the comparison's scenes, and scenes made to show one switch.
//
//   spots     S9 under 16 spot lights (outer angle 40 degrees, inverse square) that hang on a grid
//             of 12 below the ceiling and look down, in place of its light
//   far       S6 with lights in the directions of its lamps, seen by an orthographic camera:
//             viewer and lights are infinitely far
//   ambient   S4 under no light
//   inside    S4's sphere seen from inside, both sides of it drawn
//   msaa4     S8P with 4 samples a pixel
#pragma once

#include <string>
#include <vector>

#include "bench_scenes.h"
#include "rasterizer/render.h"

namespace scanlit::bench {

struct SkipScene {
  BenchScene bench;  // says what moves
  Scene scene;
  Camera camera;
  RenderSettings settings;
};

/// S1 to S10, then the above.
const std::vector<std::string>& skip_scene_names();

SkipScene make_skip_scene(const std::string& name, int threads);

}  // namespace scanlit::bench
