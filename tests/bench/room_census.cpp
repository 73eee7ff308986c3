#include <set>

#include "bench_room.h"
#include "scanlit_side.h"

namespace scanlit::bench {

Census count_teapots(const BenchScene& scene) {
  Scene whole = scanlit_scene(scene), alone;
  const Camera camera = scanlit_camera(scene);
  whole.lights.clear();  // nobody looks at the colours
  Renderer renderer;
  Framebuffer picture(picture_width, picture_height, {.ids = true});
  renderer.render(whole, camera, {}, picture);
  const std::set<std::uint32_t> seen(picture.object_id.begin(), picture.object_id.end());

  Census census;
  for (std::size_t i = whole.objects.size() - teapot_count; i < whole.objects.size(); ++i) {
    alone.objects = {whole.objects[i]};
    if (seen.contains(std::uint32_t(i)))
      ++census.visible;
    else if (renderer.render(alone, camera, {}, picture).covered_pixels > 0)
      ++census.hidden;
    else
      ++census.outside;
  }
  return census;
}

}  // namespace scanlit::bench
