#include "rasterizer/point_record.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/lighting.h"
#include "rasterizer/radiance.h"

namespace scanlit {

namespace {

using Floats = float[SurfaceSpan::padded];

float first_lane(const Batch& batch) {
  float lanes[Batch::lanes];
  batch.store(lanes);
  return lanes[0];
}
Vec3<float> first_lane(const Vec3<Batch>& v) {
  return {first_lane(v.x), first_lane(v.y), first_lane(v.z)};
}

Vec3<float> vec3_at(const float* const (&arrays)[3], int i) {
  return arrays[0] ? Vec3<float>{arrays[0][i], arrays[1][i], arrays[2][i]} : Vec3<float>{};
}
Vec3<float> vec3_at(const Floats (&arrays)[3], int i) {
  return {arrays[0][i], arrays[1][i], arrays[2][i]};
}
Rgb<float> rgb_at(const Floats (&arrays)[3], int i) {
  return {arrays[0][i], arrays[1][i], arrays[2][i]};
}

/// Room for a model's two parts at a span's points.
struct Parts {
  Floats values[6] = {};

  ReflectionSpan reflection() {
    return {.diffuse = {values[0], values[1], values[2]},
            .glossy = {values[3], values[4], values[5]}};
  }
  RadianceSpan radiance() {
    return {.diffuse = {values[0], values[1], values[2]},
            .glossy = {values[3], values[4], values[5]}};
  }
  Reflection<float> at(int i) const {
    return {.diffuse = {values[0][i], values[1][i], values[2][i]},
            .glossy = {values[3][i], values[4][i], values[5][i]}};
  }
};

/// L and V of a light at point i in the shading frame. Made unit again in double, as queries in
/// double want them.
void put_local(const PointRecord& point, LightRecord& light) {
  const auto in_double = [](const Vec3<float>& v) { return glm::dvec3(v.x, v.y, v.z); };
  const glm::dvec3 n = glm::normalize(in_double(point.normal));
  glm::dvec3 t = in_double(point.tangent);
  if (t == glm::dvec3(0)) t = std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  t = glm::normalize(t - n * glm::dot(n, t));
  const auto vec3 = [](const glm::dvec3& v) { return Vec3<double>{v.x, v.y, v.z}; };
  const auto frame =
      shading_frame(vec3(n), vec3(t), vec3(glm::normalize(in_double(light.to_light))),
                    vec3(glm::normalize(in_double(point.to_viewer))));
  light.to_light_local = frame.l, light.to_viewer_local = frame.v;
}

/// What one light does at point i of a span, by the operations of radiance.h.
LightRecord light_at(const ReflectionModel& model, const LightSource& light, const ViewedSpan& in,
                     int i) {
  const std::size_t at = std::size_t(i);
  const Vec3<Batch> n = load_vec3(in.normal, at), v = load_vec3(in.to_viewer, at);
  const ArrivingLight arrives = arriving(light, load_vec3(in.position, at), n);
  const HalfWay<Batch> half = half_way(arrives.to_light, v);
  const Cosines<Batch> c = cosines(n, arrives.to_light, v, half);
  LightRecord record{.to_light = first_lane(arrives.to_light),
                     .half_way = first_lane(half.h),
                     .n_l = first_lane(c.n_l),
                     .n_v = first_lane(c.n_v),
                     .n_h = first_lane(c.n_h.cos),
                     .v_h = first_lane(c.v_h),
                     .share = first_lane(arrives.share),
                     .diffuse_light = light.diffuse,
                     .glossy_light = light.glossy};

  Floats to_light[3];
  const Vec3<Batch> l = broadcast(record.to_light);
  for (std::size_t k = 0; k < in.size; k += Batch::lanes)
    l.x.store(to_light[0] + k), l.y.store(to_light[1] + k), l.z.store(to_light[2] + k);
  DirectionSpan directions{.size = in.size, .points = in.points, .parameters = in.parameters};
  for (int k = 0; k < 3; ++k) {
    directions.normal[k] = in.normal[k], directions.to_viewer[k] = in.to_viewer[k];
    directions.to_light[k] = to_light[k], directions.tangent[k] = in.tangent[k];
  }
  Parts braces, radiance;
  model.evaluate(directions, braces.reflection());
  model.radiance(in, {&light, 1}, radiance.radiance());
  record.braces = braces.at(i), record.radiance = radiance.at(i);
  return record;
}

}  // namespace

std::vector<PointRecord> light_points(const Frame& frame, const Draw& draw, SurfaceSpan& surface) {
  std::vector<PointRecord> points(std::size_t(surface.size));
  for (int i = 0; i < surface.size; ++i) {
    points[std::size_t(i)].object_position = vec3_at(surface.position, i);
    points[std::size_t(i)].object_normal = vec3_at(surface.normal, i);
  }
  LitSpan lit;
  FrameStats stats;
  lit.look = [&](const ViewedSpan& in) {
    const ReflectionModel& model = *draw.object->material.model;
    for (int i = 0; i < surface.size; ++i) {
      PointRecord& point = points[std::size_t(i)];
      point.position = vec3_at(in.position, i);
      point.normal = vec3_at(in.normal, i);
      point.to_viewer = vec3_at(in.to_viewer, i);
      point.tangent = vec3_at(in.tangent, i);
      for (std::size_t k = 0; k < model.needs().parameters; ++k)
        point.parameters.push_back(in.parameters[k][i]);
      for (const LightSource& light : draw.illumination.lights) {
        point.lights.push_back(light_at(model, light, in, i));
        put_local(point, point.lights.back());
      }
    }
  };
  light(frame, draw, surface, lit, stats);
  for (int i = 0; i < surface.size; ++i) {
    PointRecord& point = points[std::size_t(i)];
    point.ambient = rgb_at(lit.ambient, i), point.diffuse = rgb_at(lit.diffuse, i);
    point.glossy = rgb_at(lit.glossy, i), point.colour = rgb_at(lit.colour, i);
  }
  return points;
}

}  // namespace scanlit
