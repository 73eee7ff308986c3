// [material.NAME] of a scene file.
#include "lessons/studio/scene_sections.h"

namespace scanlit::studio {
namespace {

/// models::make(), its errors placed at `key` of the table.
models::NamedModel make_model(const TomlTable& table, const char* key,
                              const std::string& specification) {
  try {
    return models::make(specification);
  } catch (const Error& error) {
    table.refuse(key, error.what());
  }
}

/// { name = "blinn-phong", kd = [.6, .3, .2], n = 80 }
models::NamedModel model_from_table(TomlTable table) {
  const auto name = table.text("name");
  if (!name) throw Error(table.where(), "a model has a name: { name = \"blinn-phong\", ... }");
  make_model(table, "name", *name);
  std::string specification = *name;
  for (const std::string& key : table.keys()) {
    if (key == "name") continue;
    const std::string pair = key + '=' + text_of(*table.colour(key.c_str(), any_coordinate));
    make_model(table, key.c_str(), *name + ':' + pair);  // alone, so that an error has its place
    specification += (specification == *name ? ':' : ',') + pair;
  }
  return make_model(table, "name", specification);
}

models::NamedModel read_model(TomlTable& material) {
  const toml::node* value = material.node("model");
  if (!value) return models::make(default_model);
  if (value->is_table()) return model_from_table(*material.table("model", "the model"));
  return make_model(material, "model", *material.text("model"));
}

/// { field = "around", axis = [0, 1, 0], centre = [0, 0, 0] }
Tangents tangents_from_table(TomlTable table) {
  Tangents tangents;
  const auto field = table.choice("field", tangent_fields);
  if (!field) throw Error(table.where(), "tangents have a field: around, along or texcoord");
  tangents.field = *field;
  if (const auto axis = table.vector("axis")) {
    tangents.axis = *axis;
    if (*field == TangentField::texcoord) table.refuse("axis", "texcoord has no axis");
    if (tangents.axis == glm::vec3(0)) table.refuse("axis", "axis is the zero vector");
  }
  if (const auto centre = table.vector("centre")) {
    tangents.centre = *centre;
    if (*field != TangentField::around) table.refuse("centre", "only around has a centre");
  }
  table.refuse_unknown_keys();
  return tangents;
}

std::optional<Tangents> read_tangents(TomlTable& material) {
  const toml::node* value = material.node("tangents");
  if (value && value->is_table())
    return tangents_from_table(*material.table("tangents", "tangents"));
  return material.choice("tangents", brushes);
}

}  // namespace

MaterialDescription read_material(TomlTable table) {
  MaterialDescription material;
  material.model = read_model(table);
  material.ka = table.colour("ka", reflectance_range);
  const auto form = table.integer("form", {1, 2});
  const auto object_colour = table.colour("object_colour", reflectance_range);
  if (form == 1 && object_colour)
    table.refuse("object_colour", "only form 2 has an object colour; in form 1 kd is it");
  if (form == 2 || object_colour) material.form = ColourForm::plastic;
  set(material.object_colour, object_colour);
  set(material.tangents, read_tangents(table));
  table.refuse_unknown_keys();
  return material;
}

}  // namespace scanlit::studio
