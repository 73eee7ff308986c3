// (9) Lighting: the reflection model, evaluated for a span of surface points under every light.
// Flat, Gouraud and Phong shading all come here; shading.cpp decides with which points.
#pragma once

#include <functional>

#include "rasterizer/surface.h"

namespace scanlit {

/// What the lights make of them: linear radiance, and its parts only where they are asked for. Not
/// initialised: clearing it would cost as much as a light.
struct LitSpan {
  bool with_parts = true;
  bool with_evaluations = false;
  alignas(cache_line) float colour[3][SurfaceSpan::padded];
  float ambient[3][SurfaceSpan::padded];
  float diffuse[3][SurfaceSpan::padded];
  float glossy[3][SurfaceSpan::padded];
  float evaluations[SurfaceSpan::padded];  // of the reflection model: lights that reach the point
  std::function<void(const ViewedSpan&)> look{};  // if any, is shown what the model sees
};

/// What is the same at all points of an object.
Illumination illuminate(const Frame& frame, const Draw& draw);

/// Ka Ia in the material's colour form: the ambient term, where no share of the model is added.
Rgb<float> ambient_radiance(const Scene& scene, const Material& material);

void light(const Frame& frame, const Draw& draw, SurfaceSpan& surface, LitSpan& lit,
           FrameStats& stats);

}  // namespace scanlit
