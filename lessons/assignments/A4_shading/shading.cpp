// A4, Gouraud and Phong shading. README.md says what each function is to do; `scanlit check .` says
// how far you are.
#include "shading.h"

#include <algorithm>

#include "variant.h"

namespace a4 {

Colour light(Vector normal, Vector to_viewer, const Scene& scene) {
  //<< TODO(A4.1) Ambient, diffuse and highlight, summed over the lights; N and V are unit vectors.
  //<< For now: the surface's colour, unlit.
  Colour sum = scene.ambient;
  for (const Light& each : scene.lights) {
    const double n_l = dot(normal, each.to_light);
    const double diffuse = std::max(0.0, (n_l + variant::wrap) / (1 + variant::wrap));
    const Vector mirrored = 2 * n_l * normal - each.to_light;
    const double cosine = variant::mirrored_light ? dot(mirrored, to_viewer)
                                                  : dot(normal, unit(each.to_light + to_viewer));
    const double highlight = n_l > 0 ? std::pow(std::max(0.0, cosine), scene.n) : 0;
    sum = sum + (diffuse * scene.kd + scene.ks * highlight * Vector{1, 1, 1}) * each.colour;
  }
  return sum;
  //== return scene.kd;
  //>>
}

Colour shade_vertex(const Vertex& vertex, const Scene& scene, const Stages& stages) {
  //<< TODO(A4.2) Gouraud shading: the colour of a vertex, by stages.light().
  const Colour c = stages.light(unit(vertex.normal), unit(scene.eye - vertex.position), scene);
  if (!variant::clamps_vertices) return c;
  return {std::clamp(c.x, 0.0, 1.0), std::clamp(c.y, 0.0, 1.0), std::clamp(c.z, 0.0, 1.0)};
  //== return 0.5 * scene.kd;
  //>>
}

Vector interpolate(const Vector (&corners)[3], const Weights& weights) {
  //<< TODO(A4.3) What lies between the corners. For now: the first corner's.
  const auto& w = weights.corner;
  return w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2];
  //== return corners[0];
  //>>
}

Vector interpolate_normal(const Vector (&normals)[3], const Weights& weights) {
  //<< TODO(A4.4) The unit normal between the corners. For now: the first corner's.
  Vector sum{0, 0, 0};
  for (int i = 0; i < 3; ++i)
    sum = sum + weights.corner[i] * (variant::unit_first ? unit(normals[i]) : normals[i]);
  return unit(sum);
  //== return normals[0];
  //>>
}

Colour shade_fragment(const Vertex (&triangle)[3], const Weights& weights, const Scene& scene,
                      const Stages& stages) {
  //<< TODO(A4.5) Phong shading: the colour of a fragment, by the functions in `stages`.
  //<< For now: how the triangle is turned.
  const Vector normals[3] = {triangle[0].normal, triangle[1].normal, triangle[2].normal};
  const Vector positions[3] = {triangle[0].position, triangle[1].position, triangle[2].position};
  const Vector normal = stages.interpolate_normal(normals, weights);
  const Vector position = stages.interpolate(positions, weights);
  return stages.light(normal, unit(scene.eye - position), scene);
  //== return 0.5 * (unit(triangle[0].normal) + Vector{1, 1, 1});
  //>>
}

}  // namespace a4
