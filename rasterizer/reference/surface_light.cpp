#include "rasterizer/reference/surface_light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace scanlit {

namespace {

using glm::dmat3;
using glm::dvec2;
using glm::dvec3;

dvec3 unit_or(const dvec3& v, const dvec3& otherwise) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0 ? glm::normalize(v / largest) : otherwise;
}

/// What of a light arrives at a point.
struct Arriving {
  dvec3 to_light;  // unit
  double share;    // of the light's intensity
};

Arriving arriving(const Light& light, const dvec3& position, const dvec3& normal) {
  if (light.kind == LightKind::directional) return {glm::normalize(light.direction), 1};
  const dvec3 offset = light.position - position;
  const double d = glm::length(offset);
  const dvec3 to_light = unit_or(offset, normal);
  const double fall_off = light.constant + light.linear * d + light.quadratic * d * d;
  double share = 1 / std::clamp(fall_off, 1e-8, 1e30);  // as radiance.h has it, and says why
  if (light.kind == LightKind::spot) {
    const double cos_inner = std::cos(glm::radians(light.inner_deg));
    const double cos_outer = std::cos(glm::radians(light.outer_deg));
    const double cosine = glm::dot(-glm::normalize(light.direction), to_light);
    const double t = std::clamp((cosine - cos_outer) / (cos_inner - cos_outer), 0.0, 1.0);
    share *= t * t * (3 - 2 * t);
  }
  return {to_light, share};
}

// ---------------------------------------------------------------------------------------- tangents

/// The direction projected into the surface, unit; `otherwise` where it is within 1e-4 rad of the
/// normal (tangents.cpp says why).
dvec3 in_surface(const dvec3& direction, const dvec3& normal, const dvec3& otherwise) {
  const dvec3 d = unit_or(direction, dvec3(0));
  const dvec3 across = d - normal * glm::dot(normal, d);
  return glm::dot(across, across) > 1e-8 ? glm::normalize(across) : otherwise;
}

/// Which way the surface is brushed, in world space; the rules are those of tangents.h.
dvec3 tangent_at(const Object& object, const ObjectPoint& point, const dvec3& normal) {
  const Tangents& tangents = object.material.tangents;
  const dvec3 axis = glm::normalize(dvec3(tangents.axis));
  dvec3 direction = glm::cross(axis, point.position - dvec3(tangents.centre));
  if (tangents.field == TangentField::along) direction = axis;
  if (tangents.field == TangentField::texcoord && point.has_tangent) direction = point.tangent;

  const dmat3 linear(object.world_from_object);
  const dvec3 x(1, 0, 0), z(0, 0, 1);
  const dvec3 side = glm::normalize(glm::cross(axis, std::abs(axis.z) < 0.9 ? z : x));
  const dvec3 first = unit_or(linear * side, x);
  const dvec3 second = unit_or(linear * glm::cross(side, axis), z);
  const dvec3 flat = std::abs(glm::dot(normal, first)) < 0.9f ? first : second;
  const dvec3 any = glm::normalize(glm::cross(normal, std::abs(normal.z) < 0.9 ? z : x));
  return in_surface(linear * direction, normal, in_surface(flat, normal, any));
}

// ------------------------------------------------------------------------------------------- model

/// A span of the one point, for parameters that vary.
class OnePoint {
 public:
  OnePoint(const Object& object, const ObjectPoint& at, const dvec3& normal, const dvec3& tangent) {
    span_.size = 1;
    for (int c = 0; c < 3; ++c) {
      span_.object_position[c] = put(at.position[c]);
      span_.vertex_colour[c] = put(at.colour[c]);
      span_.normal[c] = put(normal[c]);
      span_.tangent[c] = put(tangent[c]);
      for (int row = 0; row < 3; ++row)
        span_.world_from_object[c][row] = object.world_from_object[c][row];
    }
    for (int c = 0; c < 2; ++c) {
      span_.texcoord[c] = put(at.texcoord[c]);
      if (!at.is_pixel) continue;
      span_.texcoord_dx[c] = put(at.texcoord_dx[c]);
      span_.texcoord_dy[c] = put(at.texcoord_dy[c]);
    }
  }
  const PointSpan& span() const { return span_; }

 private:
  /// An array of its own, that whole vectors may be read of.
  const float* put(double value) {
    float* const array = values_[used_++];
    std::fill_n(array, max_lanes, float(value));
    return array;
  }

  float values_[18][max_lanes];
  int used_ = 0;
  PointSpan span_;
};

Rgb<double> ambient_light(const Scene& scene, const Material& material) {
  const Rgb<double>& a = scene.ambient;
  return material.form == ColourForm::tinted ? a : material.object_colour * ((a.r + a.g + a.b) / 3);
}

}  // namespace

dvec3 pixel_to_eye(const Camera& camera, int width, int height, double x, double y) {
  const dvec3 back = towards_viewer(camera), right = glm::normalize(glm::cross(camera.up, back));
  const dvec3 below = glm::cross(right, back);
  const double pixel = 2 * std::tan(glm::radians(camera.fov_deg) / 2) / height;  // at distance 1
  return back - right * ((x + 0.5 - width / 2.0) * pixel) -
         below * ((y + 0.5 - height / 2.0) * pixel);
}

dvec3 world_normal(const Object& object, const ObjectPoint& point, const dvec3& otherwise) {
  const dmat3 m(object.world_from_object);
  const dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return unit_or(cofactors * point.normal * (glm::determinant(m) < 0 ? -1.0 : 1.0), otherwise);
}

Rgb<double> radiance_in_double(const Scene& scene, const Camera& camera, const Object& object,
                               const ObjectPoint& at) {
  const Material& material = object.material;
  const dvec3 position = dvec3(glm::dmat4(object.world_from_object) * glm::dvec4(at.position, 1));
  const bool far_viewer =
      camera.viewer_at_infinity || camera.projection == Projection::orthographic;
  const dvec3 far_direction = towards_viewer(camera);
  const dvec3 v = far_viewer     ? far_direction
                  : at.to_viewer ? *at.to_viewer
                                 : unit_or(camera.eye - position, far_direction);
  const dvec3 n = world_normal(object, at, v);
  const dvec3 t = tangent_at(object, at, n), b = glm::cross(n, t);
  const auto in_frame = [&](const dvec3& d) {
    return Vec3<double>{glm::dot(t, d), glm::dot(b, d), glm::dot(n, d)};
  };
  const OnePoint drawn(object, at, n, t);
  const SurfacePoint<double> point{{at.position.x, at.position.y, at.position.z},
                                   at.texcoord.x,
                                   at.texcoord.y,
                                   {at.colour.x, at.colour.y, at.colour.z},
                                   &drawn.span()};

  const Rgb<double> head_on = material.model->evaluate(in_frame(n), in_frame(n), point).diffuse;
  Rgb<double> sum =
      (material.ka + head_on * material.ambient_share) * ambient_light(scene, material);
  for (const Light& light : scene.lights) {
    const auto [to_light, share] = arriving(light, position, n);
    if (!(glm::dot(n, to_light) > 0)) continue;
    const auto [diffuse, glossy] = material.model->evaluate(in_frame(to_light), in_frame(v), point);
    const bool plastic = material.form == ColourForm::plastic;
    const Rgb<double>& diffuse_tint = plastic ? material.object_colour : light.colour;
    const double intensity = light.intensity * share;
    sum = sum + (diffuse * diffuse_tint + glossy * light.colour) * intensity;
  }
  return sum;
}

}  // namespace scanlit
