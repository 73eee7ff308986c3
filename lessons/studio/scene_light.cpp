// [[light]] of a scene file.
#include <glm/geometric.hpp>
#include <tuple>

#include "lessons/studio/scene_sections.h"

namespace scanlit::studio {
namespace {

void read_falloff(TomlTable& table, Light& light) {
  const toml::node* value = table.node("falloff");
  if (!value) return;
  if (value->is_array()) {
    const auto terms = *table.numbers("falloff", 3, light_range);
    std::tie(light.constant, light.linear, light.quadratic) =
        std::tie(terms[0], terms[1], terms[2]);
    if (terms[0] + terms[1] + terms[2] == 0)
      table.refuse("falloff", "falloff is zero: the light would be divided by it");
  } else {
    const Choices<double> quadratic_terms{{"none", 0.0}, {"inverse-square", 1.0}};
    light.quadratic = *table.choice("falloff", quadratic_terms);
    light.constant = 1 - light.quadratic;
  }
}

void read_direction(TomlTable& table, Light& light) {
  set(light.direction, table.vector("direction"));
  if (glm::length(light.direction) == 0) table.refuse("direction", "direction is the zero vector");
}

void read_cone(TomlTable& table, Light& light) {
  set(light.inner_deg, table.number("inner", {0, 90}));
  set(light.outer_deg, table.number("outer", {0, 90}));
  if (light.inner_deg >= light.outer_deg)
    table.refuse("inner", "inner is " + text_of(light.inner_deg) + " and outer " +
                              text_of(light.outer_deg) + " degrees; inner must be the smaller");
}

}  // namespace

Light read_light(TomlTable table) {
  Light light;
  set(light.kind, table.choice("kind", light_kinds));
  set(light.intensity, table.number("intensity", light_range));
  set(light.colour, table.colour("colour", light_range));
  std::optional<glm::dvec3> position;
  // Each kind has its own keys: a directional light with a position is a mistake worth hearing of.
  if (light.kind != LightKind::directional) {
    position = table.vector("position");
    set(light.position, position);
    read_falloff(table, light);
  }
  if (light.kind != LightKind::point) read_direction(table, light);
  if (light.kind == LightKind::spot) read_cone(table, light);
  table.refuse_unknown_keys();
  if (light.kind != LightKind::directional && !position)
    throw Error(table.where(), "a point light or spot has a position: position = [0, 3, 1]");
  return light;
}

}  // namespace scanlit::studio
