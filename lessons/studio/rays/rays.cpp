#include "lessons/studio/rays/rays.h"

#include <embree3/rtcore.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "lessons/studio/reflect/sheet_layout.h"
#include "rasterizer/error.h"

namespace scanlit::studio {

namespace {

// How far from a surface a ray begins, in world units: without it rounding lets surfaces shadow
// themselves, in spots. Objects are about as large as 1.
constexpr float beginning = 1e-4f;

void attach(RTCDevice device, RTCScene scene, const Object& object) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const Mesh& mesh = *object.mesh;
  auto* const positions = static_cast<glm::vec3*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              sizeof(glm::vec3), mesh.positions.size()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    positions[i] = glm::vec3(object.world_from_object * glm::vec4(mesh.positions[i], 1));
  std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                      3 * sizeof(std::uint32_t), mesh.triangle_count()),
              mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t));
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);  // numbered from 0, as objects are
  rtcReleaseGeometry(geometry);
}

RTCRay embree_ray(const glm::vec3& origin, const glm::vec3& direction, float end) {
  RTCRay ray{};
  ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
  ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
  ray.tnear = beginning, ray.tfar = end, ray.mask = ~0u;
  return ray;
}

/// Any two unit vectors perpendicular to the normal and to each other. Tom Duff et al., "Building
/// an orthonormal basis, revisited", JCGT 6(1), 2017.
glm::dmat3 frame(const glm::dvec3& n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

}  // namespace

struct Rays::Embree {
  // The same instructions on every processor: the same hits.
  RTCDevice device = rtcNewDevice("isa=sse4.2");
  RTCScene scene = nullptr;

  ~Embree() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

Rays::Rays(const Scene& scene) : embree_(std::make_unique<Embree>()), scene_(scene) {
  if (!embree_->device) throw Error("Embree gives no device");
  embree_->scene = rtcNewScene(embree_->device);
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);  // no ray slips between two triangles
  for (const Object& object : scene.objects) attach(embree_->device, embree_->scene, object);
  rtcCommitScene(embree_->scene);
  if (const RTCError error = rtcGetDeviceError(embree_->device); error != RTC_ERROR_NONE)
    throw Error("Embree error " + std::to_string(error));
}

Rays::~Rays() = default;

Hit Rays::first_hit(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{embree_ray(ray.origin, ray.direction, INFINITY), {}};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(embree_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  const Object& object = scene_.objects[query.hit.geomID];
  const Mesh& mesh = *object.mesh;
  const auto vertex_normal = [&](std::size_t corner) {
    return glm::dvec3(mesh.normals[mesh.indices[3 * std::size_t(query.hit.primID) + corner]]);
  };
  const double b1 = query.hit.u, b2 = query.hit.v;
  const glm::dvec3 normal = glm::normalize(
      glm::transpose(glm::inverse(glm::dmat3(object.world_from_object))) *
      (vertex_normal(0) * (1 - b1 - b2) + vertex_normal(1) * b1 + vertex_normal(2) * b2));
  return {&object, ray.origin + double(query.ray.tfar) * ray.direction,
          glm::dot(normal, ray.direction) < 0 ? normal : -normal};
}

bool Rays::free(const glm::dvec3& from, const glm::dvec3& to) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  const double distance = glm::distance(from, to);
  RTCRay ray = embree_ray(from, (to - from) / distance, float(distance) - beginning);
  rtcOccluded1(embree_->scene, &context, &ray);
  return ray.tfar >= 0;  // Embree's sign for a hit: -infinity
}

Rgb<double> reflected(const Hit& hit, const glm::dvec3& l, const glm::dvec3& v) {
  const auto local = [axes = glm::transpose(frame(hit.normal))](const glm::dvec3& d) {
    const glm::dvec3 result = axes * d;
    return Vec3<double>{result.x, result.y, result.z};
  };
  const Reflection<double> r = hit.object->material.model->evaluate(local(l), local(v));
  return r.diffuse + r.glossy;
}

double uniform(Random& random) { return double(random()) / 4294967296.0; }

glm::dvec3 in_ball(Random& random) {
  for (;;) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    const glm::dvec3 point = 2.0 * glm::dvec3(x, y, z) - 1.0;
    if (glm::dot(point, point) <= 1) return point;
  }
}

glm::dvec3 diffuse_direction(const glm::dvec3& normal, Random& random) {
  const double r2 = uniform(random), phi = 2 * std::numbers::pi * uniform(random);
  const double r = std::sqrt(r2);
  return frame(normal) * glm::dvec3(r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - r2));
}

Framebuffer trace(const Camera& camera, int width, int height, int rays_per_pixel,
                  const std::function<Rgb<double>(const Ray&, Random&)>& light_along) {
  Framebuffer picture = blank_picture(width, height, {});
  const glm::dmat4 world_from_clip = glm::inverse(clip_from_world(camera, double(width) / height));
  const auto through = [&](double x, double y) -> Ray {
    const auto world = [&](double depth) {
      const glm::dvec4 p =
          world_from_clip * glm::dvec4(2 * x / width - 1, 1 - 2 * y / height, depth, 1);
      return glm::dvec3(p) / p.w;
    };
    const glm::dvec3 near = world(1);  // depth is 1 at the near plane and falls from there
    return {near, glm::normalize(world(0.5) - near)};
  };
  tbb::parallel_for(0, width * height, [&](int i) {
    Random random{std::uint32_t(i)};
    Rgb<double> sum(0);
    for (int k = 0; k < rays_per_pixel; ++k) {
      const double dx = uniform(random), dy = uniform(random);
      sum = sum + light_along(through(i % width + dx, i / width + dy), random);
    }
    float* const pixel = &picture.colour[4 * std::size_t(i)];
    pixel[0] = float(sum.r / rays_per_pixel), pixel[1] = float(sum.g / rays_per_pixel);
    pixel[2] = float(sum.b / rays_per_pixel);
  });
  return picture;
}

}  // namespace scanlit::studio
