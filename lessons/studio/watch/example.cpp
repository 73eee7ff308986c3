#include "lessons/studio/watch/example.h"

#include <glm/geometric.hpp>

#include "lessons/studio/drawing/canvas.h"
#include "models/registry.h"

namespace scanlit::studio {

WatchExample watch_example() {
  // Columns, rows, and nearness.
  const glm::vec3 corners[] = {{4.5, 2.5, 5}, {3.5, 13, 5},     {16.5, 14.5, 5},
                               {4.5, 2.5, 5}, {16.5, 14.5, 5},  {20.5, 2.5, 5},
                               {23, 1.2, 8},  {8.5, 11.7, 0.5}, {29.3, 16.1, 8}};
  const Rgb<double> colours[] = {ink::sky, ink::orange, ink::yellow};
  auto mesh = std::make_shared<Mesh>();
  mesh->name = "three triangles";
  for (const glm::vec3& corner : corners) {
    const auto& [r, g, b] = colours[mesh->indices.size() / 3];
    mesh->indices.push_back(std::uint32_t(mesh->indices.size()));
    mesh->positions.emplace_back(corner.x, -corner.y, corner.z);
    mesh->colours.emplace_back(float(r), float(g), float(b));
    // As if bent, so that there is something to see when they are shaded.
    mesh->normals.push_back(glm::normalize(glm::vec3(corner.x - 16, 9 - corner.y, 12)));
  }
  WatchExample example;
  Object object;
  object.mesh = mesh;
  object.material.model = models::make("blinn-phong:kd=vertex-colour,ks=.25,n=40").model;
  object.sides = Sides::both;
  example.scene.objects = {object};
  Light light;
  light.direction = {-0.4, 0.5, 1};
  example.scene.lights = {light};
  example.scene.background = {0.03, 0.034, 0.042};
  example.camera.projection = Projection::orthographic;
  example.camera.eye = {example.width / 2.0, -example.height / 2.0, 10};
  example.camera.target = {example.width / 2.0, -example.height / 2.0, 0};
  example.camera.height = example.height;
  example.camera.near = 1;
  example.camera.far = 11;
  return example;
}

}  // namespace scanlit::studio
