#include "lessons/assignments/A4_shading/reference.h"

#include <algorithm>

#include "lessons/assignments/judge/dice.h"

namespace scanlit::assignments::shading {

ShadingVariant shading_variant(std::uint64_t seed) {
  Dice dice(seed, "A4");
  return {.wrap = 0.25 * dice.between(1, 3),
          .mirrored_light = dice.coin(),
          .clamps_vertices = dice.coin(),
          .unit_first = dice.coin()};
}

Colour right_light(const ShadingVariant& variant, Vector normal, Vector to_viewer,
                   const Scene& scene) {
  Colour sum = scene.ambient;
  for (const Light& light : scene.lights) {
    const double n_l = dot(normal, light.to_light);
    const double diffuse = std::max(0.0, (n_l + variant.wrap) / (1 + variant.wrap));
    double cosine;
    if (variant.mirrored_light)
      cosine = 2 * n_l * dot(normal, to_viewer) - dot(light.to_light, to_viewer);
    else
      cosine = dot(normal, unit(light.to_light + to_viewer));
    const double highlight = n_l <= 0 || cosine <= 0 ? 0 : scene.ks * std::pow(cosine, scene.n);
    sum = sum + light.colour * (diffuse * scene.kd + Vector{highlight, highlight, highlight});
  }
  return sum;
}

Colour right_vertex(const ShadingVariant& variant, const Vertex& vertex, const Scene& scene) {
  const Colour colour =
      right_light(variant, unit(vertex.normal), unit(scene.eye - vertex.position), scene);
  if (!variant.clamps_vertices) return colour;
  return {std::min(colour.x, 1.0), std::min(colour.y, 1.0), std::min(colour.z, 1.0)};
}

Vector right_between(const Vector (&corners)[3], const Weights& weights) {
  Vector sum{0, 0, 0};
  for (int i = 0; i < 3; ++i) sum = sum + weights.corner[i] * corners[i];
  return sum;
}

Vector right_normal(const ShadingVariant& variant, const Vector (&normals)[3],
                    const Weights& weights) {
  Vector sum{0, 0, 0};
  for (int i = 0; i < 3; ++i)
    sum = sum + weights.corner[i] * (variant.unit_first ? unit(normals[i]) : normals[i]);
  return unit(sum);
}

Colour right_fragment(const ShadingVariant& variant, const Vertex (&triangle)[3],
                      const Weights& weights, const Scene& scene) {
  const auto& [a, b, c] = triangle;
  const Vector position = right_between({a.position, b.position, c.position}, weights);
  const Vector normal = right_normal(variant, {a.normal, b.normal, c.normal}, weights);
  return right_light(variant, normal, unit(scene.eye - position), scene);
}

}  // namespace scanlit::assignments::shading
