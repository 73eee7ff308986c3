// New idea: the reflection model can be evaluated once per face, at vertices, or at every pixel.
// Builds on: the lecture's I = Ka Ia + { Kd (N.L) + Ks (N.H)^n } Ii.
// Try: a finer teapot:16; a sharper n=300; which shading loses the highlight, and where?
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "lessons/studio/framing.h"
#include "lessons/studio/lesson.h"
#include "models/registry.h"
#include "rasterizer/render.h"
#include "rasterizer/shapes.h"

using namespace scanlit;

Scene three_teapots() {
  Material copper;
  copper.model = models::make("blinn-phong:kd=.50/.17/.07,ks=.5/.42/.35,n=80").model;
  copper.ka = {.07, .025, .01};

  Light key, fill;  // over the viewer's left shoulder, and a weak one from the right
  key.direction = {-.6, .7, .7};
  fill.direction = {.9, .1, .4};
  fill.intensity = .2;

  Scene scene;
  scene.lights = {key, fill};
  scene.background = {.03, .035, .045};

  // Coarse, so that it shows what is lost between the vertices.
  const auto teapot = std::make_shared<const Mesh>(make_shape("teapot:4"));
  float x = 0;
  for (Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
    Object object{teapot, glm::mat4(1), copper, shading, Sides::automatic, ""};
    object.world_from_object = glm::translate(glm::mat4(1), {x, 0, 0});
    object.world_from_object =
        glm::rotate(object.world_from_object, glm::radians(-20.f), glm::vec3(0, 1, 0));
    scene.objects.push_back(object);
    x += 2.1f;  // a teapot is 2 wide
  }
  return scene;
}

Framebuffer draw(int width, int height) {
  const Scene scene = three_teapots();
  const double aspect = double(width) / height;
  Camera camera;
  camera.eye = {0, 2, 5};
  camera.projection = Projection::orthographic;  // all three are seen from the same side
  camera = studio::fitted(camera, scene, aspect);

  RenderSettings settings;
  settings.samples = 16;
  Framebuffer framebuffer(width, height);
  render(scene, camera, settings, framebuffer);
  return framebuffer;
}

int main(int argc, char** argv) {
  return studio::run_lesson(
      argc, argv,
      {"Flat, Gouraud and Phong shading, side by side.", LESSON_PICTURE, 1800, 500, draw});
}
