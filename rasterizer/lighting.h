// (9) Lighting: the reflection model, evaluated for a span of surface points under every light.
// Flat, Gouraud and Phong shading all come here; shading.cpp decides with which points.
#pragma once

#include "rasterizer/pipeline.h"

namespace scanlit {

/// Points of one object's surface. Arrays may be read and written up to `size` rounded up to a
/// whole vector.
struct SurfaceSpan {
  static constexpr int capacity = FragmentSpan::capacity;
  static constexpr int padded = FragmentSpan::padded;

  int size = 0;
  float position[3][padded] = {};  // object space
  float normal[3][padded] = {};    // in: object space, any length, on the viewer's side;
                                   // out: world space, unit
  float texcoord[2][padded] = {};
  float colour[3][padded] = {};  // the vertex colour, linear
};

/// What the lights make of them: linear radiance, without the ambient term. Not initialised:
/// clearing it would cost as much as a light.
struct LitSpan {
  float diffuse[3][SurfaceSpan::padded];
  float glossy[3][SurfaceSpan::padded];
};

/// Ka Ia in the material's colour form: the same for every point of an object.
Rgb<float> ambient_radiance(const Scene& scene, const Material& material);

void light(const Frame& frame, const Draw& draw, SurfaceSpan& surface, LitSpan& lit,
           FrameStats& stats);

/// Brings `normal` to world space as light() does, where a picture of the normals is all that is
/// wanted.
void place_normals(const Frame& frame, const Draw& draw, SurfaceSpan& surface);

}  // namespace scanlit
