// What the cases are made of: small scenes of built-in shapes, lit and framed in one way.
#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <memory>

#include "models/registry.h"
#include "rasterizer/render.h"
#include "rasterizer/shapes.h"
#include "tests/golden/golden.h"

namespace scanlit::golden {

inline constexpr int width = 160, height = 120;

// A reference is exact to 1 part in 65,536 (its floats are shortened), and shading rounds
// differently with the vector width: up to 2e-5 of a highlight's peak. The eye sees 4e-3.
inline const Tolerance rounding{1e-4f, 1e-4f, 0,
                                "shading rounds differently on each instruction set"};

inline Object object(const char* shape, const char* model, Shading shading = Shading::phong) {
  Object result;
  result.mesh = std::make_shared<Mesh>(make_shape(shape));
  result.material.model = models::make(model).model;
  result.shading = shading;
  result.name = shape;
  return result;
}

inline Object placed(Object result, const glm::vec3& position, float scale) {
  result.world_from_object = glm::scale(glm::translate(glm::mat4(1), position), glm::vec3(scale));
  return result;
}

inline Light directional(const glm::dvec3& towards_light, double intensity = 0.8) {
  Light light;
  light.direction = towards_light;
  light.intensity = intensity;
  return light;
}

// Lit from above, on the viewer's left, with a weaker warm light from the right.
inline Scene scene(std::vector<Object> objects) {
  Scene result;
  result.objects = std::move(objects);
  result.ambient = Rgb<double>(0.5);
  result.lights = {directional({-1, 1.5, 2}), directional({2, 0.2, 1}, 0.3)};
  result.lights[1].colour = {1, 0.7, 0.4};
  return result;
}

struct Shot {
  Camera camera{.eye = {1.2, 1.4, 3}};
  double framing = 1;  // times the size at which the scene just fits; 0: the camera as it is
  RenderSettings settings;
  Planes planes;
};

inline Framebuffer draw(const Scene& scene, const Shot& shot = {}) {
  Framebuffer framebuffer(width, height, shot.planes);
  Camera camera = shot.camera;
  if (shot.framing > 0) {
    camera = framed(camera, bounding_sphere(scene), double(width) / height);
    camera.fov_deg /= shot.framing;
    camera.height /= shot.framing;
  }
  render(scene, camera, shot.settings, framebuffer);
  return framebuffer;
}

/// One picture of each reflection model.
std::vector<Case> model_cases();

}  // namespace scanlit::golden
