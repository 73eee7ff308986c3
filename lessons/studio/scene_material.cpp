// [material.NAME] of a scene file.
#include "lessons/studio/scene_sections.h"

namespace scanlit::studio {
namespace {

/// A value as a specification has it: .6/.3/.2, 80, ggx, image(cow.png), (lambert:kd=.5).
std::string value_text(TomlTable& table, const std::string& key) {
  const toml::node* node = table.node(key.c_str());
  if (!node->is_string()) return text_of(*table.colour(key.c_str(), any_coordinate));
  const std::string text = *table.text(key.c_str());
  const bool is_model = models::split_outside_parentheses(text, ':').size() > 1;
  return is_model ? '(' + text + ')' : text;
}

/// The key of the table that the message names, 'n', else `otherwise`.
std::string key_of(const std::string& message, const TomlTable& table,
                   const std::string& otherwise) {
  std::string found = otherwise;
  std::size_t first = message.size();
  for (const std::string& key : table.keys())
    if (const auto at = message.find('\'' + key + '\''); key != "name" && at < first)
      first = at, found = key;
  return found;
}

/// { name = "blinn-phong", kd = [.6, .3, .2], n = 80 }
models::NamedModel model_from_table(TomlTable table, const std::filesystem::path& folder) {
  const auto name = table.text("name");
  if (!name) throw Error(table.where(), "a model has a name: { name = \"blinn-phong\", ... }");
  std::string specification = *name;
  for (const std::string& key : table.keys())
    if (key != "name")
      specification += (specification == *name ? ':' : ',') + key + '=' + value_text(table, key);
  try {
    return models::make(specification, folder);
  } catch (const Error& error) {
    table.refuse(key_of(error.what(), table, "name"), error.what());
  }
}

models::NamedModel read_model(TomlTable& material, const std::filesystem::path& folder) {
  const toml::node* value = material.node("model");
  if (!value) return models::make(default_model);
  if (value->is_table()) return model_from_table(*material.table("model", "the model"), folder);
  const std::string specification = *material.text("model");
  try {
    return models::make(specification, folder);
  } catch (const Error& error) {
    material.refuse("model", error.what());
  }
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

MaterialDescription read_material(TomlTable table, const std::filesystem::path& folder) {
  MaterialDescription material;
  material.model = read_model(table, folder);
  material.ka = table.colour("ka", reflectance_range);
  const auto form = table.integer("form", {1, 2});
  const auto object_colour = table.colour("object_colour", reflectance_range);
  if (form == 1 && object_colour)
    table.refuse("object_colour", "only form 2 has an object colour; in form 1 kd is it");
  if (form == 2 || object_colour) material.form = ColourForm::plastic;
  set(material.object_colour, object_colour);
  material.tangents = read_tangents(table);
  table.refuse_unknown_keys();
  return material;
}

}  // namespace scanlit::studio
