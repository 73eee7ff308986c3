// Scenes of everything that can be in one, for properties of whole pictures.
#pragma once

#include "rasterizer/render.h"
#include "tests/stress/property.h"

namespace scanlit::stress {

struct RandomScene {
  Scene scene;
  Camera camera;
  RenderSettings settings;
  int width, height;
  Planes planes;  // colour, depth and ids; sometimes normals and parts
};

/// One to five objects, whole and cut, of models and inputs of every kind, under up to four lights.
RandomScene random_scene(Property& property);

Framebuffer draw(const RandomScene& all);

}  // namespace scanlit::stress
