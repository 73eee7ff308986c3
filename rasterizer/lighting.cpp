#include "rasterizer/lighting.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "rasterizer/batch_vec.h"
#include "rasterizer/cosines.h"
#include "rasterizer/placement.h"
#include "rasterizer/tangents.h"

namespace scanlit {

namespace {

constexpr int padded = SurfaceSpan::padded;
using Channels = float[3][padded];

LightSource light_source(const Light& light, const Material& material) {
  LightSource source{.far = light.kind == LightKind::directional,
                     .cone = light.kind == LightKind::spot,
                     .constant = float(light.constant),
                     .linear = float(light.linear),
                     .quadratic = float(light.quadratic)};
  const auto vec3 = [](const glm::dvec3& v) {
    return Vec3<float>{float(v.x), float(v.y), float(v.z)};
  };
  source.position = vec3(light.position);
  if (source.far) source.to_light = vec3(glm::normalize(light.direction));
  if (source.cone) {
    source.axis = vec3(-glm::normalize(light.direction));
    const float cos_inner = float(std::cos(glm::radians(light.inner_deg)));
    source.cos_outer = float(std::cos(glm::radians(light.outer_deg)));
    source.inverse_width = 1 / std::max(cos_inner - source.cos_outer, 1e-6f);
  }
  // Form 1: the light tints both parts. Form 2: the object colours the diffuse part, the light the
  // glossy one.
  const auto times_intensity = [&](const Rgb<double>& colour) {
    const auto bounded = [&](double c) { return float(std::min(light.intensity * c, 1e30)); };
    return Rgb<float>{bounded(colour.r), bounded(colour.g), bounded(colour.b)};
  };
  const bool plastic = material.form == ColourForm::plastic;
  source.diffuse = times_intensity(plastic ? material.object_colour : light.colour);
  source.glossy = times_intensity(light.colour);
  return source;
}

bool black(const LightSource& light) {
  const auto largest = [](const Rgb<float>& c) { return std::max({c.r, c.g, c.b}); };
  return !(std::max(largest(light.diffuse), largest(light.glossy)) > 0);
}

/// H of a far light and a far viewer, by the same operations as at a point: the same bits.
HalfWay<float> far_half_way(const Vec3<float>& to_light, const Vec3<float>& to_viewer) {
  const HalfWay<Batch> half = half_way(broadcast(to_light), broadcast(to_viewer));
  const auto one = [](const Batch& value) {
    float lanes[Batch::lanes];
    value.store(lanes);
    return lanes[0];
  };
  return {{one(half.h.x), one(half.h.y), one(half.h.z)}, one(half.v_h), one(half.s2)};
}

Vec3<float> far_viewer(const Viewer& viewer) {
  const auto& v = viewer.direction;
  return {v.x, v.y, v.z};
}

/// The surface as the model sees it, once place() has brought normals and tangents to world space.
PointSpan point_span(const Draw& draw, const SurfaceSpan& surface, const ViewedSpan& placed) {
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

/// What an ambient reflectance is multiplied by: Ia, or in form 2 its mean and the object's colour.
Rgb<double> ambient_light(const Scene& scene, const Material& material) {
  const Rgb<double>& a = scene.ambient;
  return material.form == ColourForm::tinted ? a : material.object_colour * ((a.r + a.g + a.b) / 3);
}

/// Material::ambient_share of the model, lit and seen head-on, on top of the ambient radiance.
void add_share(const Frame& frame, const Material& material, const ViewedSpan& in,
               const Rgb<float>& constant, Channels& ambient) {
  float head_on[6][padded];
  const ReflectionSpan out{.diffuse = {head_on[0], head_on[1], head_on[2]},
                           .glossy = {head_on[3], head_on[4], head_on[5]}};
  DirectionSpan directions{.size = in.size, .points = in.points, .parameters = in.parameters};
  for (int c = 0; c < 3; ++c) {
    directions.normal[c] = directions.to_light[c] = directions.to_viewer[c] = in.normal[c];
    directions.tangent[c] = in.tangent[c];
  }
  material.model->evaluate(directions, out);
  const Rgb<double> light = ambient_light(frame.scene, material) * material.ambient_share;
  const Batch lights[3] = {light.r, light.g, light.b};
  const float constants[3] = {constant.r, constant.g, constant.b};
  for (int c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < in.size; i += Batch::lanes)
      mul_add(lights[c], Batch::load(head_on[c] + i), constants[c]).store(ambient[c] + i);
}

void fill(const Rgb<float>& colour, Channels& channels) {
  std::ranges::fill(channels[0], colour.r);
  std::ranges::fill(channels[1], colour.g);
  std::ranges::fill(channels[2], colour.b);
}

void add_parts(int size, LitSpan& lit) {
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < size; i += Batch::lanes)
      (Batch::load(lit.ambient[c] + i) +
       (Batch::load(lit.diffuse[c] + i) + Batch::load(lit.glossy[c] + i)))
          .store(lit.colour[c] + i);
}

}  // namespace

Rgb<float> ambient_radiance(const Scene& scene, const Material& material) {
  const Rgb<double> radiance = material.ka * ambient_light(scene, material);
  return {float(radiance.r), float(radiance.g), float(radiance.b)};
}

Illumination illuminate(const Frame& frame, const Draw& draw) {
  const Skips& skips = frame.settings.skips;
  const Material& material = draw.object->material;
  const Needs needs = material.model->needs();
  Illumination all{.ambient = ambient_radiance(frame.scene, material)};
  for (const Light& light : frame.scene.lights) {
    LightSource source = light_source(light, material);
    if (skips.dark_lights && black(source)) continue;
    if (source.far && frame.viewer.far)
      source.half = far_half_way(source.to_light, far_viewer(frame.viewer));
    all.near_lights |= !source.far;
    all.lights.push_back(source);
  }
  if (!skips.unused_attributes) return all;
  all.constant = all.lights.empty() && material.ambient_share == 0;
  all.needs_position = all.near_lights || needs_points(needs) || needs.frame ||
                       (!frame.viewer.far && frame.settings.samples > 1);
  const Shading shading = draw.object->shading;
  all.needs_weights = !frame.colour_alone || shading == Shading::gouraud || all.needs_position ||
                      (shading == Shading::phong && !draw.clusters->flat);
  return all;
}

void light(const Frame& frame, const Draw& draw, SurfaceSpan& surface, LitSpan& lit,
           FrameStats& stats) {
  const Illumination& illumination = draw.illumination;
  const Material& material = draw.object->material;
  const std::int64_t asked = std::int64_t(frame.scene.lights.size()) * surface.size;
  stats.evaluations += asked;
  stats.evaluations_skipped += asked;
  if (lit.with_evaluations) std::ranges::fill(lit.evaluations, 0.0f);
  if (illumination.constant) {
    fill(illumination.ambient, lit.colour);
    if (!lit.with_parts) return;
    fill(illumination.ambient, lit.ambient);
    for (auto* part : {&lit.diffuse, &lit.glossy}) fill({0, 0, 0}, *part);
    return;
  }

  const Needs needs = material.model->needs();
  Places places;
  place(frame, draw, surface, places);
  if (needs.frame) place_tangents(draw, surface);
  const bool each = !frame.viewer.far || !frame.settings.skips.far_directions;
  ViewedSpan in{.size = std::size_t(surface.size),
                .far_viewer = far_viewer(frame.viewer),
                .skip_dark = frame.settings.skips.dark_lights};
  for (int c = 0; c < 3; ++c) {
    in.normal[c] = surface.normal[c];
    in.position[c] = places_positions(frame, draw) ? places.position[c] : nullptr;
    in.to_viewer[c] = each ? places.to_viewer[c] : nullptr;
    in.tangent[c] = needs.frame ? surface.tangent[c] : nullptr;
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

  if (lit.look) lit.look(in);
  const bool share = material.ambient_share != 0, parts = lit.with_parts || share;
  RadianceSpan out{.ambient = illumination.ambient,
                   .evaluations = lit.with_evaluations ? lit.evaluations : nullptr};
  for (int c = 0; c < 3; ++c) {
    out.diffuse[c] = parts ? lit.diffuse[c] : nullptr;
    out.glossy[c] = parts ? lit.glossy[c] : nullptr;
    out.colour[c] = share ? nullptr : lit.colour[c];
  }
  const auto evaluations = material.model->radiance(in, illumination.lights, out);
  stats.evaluations_skipped -= std::int64_t(evaluations);
  stats.spans += std::int64_t(illumination.lights.size());
  if (share) {
    add_share(frame, material, in, illumination.ambient, lit.ambient);
    add_parts(surface.size, lit);
  } else if (lit.with_parts) {
    fill(illumination.ambient, lit.ambient);
  }
}

}  // namespace scanlit
