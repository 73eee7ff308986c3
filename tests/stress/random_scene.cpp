#include "tests/stress/random_scene.h"

#include <algorithm>

#include "models/registry.h"
#include "tests/stress/grid_mesh.h"

namespace scanlit::stress {

namespace {

glm::vec3 random_colour(Property& property) {
  return {property.uniform(0, 1), property.uniform(0, 1), property.uniform(0, 1)};
}

std::shared_ptr<const ReflectionModel> random_model(Property& property) {
  static const std::vector<std::shared_ptr<const ReflectionModel>> models = [] {
    std::vector<std::shared_ptr<const ReflectionModel>> all;
    for (const char* specification :
         {"lambert", "phong:n=200", "blinn-phong:kd=vertex-colour,n=20", "blinn-phong:n=2000",
          "cook-torrance:D=ggx,a=.05,G=smith-correlated", "torrance-sparrow",
          "oren-nayar:rho=noise(scale=4)", "oren-nayar-full", "ward:ax=.02,ay=.5",
          "ashikhmin-shirley", "lafortune", "finished-wood:kd=wood-colour,u=wood-fibre",
          "clear-coat:base=(lambert)", "lambert:kd=checker"})
      try {
        all.push_back(models::make(specification).model);
      } catch (const std::exception& error) {
        ADD_FAILURE() << specification << ": " << error.what();
      }
    return all;
  }();
  return models[std::size_t(property.whole(0, int(models.size()) - 1))];
}

std::shared_ptr<Mesh> random_mesh(Property& property) {
  // Now and then so many triangles that a tile has thousands.
  const bool fine = property.whole(0, 15) == 0;
  const int columns = fine ? 200 : property.whole(3, 40), rows = fine ? 100 : property.whole(3, 40);
  const Grid grid(columns, rows, true, property);
  std::vector<glm::vec3> positions;
  for (const auto& p : torus_positions(columns, rows, property.uniform(0.1, 0.5),
                                       property.any_of(0.0, 0.01, 1.0), property))
    positions.emplace_back(p);
  auto mesh = mesh_of(positions, grid.indices);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    mesh->normals[i] = glm::normalize(glm::dvec3(positions[i]) + 0.3 * random_direction(property));
    mesh->colours.push_back(random_colour(property));
    mesh->texcoords.emplace_back(property.uniform(-2, 2), property.uniform(-2, 2));
    const glm::vec3 side = random_direction(property);
    mesh->tangents.push_back(glm::normalize(glm::cross(side, mesh->normals[i])));
  }
  // All normals of each triangle equal, as a wall's are.
  if (property.whole(0, 3) == 0) std::ranges::fill(mesh->normals, random_direction(property));
  return mesh;
}

Object random_object(Property& property) {
  Object object;
  object.mesh = random_mesh(property);
  for (int i = 0; i < 3; ++i)
    object.world_from_object[i] =
        glm::vec4(glm::vec3(random_direction(property) * property.uniform(0.2, 1)), 0);
  object.world_from_object[3] = glm::vec4(glm::vec3(random_direction(property)), 1);
  object.material.model = random_model(property);
  object.material.ambient_share = property.any_of(0.0, 0.3);
  object.material.form = property.any_of(ColourForm::tinted, ColourForm::plastic);
  object.material.tangents.field =
      property.any_of(TangentField::around, TangentField::along, TangentField::texcoord);
  object.shading = property.any_of(Shading::flat, Shading::gouraud, Shading::phong);
  object.sides = property.any_of(Sides::front, Sides::both);
  return object;
}

Light random_light(Property& property) {
  Light light;
  light.kind = property.any_of(LightKind::directional, LightKind::point, LightKind::spot);
  light.direction = random_direction(property);
  light.position = 3.0 * random_direction(property);
  const glm::vec3 c = random_colour(property);
  light.colour = {double(c.r), double(c.g), double(c.b)};
  light.quadratic = property.any_of(0.0, 1.0);
  return light;
}

}  // namespace

RandomScene random_scene(Property& property) {
  RandomScene all;
  for (int i = property.whole(1, 5); i > 0; --i)
    all.scene.objects.push_back(random_object(property));
  for (int i = property.whole(0, 4); i > 0; --i) all.scene.lights.push_back(random_light(property));
  all.scene.ambient = Rgb<double>(property.uniform(0, 1));
  all.scene.background = {0.1, 0.2, 0.4};
  // From far outside to within the objects.
  all.camera.eye = random_direction(property) * property.uniform(0.5, 5);
  all.camera.target = 0.5 * random_direction(property);
  all.camera.up = random_direction(property);
  all.camera.projection = property.any_of(Projection::perspective, Projection::orthographic);
  all.camera.far = 100;
  all.camera.viewer_at_infinity = property.coin();
  all.settings.samples = property.any_of(1, 1, 4, 8, 16);
  all.width = property.whole(1, 200);
  all.height = property.whole(1, 150);
  // Where colours alone are wanted, less is made.
  const bool more = property.coin();
  all.planes = {.depth = true, .normal = more, .ids = true, .parts = more};
  return all;
}

Framebuffer draw(const RandomScene& all) {
  Framebuffer framebuffer(all.width, all.height, all.planes);
  render(all.scene, all.camera, all.settings, framebuffer);
  return framebuffer;
}

}  // namespace scanlit::stress
