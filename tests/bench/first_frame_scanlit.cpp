// Draws one picture of S2 and says so: started by bench_versus_llvmpipe, which looks at the clock.
#include <cstdio>

#include "bench_shapes.h"
#include "scanlit_side.h"

int main() {
  using namespace scanlit::bench;
  const BenchScene scene{.name = "S2",
                         .placements = {{.mesh = std::make_shared<scanlit::Mesh>(sphere(26, 40))}}};
  ScanlitSide renderer(2);
  renderer.prepare(scene);
  renderer.draw(scene, 0);
  std::puts(renderer.picture()[4 * (540 * picture_width + 960) + 3] ? "drawn" : "nothing drawn");
}
