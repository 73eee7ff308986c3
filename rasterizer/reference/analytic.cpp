#include "rasterizer/reference/analytic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "rasterizer/error.h"
#include "rasterizer/mesh/teapot.h"

namespace scanlit {

namespace {

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

constexpr int most_steps = 50;     // Newton's method comes to rest in 4 to 8
constexpr double at_rest = 1e-13;  // units: some roundings of a shape of size 1
constexpr double farthest = 0.1;   // units from the mesh: beyond, it is another part of the shape

class UnitSphere final : public AnalyticSurface {
 public:
  std::optional<ObjectPoint> meet(const Ray& ray, double t) const override {
    const dvec3 d = glm::normalize(ray.direction);
    const double middle = -glm::dot(ray.origin, d);  // the ray's point nearest to the centre
    const dvec3 nearest = ray.origin + middle * d;
    const double half_chord2 = 1 - glm::dot(nearest, nearest);
    if (half_chord2 < 0) return {};
    const double guess = t * glm::length(ray.direction), half_chord = std::sqrt(half_chord2);
    const dvec3 p = nearest + (guess < middle ? -half_chord : half_chord) * d;
    return ObjectPoint{.position = p, .normal = glm::normalize(p)};
  }
};

class Torus final : public AnalyticSurface {
 public:
  std::optional<ObjectPoint> meet(const Ray& ray, double guess) const override {
    const double speed = glm::length(ray.direction);
    double t = guess;
    for (int step = 0; step < most_steps; ++step) {
      const dvec3 p = ray.origin + t * ray.direction;
      const double from_axis = std::hypot(p.x, p.y);
      const dvec3 ring = dvec3(p.x, p.y, 0) * (major / from_axis);
      const double distance = glm::length(p - ring) - minor;
      const dvec3 normal = glm::normalize(p - ring);
      if (std::abs(distance) < at_rest) return ObjectPoint{.position = p, .normal = normal};
      t -= distance / glm::dot(normal, ray.direction);
      if (!(std::abs(t - guess) * speed < farthest)) return {};
    }
    return {};
  }

 private:
  static constexpr double major = 0.7, minor = 0.3;  // as shapes.h says
};

/// A point of a patch and its derivatives.
struct PatchPoint {
  dvec3 position, along_u, along_v;
};

PatchPoint evaluate(const detail::BezierPatch& patch, double u, double v) {
  const auto bernstein = [](double t) {
    const double s = 1 - t;
    return std::array{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
  };
  const auto slope = [](double t) {
    const double s = 1 - t;
    return std::array{-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
  };
  const auto at_u = bernstein(u), at_v = bernstein(v), slope_u = slope(u), slope_v = slope(v);
  PatchPoint point{dvec3(0), dvec3(0), dvec3(0)};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const dvec3& control = patch.control[i][j];
      point.position += at_u[i] * at_v[j] * control;
      point.along_u += slope_u[i] * at_v[j] * control;
      point.along_v += at_u[i] * slope_v[j] * control;
    }
  return point;
}

class Teapot final : public AnalyticSurface {
 public:
  Teapot() {
    for (int i = 0; i < detail::teapot_patch_count; ++i) {
      patches_.push_back(detail::teapot_patch(i));
      for (int k = 0; k <= grid; ++k)
        for (int m = 0; m <= grid; ++m)
          samples_.push_back(
              evaluate(patches_.back(), double(k) / grid, double(m) / grid).position);
    }
  }

  std::optional<ObjectPoint> meet(const Ray& ray, double t) const override {
    const dvec3 guess = ray.origin + t * ray.direction;
    // Where patches meet, or one passes through another, the nearest sample's may be the wrong one.
    std::vector<std::pair<double, std::size_t>> starts;  // of each patch, its nearest sample
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const dvec3 offset = samples_[i] - guess;
      const std::pair start(glm::dot(offset, offset), i);
      if (i % samples_a_patch == 0)
        starts.push_back(start);
      else
        starts.back() = std::min(starts.back(), start);
    }
    std::ranges::sort(starts);
    std::optional<ObjectPoint> nearest;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto point = refine(ray, t, starts[i].second);
      if (point && (!nearest || glm::distance(point->position, guess) <
                                    glm::distance(nearest->position, guess)))
        nearest = point;
    }
    return nearest;
  }

 private:
  static constexpr int grid = 8;
  static constexpr std::size_t samples_a_patch = (grid + 1) * (grid + 1);

  std::optional<ObjectPoint> refine(const Ray& ray, double guess, std::size_t sample) const {
    const detail::BezierPatch& patch = patches_[sample / samples_a_patch];
    const std::size_t in_patch = sample % samples_a_patch;
    dvec3 uvt(double(in_patch / (grid + 1)) / grid, double(in_patch % (grid + 1)) / grid, guess);
    for (int step = 0; step < most_steps; ++step) {
      const PatchPoint s = evaluate(patch, uvt.x, uvt.y);
      const dvec3 off = s.position - (ray.origin + uvt.z * ray.direction);
      const double speed = glm::length(ray.direction);
      if (!(std::abs(uvt.z - guess) * speed < farthest)) return {};
      if (glm::length(off) < at_rest) {
        const bool on_patch = std::max(std::abs(uvt.x - 0.5), std::abs(uvt.y - 0.5)) <= 0.5 + 1e-9;
        const dvec3 normal = glm::cross(s.along_v, s.along_u);
        // At the points where an edge of a patch is a single point there is no normal.
        if (!on_patch || !(glm::length(normal) > 1e-9)) return {};
        return ObjectPoint{.position = s.position, .normal = glm::normalize(normal)};
      }
      const dmat3 jacobian(s.along_u, s.along_v, -ray.direction);
      uvt -= glm::inverse(jacobian) * off;
    }
    return {};
  }

  std::vector<detail::BezierPatch> patches_;
  std::vector<dvec3> samples_;
};

/// The ray through the centre of a pixel, in object space.
Ray ray_through(const dmat4& object_from_clip, int x, int y, const ExactPicture& picture) {
  const double clip_x = 2 * (x + 0.5) / picture.width - 1;
  const double clip_y = 1 - 2 * (y + 0.5) / picture.height;
  const auto at_depth = [&](double depth) {
    const dvec4 p = object_from_clip * dvec4(clip_x, clip_y, depth, 1);
    return dvec3(p) / p.w;
  };
  const dvec3 near = at_depth(1);
  return {near, at_depth(0.5) - near};
}

}  // namespace

std::unique_ptr<AnalyticSurface> analytic_surface(std::string_view shape) {
  const std::string_view name = shape.substr(0, shape.find(':'));
  if (name == "sphere" || name == "icosphere") return std::make_unique<UnitSphere>();
  if (name == "torus") return std::make_unique<Torus>();
  if (name == "teapot") return std::make_unique<Teapot>();
  return nullptr;
}

ExactPicture render_analytic(const Scene& scene, const Camera& camera, int width, int height) {
  std::vector<std::unique_ptr<AnalyticSurface>> surfaces;
  for (const Object& object : scene.objects) {
    surfaces.push_back(analytic_surface(object.mesh ? object.mesh->name : ""));
    if (!surfaces.back())
      throw Error("no analytic surface is known of '" + (object.mesh ? object.mesh->name : "") +
                  "'; there are: sphere, icosphere, torus, teapot");
  }
  const ExactPicture mesh = render_reference(scene, camera, width, height);
  const dmat4 clip_from_world_ = clip_from_world(camera, double(width) / height);
  const dvec3 viewing = -towards_viewer(camera);
  ExactPicture picture(width, height, scene.background);
  for (std::size_t i = 0; i < mesh.pixel_count(); ++i) {
    if (mesh.object[i] == no_id) continue;
    const Object& object = scene.objects[mesh.object[i]];
    const dmat4 world_from_object(object.world_from_object);
    const Ray ray = ray_through(glm::inverse(clip_from_world_ * world_from_object), int(i) % width,
                                int(i) / width, mesh);
    const auto distance = [&](double t) {
      const dvec3 p = ray.origin + t * ray.direction;
      return glm::dot(dvec3(world_from_object * dvec4(p, 1)) - camera.eye, viewing);
    };
    const double t = (mesh.distance[i] - distance(0)) / (distance(1) - distance(0));
    auto point = surfaces[mesh.object[i]]->meet(ray, t);
    if (!point) continue;
    if (glm::dot(point->normal, ray.direction) > 0) point->normal = -point->normal;
    picture.colour[i] = radiance_in_double(scene, camera, object, *point);
    picture.object[i] = mesh.object[i], picture.triangle[i] = mesh.triangle[i];
    picture.normal[i] = world_normal(object, *point, -viewing);
    picture.distance[i] =
        glm::dot(dvec3(world_from_object * dvec4(point->position, 1)) - camera.eye, viewing);
  }
  return picture;
}

}  // namespace scanlit
