// [[object]] of a scene file.
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>

#include "lessons/studio/scene_sections.h"

namespace scanlit::studio {
namespace {

/// rotate = { axis = [0, 1, 0], angle = 30 }, or three angles about x, y and z, taken in that
/// order.
glm::dmat4 read_rotation(TomlTable& object) {
  const glm::dmat4 identity(1.0);
  const toml::node* value = object.node("rotate");
  if (!value) return identity;
  if (value->is_table()) {
    TomlTable table = *object.table("rotate", "rotate");
    const glm::dvec3 axis = table.vector("axis").value_or(glm::dvec3(0, 1, 0));
    const auto angle_deg = table.number("angle", any_angle_deg);
    table.refuse_unknown_keys();
    if (!angle_deg) throw Error(table.where(), "rotate has no angle, in degrees");
    if (glm::length(axis) == 0) table.refuse("axis", "axis is the zero vector");
    return glm::rotate(identity, glm::radians(*angle_deg), glm::normalize(axis));
  }
  const auto angles_deg = *object.numbers("rotate", 3, any_angle_deg);
  glm::dmat4 rotation = identity;
  for (int axis : {2, 1, 0}) {
    glm::dvec3 direction(0);
    direction[axis] = 1;
    rotation = glm::rotate(rotation, glm::radians(angles_deg[axis]), direction);
  }
  return rotation;
}

glm::dvec3 read_scale(TomlTable& object) {
  const toml::node* value = object.node("scale");
  glm::dvec3 scale(1);
  if (value && value->is_number())
    scale = glm::dvec3(*object.number("scale", any_coordinate));
  else
    set(scale, object.vector("scale"));
  for (int i = 0; i < 3; ++i)
    if (std::abs(scale[i]) < any_length.min)
      object.refuse("scale", "scale is 0: the object would have no extent");
  return scale;
}

/// Four rows of four numbers, as the textbook writes them.
glm::dmat4 read_matrix(TomlTable& object) {
  const auto numbers = *object.matrix("matrix", 4, any_coordinate);
  const glm::dmat4 matrix = glm::transpose(glm::make_mat4(numbers.data()));
  if (glm::row(matrix, 3) != glm::dvec4(0, 0, 0, 1))
    object.refuse("matrix", "the last row of an affine matrix is 0, 0, 0, 1");
  return matrix;
}

glm::dmat4 read_transform(TomlTable& object) {
  const glm::dmat4 identity(1.0);
  const glm::dvec3 translation = object.vector("translate").value_or(glm::dvec3(0));
  const glm::dmat4 rotation = read_rotation(object);
  const glm::dvec3 scale = read_scale(object);
  if (!object.node("matrix"))
    return glm::translate(identity, translation) * rotation * glm::scale(identity, scale);
  for (const char* key : {"translate", "rotate", "scale"})
    if (object.node(key)) object.refuse(key, "matrix already places the object; keep one of them");
  return read_matrix(object);
}

const MaterialDescription& find_material(const TomlTable& object, const std::string& name,
                                         const Materials& materials) {
  const auto found = materials.find(name);
  if (found != materials.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, material] : materials) names.push_back(known);
  object.refuse("material", "unknown material '" + name + "'" +
                                (names.empty() ? "; the scene has no [material." + name + "]"
                                               : did_you_mean(name, names)));
}

}  // namespace

ObjectDescription read_object(TomlTable table, const Materials& materials,
                              const std::filesystem::path& folder) {
  ObjectDescription object;
  const auto mesh = table.text("mesh");
  const auto material = table.text("material");
  set(object.name, table.text("name"));
  set(object.shading, table.choice("shading", shadings));
  set(object.sides, table.choice("sides", all_sides));
  object.mesh_options.crease_deg = table.number("crease", crease_range_deg);
  set(object.mesh_options.normal_weight, table.choice("normals", normal_weights));
  object.world_from_object = read_transform(table);
  table.refuse_unknown_keys();

  if (!mesh) throw Error(table.where(), "an object has a mesh: mesh = \"teapot:16\", or a file");
  object.mesh = *mesh;
  object.folder = folder;
  object.where = table.where("mesh");
  if (object.name.empty()) object.name = *mesh;
  if (material)
    object.material = find_material(table, *material, materials);
  else
    object.material.model = models::make(default_model);
  return object;
}

}  // namespace scanlit::studio
