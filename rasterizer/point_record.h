// A point at which the reflection model was evaluated, as the engine lit it: part of a PixelRecord.
#pragma once

#include "rasterizer/surface.h"

namespace scanlit {

/// What a light does at a point, world space.
struct LightRecord {
  Vec3<float> to_light{}, half_way{};                // L and H, unit
  float n_l = 0, n_v = 0, n_h = 0, v_h = 0;          // as the formula gets them
  Vec3<double> to_light_local{}, to_viewer_local{};  // in the shading frame, for queries in double
  float share = 0;                                   // that arrives: fall-off times cone
  Rgb<float> diffuse_light{}, glossy_light{};        // intensity and colour, in the colour form
  Reflection<float> braces{};                        // the model's value; 0 below the horizon
  Reflection<float> radiance{};                      // what the light adds to the pixel's fragment
};

/// A point at which the reflection model was evaluated.
struct PointRecord {
  std::uint32_t element = 0;  // Gouraud: the mesh's vertex; flat and Phong: its triangle
  Vec3<float> object_position{}, object_normal{};  // before it is normalised; on the viewer's side
  Vec3<float> position{}, normal{}, to_viewer{};   // P, N, V: world space
  Vec3<float> tangent{};                           // world space; 0 where the model needs none
  std::vector<float> parameters{};                 // those that vary, as evaluate_parameters() says
  std::vector<LightRecord> lights{};               // as in Scene::lights
  Rgb<float> ambient{}, diffuse{}, glossy{};
  Rgb<float> colour{};  // ambient + (diffuse + glossy), to the bit
};

/// Lights a span as lighting.h does, and records its points; all but `element`. Asks for a frame
/// whose far_directions, unused_attributes and dark_lights are not skipped.
std::vector<PointRecord> light_points(const Frame& frame, const Draw& draw, SurfaceSpan& surface);

}  // namespace scanlit
