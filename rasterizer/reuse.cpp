#include "rasterizer/reuse.h"

#include <algorithm>

namespace scanlit {

namespace {

bool same_picture(const RenderSettings& a, const RenderSettings& b) {
  return a.samples == b.samples && a.interpolation == b.interpolation &&
         a.clamp_vertex_colours == b.clamp_vertex_colours && a.skips == b.skips &&
         a.tolerance == b.tolerance;
}

bool same(const Object& a, const Object& b) {
  return a.world_from_object == b.world_from_object && a.material == b.material &&
         a.shading == b.shading && a.sides == b.sides;
}

bool same_meshes(const Scene& a, const Scene& b) {
  return std::ranges::equal(a.objects, b.objects, {}, &Object::mesh, &Object::mesh);
}

}  // namespace

Changes LastFrame::until(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                         const Framebuffer& framebuffer) const {
  Changes changes;
  if (!kept_ || !(kept_->camera == camera) || !same_picture(kept_->settings, settings) ||
      kept_->frame != framebuffer.frame || !same_meshes(kept_->scene, scene))
    return changes;
  changes.everything = false;
  changes.lighting = kept_->scene.lights != scene.lights || kept_->scene.ambient != scene.ambient ||
                     kept_->scene.background != scene.background;
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    changes.objects.push_back(!same(kept_->scene.objects[i], scene.objects[i]));
  return changes;
}

void LastFrame::keep(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                     const Framebuffer& framebuffer) {
  kept_ = {scene, camera, settings, framebuffer.frame};
}

}  // namespace scanlit
