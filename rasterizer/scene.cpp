#include "rasterizer/scene.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "rasterizer/error.h"

namespace scanlit {

namespace {

// Beyond this a product of intensity, reflectance and a fall-off could leave float's range.
constexpr double largest_radiance = 1e12;

// Scenes have thousands of objects, asked anew in each frame: no string is made for what holds.
void require(bool holds, const std::string& where, const char* what) {
  if (!holds) throw Error(where, what);
}

bool holds_float(const glm::dvec3& v) {
  const double largest = 1e18;  // beyond it distances leave float
  return std::abs(v.x) <= largest && std::abs(v.y) <= largest && std::abs(v.z) <= largest;
}

void require_colour(const Rgb<double>& c, const std::string& where, const char* field) {
  for (const double channel : {c.r, c.g, c.b})
    if (!(channel >= 0 && channel <= largest_radiance))
      throw Error(where, std::string(field) + " must be 0 to 1e12");
}

void validate(const Object& object, const std::string& where) {
  require(object.mesh != nullptr, where, "has no mesh");
  require(object.material.model != nullptr, where, "has no reflection model");
  require_colour(object.material.ka, where, "ka");
  require_colour(object.material.object_colour, where, "object colour");
  const double share = object.material.ambient_share;
  require(share >= 0 && share <= 1, where, "the ambient share must be 0 to 1");
  const Tangents& tangents = object.material.tangents;
  require(holds_float(tangents.axis) && tangents.axis != glm::vec3(0), where,
          "the tangents' axis must be finite, each coordinate at most 1e18, and not zero");
  require(holds_float(tangents.centre), where,
          "the tangents' centre must be finite, each coordinate at most 1e18");
  const glm::mat4& m = object.world_from_object;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      require(std::isfinite(m[column][row]), where, "transform must be finite");
  require(m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1, where,
          "transform must be affine: its last row is 0 0 0 1");
}

void validate(const Light& light, const std::string& where) {
  require(light.intensity >= 0 && light.intensity <= largest_radiance, where,
          "intensity must be 0 to 1e12");
  require_colour(light.colour, where, "colour");
  if (light.kind != LightKind::point)
    // Its square, which normalising takes, must not leave double's range either.
    require(std::isnormal(glm::dot(light.direction, light.direction)), where,
            "direction must be finite and not zero");
  if (light.kind == LightKind::directional) return;
  require(holds_float(light.position), where,
          "position must be finite, each coordinate at most 1e18");
  const double fall_off[3] = {light.constant, light.linear, light.quadratic};
  for (const double coefficient : fall_off)
    require(coefficient >= 0 && std::isfinite(coefficient), where,
            "fall-off coefficients must not be negative");
  require(light.constant + light.linear + light.quadratic > 0, where,
          "at least one fall-off coefficient must be above 0");
  if (light.kind == LightKind::spot)
    require(light.inner_deg >= 0 && light.inner_deg < light.outer_deg && light.outer_deg <= 90,
            where, "spot angles must satisfy 0 <= inner < outer <= 90 degrees");
}

std::string label(const char* kind, std::size_t index, const std::string& name) {
  return std::string(kind) + " " + (name.empty() ? std::to_string(index) : "'" + name + "'");
}

}  // namespace

void validate(const Scene& scene) {
  std::size_t triangles = 0, vertices = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    validate(scene.objects[i], label("object", i, scene.objects[i].name));
    triangles += scene.objects[i].mesh->triangle_count();
    vertices += scene.objects[i].mesh->positions.size();
  }
  require(triangles < (1u << 31), "scene", "more than 2^31 - 1 triangles");
  require(vertices < (std::size_t(1) << 32), "scene", "more than 2^32 - 1 vertices");
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    validate(scene.lights[i], label("light", i, ""));
  require_colour(scene.ambient, "scene", "ambient");
  require_colour(scene.background, "scene", "background");
}

Sphere bounding_sphere(const Scene& scene) {
  const double infinity = std::numeric_limits<double>::infinity();
  glm::dvec3 low(infinity), high(-infinity);
  const auto for_each_position = [&](const auto& use) {
    for (const Object& object : scene.objects) {
      const glm::dmat4 m(object.world_from_object);
      for (const glm::vec3& p : object.mesh->positions) use(glm::dvec3(m * glm::dvec4(p, 1.0)));
    }
  };
  for_each_position([&](const glm::dvec3& p) { low = glm::min(low, p), high = glm::max(high, p); });
  if (!(low.x <= high.x)) return {};
  Sphere sphere{(low + high) * 0.5, 0};
  for_each_position([&](const glm::dvec3& p) {
    sphere.radius = std::max(sphere.radius, glm::distance(p, sphere.centre));
  });
  return sphere;
}

}  // namespace scanlit
