// S9 and S10: a room of which little is seen at a time.
//
// Floor and ceiling of 80 x 80, 8 above each other, and four walls about them; 64 pillars of 1 x 1
// on a grid of 10; four inner walls at a distance of 12 from the centre, each with a door of 6 in
// its middle. All are boxes, one draw each, and drawn first. Then 1,000 teapots ("teapot:8") stand
// on the floor, .02 above it, their size (.5 to 1 times the shape's), their place and the way they
// are turned drawn from std::mt19937 of seed 9, where they touch neither a box nor one another;
// but the first stands 5 before the camera. The camera is at (0, 2, 0). Boxes have b = (.6, .6,
// .6).
#pragma once

#include "bench_scenes.h"

namespace scanlit::bench {

constexpr int teapot_count = 1000;

/// `name` is S9, S10L, S10M (the first teapot turns) or S10N.
BenchScene teapots_in_a_room(const std::string& name);

/// The teapots of frame 0: a pixel of theirs is seen, or would be if each were alone, or not.
struct Census {
  int visible = 0, hidden = 0, outside = 0;
};
/// By looking: draws the scene with ids, then every teapot alone that is not in that picture.
Census count_teapots(const BenchScene& scene);

}  // namespace scanlit::bench
