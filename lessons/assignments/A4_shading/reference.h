// A4 as it should be, for any variant.
#pragma once

#include <cstdint>

#include "lessons/assignments/A4_shading/shading.h"

namespace scanlit::assignments::shading {

// Not the engine's.
using a4::Colour, a4::Light, a4::Scene, a4::Vector, a4::Vertex, a4::Weights;

struct ShadingVariant {
  double wrap;  // never 0, which would be the engine's own diffuse term
  bool mirrored_light, clamps_vertices, unit_first;
};
ShadingVariant shading_variant(std::uint64_t seed);

Colour right_light(const ShadingVariant& variant, Vector normal, Vector to_viewer,
                   const Scene& scene);
Colour right_vertex(const ShadingVariant& variant, const Vertex& vertex, const Scene& scene);
Vector right_between(const Vector (&corners)[3], const Weights& weights);
Vector right_normal(const ShadingVariant& variant, const Vector (&normals)[3],
                    const Weights& weights);
Colour right_fragment(const ShadingVariant& variant, const Vertex (&triangle)[3],
                      const Weights& weights, const Scene& scene);

}  // namespace scanlit::assignments::shading
