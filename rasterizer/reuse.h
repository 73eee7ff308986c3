// What a frame may take over from the one before it, where RenderSettings::reuse asks for it: the
// triangles of objects that did not change, the visibility of tiles that none of the changed
// objects touches, and their colours if the light is the same.
#pragma once

#include <optional>
#include <vector>

#include "rasterizer/render.h"

namespace scanlit {

/// Between two frames.
struct Changes {
  bool everything = true;
  bool lighting = true;               // lights, or what stands behind the objects
  std::vector<std::uint8_t> objects;  // by index in Scene::objects: 1 if it changed

  bool object(std::size_t index) const { return everything || objects[index] != 0; }
};

class LastFrame {
 public:
  /// Everything, if the camera, the settings or the list of meshes are others, or if the
  /// framebuffer does not hold the last frame.
  Changes until(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                const Framebuffer& framebuffer) const;

  void keep(const Scene& scene, const Camera& camera, const RenderSettings& settings,
            const Framebuffer& framebuffer);
  void forget() { kept_.reset(); }

 private:
  struct Kept {
    Scene scene;  // with its meshes and models: their addresses are not used again
    Camera camera;
    RenderSettings settings;
    std::uint64_t frame;  // that the framebuffer holds
  };
  std::optional<Kept> kept_;
};

/// What must be done again in a tile.
enum class Redo : std::uint8_t { nothing, shading, all };

}  // namespace scanlit
