#include "lessons/studio/drawing/stages.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "rasterizer/error.h"

namespace scanlit::studio {

std::vector<ClipVertex> clip_space(const Object& object, const Camera& camera, double aspect) {
  const glm::dmat4 clip_from_object =
      clip_from_world(camera, aspect) * glm::dmat4(object.world_from_object);
  std::vector<ClipVertex> result;
  for (const glm::vec3& position : object.mesh->positions) {
    const glm::vec4 clip(clip_from_object * glm::dvec4(position, 1.0));
    result.push_back({clip.x, clip.y, clip.z, clip.w});
  }
  return result;
}

ScreenTriangle on_screen(const std::vector<ClipVertex>& vertices, const Mesh& mesh, std::size_t t,
                         const Framebuffer& image) {
  const Viewport viewport{image.width, image.height};
  const std::uint32_t* const corner = &mesh.indices[3 * t];
  return screen_triangle(project(vertices[corner[0]], viewport),
                         project(vertices[corner[1]], viewport),
                         project(vertices[corner[2]], viewport));
}

// A point of the triangle with weights b lies at sum b_i (x_i, y_i, w_i) in clip space, and is seen
// at the pixel (px, py) where that is a multiple of (px, py, 1): three equations for b.
std::vector<VisiblePoint> visible_points(const Object& object, const Camera& camera, int width,
                                         int height) {
  Scene scene;
  scene.objects = {object};
  Framebuffer ids(width, height, {.ids = true});
  render(scene, camera, {}, ids);

  const auto clip = clip_space(object, camera, double(width) / height);
  std::vector<VisiblePoint> points;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::uint32_t t = ids.triangle_id[std::size_t(y) * std::size_t(width) + std::size_t(x)];
      if (t == no_id) continue;
      const std::uint32_t* const corner = &object.mesh->indices[3 * std::size_t(t)];
      glm::dmat3 corners;
      for (int k = 0; k < 3; ++k) {
        const ClipVertex& c = clip[corner[k]];
        corners[k] = {c.x, c.y, c.w};
      }
      const glm::dvec3 seen(2 * (x + 0.5) / width - 1, 1 - 2 * (y + 0.5) / height, 1);
      const glm::dvec3 b = glm::inverse(corners) * seen;
      points.push_back({x, y, t, {corner[0], corner[1], corner[2]}, b / (b.x + b.y + b.z)});
    }
  return points;
}

Rgb<double> reflected_light(const Scene& scene, const glm::dvec3& normal,
                            const glm::dvec3& to_viewer) {
  const Material& material = scene.objects.front().material;
  // Any tangent will do for a model that does not ask for one.
  const glm::dvec3 other = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 tangent = glm::normalize(glm::cross(other, normal));
  const glm::dmat3 frame(tangent, glm::cross(normal, tangent), normal);
  const auto in_frame = [&](const glm::dvec3& d) {
    const glm::dvec3 local = glm::transpose(frame) * d;
    return Vec3<double>{local.x, local.y, local.z};
  };
  const Vec3<double> v = in_frame(to_viewer), up{0, 0, 1};
  const Rgb<double> head_on = material.model->evaluate(up, up).diffuse;
  Rgb<double> sum = (material.ka + head_on * material.ambient_share) * scene.ambient;
  for (const Light& light : scene.lights) {
    if (light.kind != LightKind::directional) throw Error("reflected_light: a light is not far");
    const Vec3<double> l = in_frame(glm::normalize(light.direction));
    if (l.z <= 0) continue;
    const Reflection<double> braces = material.model->evaluate(l, v);
    sum = sum + (braces.diffuse + braces.glossy) * light.colour * light.intensity;
  }
  return sum;
}

}  // namespace scanlit::studio
