#include "lessons/studio/drawing/stage.h"

#include "models/registry.h"
#include "rasterizer/shapes.h"

namespace scanlit::studio {

Object make_object(const std::string& shape, const std::string& model, Shading shading) {
  return make_object(shape, models::make(model).model, shading);
}

Object make_object(const std::string& shape, std::shared_ptr<const ReflectionModel> model,
                   Shading shading) {
  Object object;
  object.mesh =
      std::make_shared<const Mesh>(is_shape(shape) ? make_shape(shape) : load_mesh(shape));
  object.material.model = std::move(model);
  object.material.ka = Rgb<double>(0);
  object.material.ambient_share = 0.1;
  object.shading = shading;
  return object;
}

Light far_light(const glm::dvec3& towards_light, double intensity) {
  Light light;
  light.direction = towards_light;
  light.intensity = intensity;
  return light;
}

Scene make_stage(const std::vector<Object>& objects) {
  Scene scene;
  scene.objects = objects;
  scene.lights = {far_light({-.6, .7, .7}, 1), far_light({.9, .1, .4}, .2)};
  scene.background = ink::slate;
  return scene;
}

Framebuffer photograph(const Scene& scene, const Camera& camera, int width, int height,
                       FrameStats* stats) {
  RenderSettings settings;
  settings.samples = 16;
  Framebuffer picture(width, height);
  const FrameStats counted = render(scene, camera, settings, picture);
  if (stats) *stats = counted;
  return picture;
}

Framebuffer photograph(const Scene& scene, const glm::dvec3& eye, int width, int height,
                       FrameStats* stats) {
  Camera camera;
  camera.eye = eye;
  camera.fov_deg = 20;
  return photograph(scene, fitted(camera, scene, double(width) / height), width, height, stats);
}

}  // namespace scanlit::studio
