// New idea: the reflection model can be evaluated once per face, at vertices, or at every pixel.
// Builds on: the lecture's I = Ka Ia + { Kd (N.L) + Ks (N.H)^n } Ii.
// Try: a finer teapot:16; a sharper n=300; which shading loses the highlight, and where?
#include "lessons/studio/lesson.h"
#include "models/registry.h"
#include "rasterizer/render.h"
#include "rasterizer/shapes.h"

using namespace scanlit;

Scene three_teapots() {
  Material copper;
  copper.model = models::make("blinn-phong:kd=.50/.17/.07,ks=.5/.40/.32,n=40").model;
  copper.ka = {.09, .03, .015};

  Light key, fill;  // over the viewer's left shoulder, and a weak one from the right
  key.direction = {-.6, .8, .7};
  fill.direction = {.9, .1, .4};
  fill.intensity = .2;

  Scene scene;
  scene.lights = {key, fill};
  scene.background = {.05, .06, .08};

  // Coarse, so that it shows what is lost between the vertices.
  const auto teapot = std::make_shared<const Mesh>(make_shape("teapot:4"));
  float x = -2.3f;
  for (Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
    Object object{teapot, glm::mat4(1), copper, shading, Sides::automatic, ""};
    object.world_from_object[3].x = x;  // the last column of the matrix translates
    scene.objects.push_back(object);
    x += 2.3f;
  }
  return scene;
}

Framebuffer draw(int width, int height) {
  Camera camera;
  camera.projection = Projection::orthographic;  // all three are seen from the same side
  camera.eye = {0, 4, 10};
  camera.far = 20;
  camera.height = 2.2;

  RenderSettings settings;
  settings.samples = 8;
  Framebuffer framebuffer(width, height);
  render(three_teapots(), camera, settings, framebuffer);
  return framebuffer;
}

int main(int argc, char** argv) {
  return studio::run_lesson(
      argc, argv,
      {"Flat, Gouraud and Phong shading, side by side.", LESSON_PICTURE, 1800, 600, draw});
}
