// Draws one picture of S2 and says so: started by bench_versus_llvmpipe, which looks at the clock.
#include <cstdio>

#include "scanlit_side.h"

int main() {
  using namespace scanlit::bench;
  const BenchScene scene = make_bench_scene("S2");
  ScanlitSide renderer(2);
  renderer.prepare(scene);
  renderer.draw(scene, 0);
  std::puts(renderer.picture()[4 * (540 * picture_width + 960) + 3] ? "drawn" : "nothing drawn");
}
