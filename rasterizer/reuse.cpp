#include "rasterizer/reuse.h"

#include <algorithm>

namespace scanlit {

namespace {

/// Where the planes are: pixels that were drawn elsewhere do not stand here.
std::vector<const void*> planes_of(const Framebuffer& f) {
  return {f.colour.data(),    f.rgba8.data(),       f.depth.data(),   f.normal.data(),
          f.object_id.data(), f.triangle_id.data(), f.ambient.data(), f.diffuse.data(),
          f.glossy.data(),    f.cost.data()};
}

bool same_picture(const RenderSettings& a, const RenderSettings& b) {
  return a.samples == b.samples && a.interpolation == b.interpolation &&
         a.clamp_vertex_colours == b.clamp_vertex_colours && a.skips == b.skips;
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
      kept_->width != framebuffer.width || kept_->height != framebuffer.height ||
      kept_->planes != planes_of(framebuffer) || !same_meshes(kept_->scene, scene))
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
  kept_ = {scene, camera, settings, planes_of(framebuffer), framebuffer.width, framebuffer.height};
}

}  // namespace scanlit
