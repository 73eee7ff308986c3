#include "lessons/studio/description.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lessons/studio/framing.h"
#include "lessons/studio/text.h"
#include "rasterizer/error.h"
#include "rasterizer/shapes.h"

namespace scanlit::studio {
namespace {

std::shared_ptr<const Mesh> read_mesh(const ObjectDescription& object) {
  if (is_shape(object.mesh)) {
    Mesh mesh = make_shape(object.mesh);
    if (object.mesh_options.crease_deg)
      mesh.warnings.push_back("a built-in shape knows its normals: the crease angle has no effect");
    return std::make_shared<const Mesh>(std::move(mesh));
  }
  const std::filesystem::path file = object.folder / object.mesh;
  if (!std::filesystem::exists(file) && !std::filesystem::path(object.mesh).has_extension()) {
    std::vector<std::string> names;
    for (const ShapeInfo& shape : shapes()) names.push_back(shape.name);
    throw Error("'" + object.mesh + "' is neither a file nor a built-in shape" +
                did_you_mean(object.mesh.substr(0, object.mesh.find(':')), names));
  }
  return std::make_shared<const Mesh>(load_mesh(file, object.mesh_options));
}

Material make_material(const MaterialDescription& description) {
  Material material;
  material.model = description.model.model;
  material.form = description.form;
  material.object_colour = description.object_colour;
  material.tangents =
      description.tangents.value_or(description.model.tangents.value_or(Tangents{}));
  // What the model's diffuse part shows when lit and seen head-on: kd, where it has one. Where it
  // varies, lighting asks for it at every point.
  const bool varies = material.model->needs().parameters > 0;
  const Rgb<double> head_on = material.model->evaluate(Vec3<double>{0, 0, 1}, {0, 0, 1}).diffuse;
  material.ka = description.ka.value_or(varies ? Rgb<double>(0.0) : head_on * ambient_share);
  material.ambient_share = varies && !description.ka ? ambient_share : 0;
  return material;
}

/// Farther out, a camera that sees everything would stand where float ends.
constexpr double largest_reach = 1e25;

Light directional(const glm::dvec3& towards_light, double intensity, const Rgb<double>& colour) {
  Light light;
  light.direction = glm::normalize(towards_light);
  light.intensity = intensity;
  light.colour = colour;
  return light;
}

/// Azimuth 0 is +z for +y up, and -y for +z up: in both x stays on the right.
glm::dvec3 viewing_direction(const View& view) {
  if (glm::length(view.up) == 0) throw Error("camera: up is the zero vector");
  const glm::dvec3 up = glm::normalize(view.up);
  const glm::dvec3 side = std::abs(up.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 front = glm::normalize(glm::cross(side, up));
  const glm::dvec3 right = glm::cross(up, front);
  const double azimuth_rad = glm::radians(view.azimuth_deg);
  const double elevation_rad = glm::radians(view.elevation_deg);
  return std::cos(elevation_rad) * (std::cos(azimuth_rad) * front + std::sin(azimuth_rad) * right) +
         std::sin(elevation_rad) * up;
}

/// Near and far planes for a viewer whose place is given: they clear the scene where they can.
void set_depth_range(Camera& camera, const Sphere& bounds) {
  const double distance = glm::length(bounds.centre - camera.eye);
  const double radius = std::max(bounds.radius, 1e-6);  // a scene of one point has no size
  // A viewer inside the scene must still see what is close by: a thousandth of its size.
  camera.near = std::max(distance - 1.01 * radius, 1e-3 * radius);
  camera.far = distance + 1.01 * radius;
}

}  // namespace

Description describe_object(const std::string& mesh) {
  Description description;
  ObjectDescription object;
  object.name = mesh;
  object.mesh = mesh;
  object.material.model = models::make(default_model);
  description.objects.push_back(std::move(object));
  return description;
}

Scene make_scene(const Description& description) {
  Meshes meshes;
  return make_scene(description, meshes);
}

Scene make_scene(const Description& description, Meshes& meshes) {
  Scene scene;
  scene.ambient = description.ambient_colour * description.ambient_intensity;
  scene.background = description.background;

  for (const ObjectDescription& from : description.objects) {
    const Meshes::key_type source{
        is_shape(from.mesh) ? std::filesystem::path(from.mesh) : from.folder / from.mesh,
        from.mesh_options.normal_weight, from.mesh_options.crease_deg.value_or(-1)};
    std::shared_ptr<const Mesh>& mesh = meshes[source];
    try {
      if (!mesh) mesh = read_mesh(from);
    } catch (const Error& error) {
      if (from.where.empty()) throw;
      throw Error(from.where, error.what());
    }
    scene.objects.push_back({mesh, from.world_from_object, make_material(from.material),
                             from.shading, from.sides, from.name});
  }
  return scene;
}

Camera make_camera(const View& view, const Scene& scene, double aspect) {
  const Sphere bounds = bounding_sphere(scene);
  const double reach = glm::length(bounds.centre) + bounds.radius;
  if (!(reach <= largest_reach))
    throw Error("the scene reaches " + text_of(reach) + " units from the origin; " +
                text_of(largest_reach) + " is the most that a camera can be placed around");
  Camera camera;
  camera.up = view.up;
  camera.projection = view.projection;
  camera.fov_deg = view.fov_deg;
  camera.viewer_at_infinity = view.viewer_at_infinity;
  if (view.eye) {
    camera.eye = *view.eye;
    camera.target = view.target.value_or(bounds.centre);
    camera.height = 2 * bounds.radius;
    set_depth_range(camera, bounds);
  } else {
    camera.target = view.target.value_or(bounds.centre);
    // Far from the origin a step of length 1 would drown in rounding.
    const double step = std::max(1.0, glm::length(camera.target));
    camera.eye = camera.target + viewing_direction(view) * step;
    // Around a given target the scene may lie anywhere: a sphere does then.
    const double beside = glm::length(bounds.centre - camera.target);
    camera = view.target ? framed(camera, {camera.target, bounds.radius + beside}, aspect)
                         : fitted(camera, scene, aspect);
  }
  camera.height = view.height.value_or(camera.height);
  camera.near = view.near.value_or(camera.near);
  camera.far = view.far.value_or(camera.far);
  validate(camera);
  return camera;
}

std::vector<Light> make_lights(const Description& description, const Camera& camera) {
  if (!description.lights.empty()) return description.lights;
  const glm::dmat3 axes = viewer_axes(camera);
  return {directional(axes * glm::dvec3(-0.7, 0.7, 0.5), 1.0, {1.0, 0.97, 0.92}),
          directional(axes * glm::dvec3(0.9, 0.1, 0.4), 0.2, {0.7, 0.83, 1.0})};
}

std::pair<Scene, Camera> make_scene_and_camera(const Description& description) {
  const Picture& picture = description.picture;
  Scene scene = make_scene(description);
  const Camera camera =
      make_camera(description.view, scene, double(picture.width) / picture.height);
  scene.lights = make_lights(description, camera);
  return {std::move(scene), camera};
}

}  // namespace scanlit::studio
