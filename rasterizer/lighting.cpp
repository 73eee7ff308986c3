#include "rasterizer/lighting.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "rasterizer/scalar_math.h"
#include "rasterizer/span_math.h"
#include "rasterizer/tangents.h"

namespace scanlit {

namespace {

constexpr int padded = SurfaceSpan::padded;

/// v / |v|, or `otherwise` where v has no direction: a normal interpolated to zero, a light or an
/// eye that lies on the surface. Without the bound those would be 0/0.
Vec3<Batch> normalize_or(const Vec3<Batch>& v, const Vec3<Batch>& otherwise) {
  const Batch length2 = dot(v, v), tiny(1e-30f);
  const auto has_direction = length2 > tiny;
  const Vec3<Batch> unit = v * (Batch(1) / sqrt(max(length2, tiny)));
  return select(has_direction, unit, otherwise);
}

/// What the model's span is made of, in world space.
struct Directions {
  float position[3][padded];
  float to_viewer[3][padded];
  float to_light[3][padded];
  float irradiance[padded];  // Ii times fall-off and spot cone, colour apart
};

/// Object space to world space, and the directions that do not depend on a light. A normal of no
/// length is taken to face the viewer.
void place(const Frame& frame, const Draw& draw, SurfaceSpan& surface, Directions& d) {
  const Camera& camera = frame.camera;
  const bool far_viewer =
      camera.viewer_at_infinity || camera.projection == Projection::orthographic;
  const Vec3<Batch> eye = broadcast(camera.eye), far_direction = broadcast(towards_viewer(camera));
  const glm::mat4& m = draw.object->world_from_object;
  const glm::mat3 linear(m);
  const Vec3<Batch> origin = broadcast(m[3]);

  for (int i = 0; i < surface.size; i += Batch::lanes) {
    const Vec3<Batch> position = transform(linear, load(surface.position, i)) + origin;
    const Vec3<Batch> to_viewer =
        far_viewer ? far_direction : normalize_or(eye - position, far_direction);
    const Vec3<Batch> normal =
        normalize_or(transform(draw.normal_from_object, load(surface.normal, i)), to_viewer);
    store(position, d.position, i);
    store(to_viewer, d.to_viewer, i);
    store(normal, surface.normal, i);
  }
}

void directional(const Light& light, const SurfaceSpan& surface, Directions& d) {
  const Vec3<Batch> to_light = broadcast(glm::normalize(light.direction));
  for (int i = 0; i < surface.size; i += Batch::lanes) {
    store(to_light, d.to_light, i);
    Batch(light.intensity).store(d.irradiance + i);
  }
}

/// Point light, with its fall-off; spot light, with its cone besides.
void positional(const Light& light, const SurfaceSpan& surface, Directions& d) {
  const bool spot = light.kind == LightKind::spot;
  const Vec3<Batch> position = broadcast(light.position);
  const Vec3<Batch> axis = spot ? broadcast(-glm::normalize(light.direction)) : Vec3<Batch>{};
  const float cos_outer = float(std::cos(glm::radians(light.outer_deg)));
  const float cos_inner = float(std::cos(glm::radians(light.inner_deg)));
  for (int i = 0; i < surface.size; i += Batch::lanes) {
    const Vec3<Batch> offset = position - load(d.position, i);
    const Vec3<Batch> to_light = normalize_or(offset, load(surface.normal, i));
    const Batch distance2 = dot(offset, offset), distance = sqrt(distance2);
    // At the light itself an inverse-square light would be infinite; from 1e-4 units on it stays
    // as it is there.
    const Batch fall_off = max(
        Batch(light.constant) + Batch(light.linear) * distance + Batch(light.quadratic) * distance2,
        Batch(1e-8f));
    Batch irradiance = Batch(light.intensity) / fall_off;
    if (spot) {
      // Smoothstep between the two angles' cosines.
      const Batch share = (dot(axis, to_light) - Batch(cos_outer)) *
                          Batch(1 / std::max(cos_inner - cos_outer, 1e-6f));
      const Batch t = min(max(share, Batch(0)), Batch(1));
      irradiance = irradiance * (t * t * (Batch(3) - Batch(2) * t));
    }
    store(to_light, d.to_light, i);
    irradiance.store(d.irradiance + i);
  }
}

/// The surface as the model sees it, once place() has brought normals and tangents to world space.
PointSpan point_span(const Draw& draw, const SurfaceSpan& surface, const DirectionSpan& placed) {
  PointSpan points{.size = placed.size};
  for (int c = 0; c < 3; ++c) {
    points.object_position[c] = surface.position[c];
    points.vertex_colour[c] = surface.colour[c];
    points.normal[c] = placed.normal[c];
    points.tangent[c] = placed.tangent[c];
    for (int row = 0; row < 3; ++row)
      points.world_from_object[c][row] = draw.object->world_from_object[c][row];
  }
  for (int c = 0; c < 2; ++c) {
    points.texcoord[c] = surface.texcoord[c];
    points.texcoord_dx[c] = surface.with_derivatives ? surface.texcoord_dx[c] : nullptr;
    points.texcoord_dy[c] = surface.with_derivatives ? surface.texcoord_dy[c] : nullptr;
  }
  return points;
}

void accumulate(const SurfaceSpan& surface, const Directions& d, const LitSpan& reflection,
                const Rgb<double>& diffuse_tint, const Rgb<double>& glossy_tint, LitSpan& lit) {
  const double tints[2][3] = {{diffuse_tint.r, diffuse_tint.g, diffuse_tint.b},
                              {glossy_tint.r, glossy_tint.g, glossy_tint.b}};
  for (int channel = 0; channel < 3; ++channel) {
    const Batch diffuse(tints[0][channel]), glossy(tints[1][channel]);
    for (int i = 0; i < surface.size; i += Batch::lanes) {
      const Batch irradiance = Batch::load(d.irradiance + i);
      const auto add = [&](const float* part, const Batch& tint, float* sum) {
        mul_add(irradiance * tint, Batch::load(part + i), Batch::load(sum + i)).store(sum + i);
      };
      add(reflection.diffuse[channel], diffuse, lit.diffuse[channel]);
      add(reflection.glossy[channel], glossy, lit.glossy[channel]);
    }
  }
}

/// What an ambient reflectance is multiplied by: Ia, or in form 2 its mean and the object's colour.
Rgb<double> ambient_light(const Scene& scene, const Material& material) {
  const Rgb<double>& a = scene.ambient;
  return material.form == ColourForm::tinted ? a : material.object_colour * ((a.r + a.g + a.b) / 3);
}

/// The ambient term of every point.
void ambient(const Scene& scene, const Material& material, DirectionSpan in,
             const ReflectionSpan& head_on, LitSpan& lit) {
  const Rgb<float> constant = ambient_radiance(scene, material);
  const float constants[3] = {constant.r, constant.g, constant.b};
  for (int c = 0; c < 3; ++c) std::ranges::fill(lit.ambient[c], constants[c]);
  if (material.ambient_share == 0) return;

  for (int c = 0; c < 3; ++c) in.to_light[c] = in.to_viewer[c] = in.normal[c];
  material.model->evaluate(in, head_on);
  const Rgb<double> light = ambient_light(scene, material) * material.ambient_share;
  const Batch lights[3] = {light.r, light.g, light.b};
  for (int c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < in.size; i += Batch::lanes)
      mul_add(lights[c], Batch::load(head_on.diffuse[c] + i), constants[c])
          .store(lit.ambient[c] + i);
}

}  // namespace

Rgb<float> ambient_radiance(const Scene& scene, const Material& material) {
  const Rgb<double> radiance = material.ka * ambient_light(scene, material);
  return {float(radiance.r), float(radiance.g), float(radiance.b)};
}

void light(const Frame& frame, const Draw& draw, SurfaceSpan& surface, LitSpan& lit,
           FrameStats& stats) {
  const Material& material = draw.object->material;
  const Needs needs = material.model->needs();
  Directions d;
  place(frame, draw, surface, d);
  if (needs.frame) place_tangents(draw, surface);

  LitSpan reflection;
  DirectionSpan in{.size = std::size_t(surface.size)};
  const ReflectionSpan out{
      .diffuse = {reflection.diffuse[0], reflection.diffuse[1], reflection.diffuse[2]},
      .glossy = {reflection.glossy[0], reflection.glossy[1], reflection.glossy[2]}};
  for (int c = 0; c < 3; ++c) {
    in.normal[c] = surface.normal[c];
    in.to_light[c] = d.to_light[c];
    in.to_viewer[c] = d.to_viewer[c];
    in.tangent[c] = needs.frame ? surface.tangent[c] : nullptr;
    std::ranges::fill(lit.diffuse[c], 0.0f);
    std::ranges::fill(lit.glossy[c], 0.0f);
  }

  // What varies over the surface is the same under every light.
  const PointSpan points = point_span(draw, surface, in);
  if (needs.surface_point) in.points = &points;
  std::vector<float*> parameters;
  if (needs.parameters > 0) {
    surface.parameters.resize(std::max(surface.parameters.size(), needs.parameters));
    for (std::size_t k = 0; k < needs.parameters; ++k)
      parameters.push_back(surface.parameters[k].data());
    material.model->evaluate_parameters(points, parameters.data());
    in.parameters = parameters.data();
  }
  ambient(frame.scene, material, in, out, lit);

  for (const Light& source : frame.scene.lights) {
    if (source.kind == LightKind::directional)
      directional(source, surface, d);
    else
      positional(source, surface, d);
    material.model->evaluate(in, out);
    // Form 1: the light tints both parts. Form 2: the object colours the diffuse part, the light
    // the glossy one.
    const bool plastic = material.form == ColourForm::plastic;
    accumulate(surface, d, reflection, plastic ? material.object_colour : source.colour,
               source.colour, lit);
    stats.evaluations += surface.size;
    ++stats.spans;
  }
}

void place_normals(const Frame& frame, const Draw& draw, SurfaceSpan& surface) {
  Directions unused;
  place(frame, draw, surface, unused);
}

}  // namespace scanlit
