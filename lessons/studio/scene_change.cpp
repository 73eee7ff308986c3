// A change of a scene file's text, after it is parsed and before it is read.
#include <algorithm>
#include <charconv>
#include <span>

#include "lessons/studio/scene_sections.h"
#include "models/specification.h"

namespace scanlit::studio {
namespace {

using Keys = std::span<const std::string_view>;
using Numbers = const std::vector<double>&;

toml::array list_of(Numbers value) {
  toml::array list;
  for (const double number : value) list.push_back(number);
  return list;
}

std::string joined(Numbers value) {
  std::string text;
  for (const double number : value) text += (text.empty() ? "" : "/") + text_of(number);
  return text;
}

/// Where arguments have no names, as in sum:(...),(...), they are counted from 0.
models::Argument* find_argument(models::Specification& model, std::string_view key) {
  for (std::size_t i = 0; i < model.arguments.size(); ++i) {
    models::Argument& argument = model.arguments[i];
    if (key == (argument.key.empty() ? std::to_string(i) : argument.key)) return &argument;
  }
  return nullptr;
}

/// The specification with one of its arguments changed, or one of those of a model within it.
std::string changed(std::string_view specification, Keys keys, Numbers value) {
  models::Specification model = models::parse_specification(specification);
  const std::string key(keys.front());
  models::Argument* argument = find_argument(model, key);
  if (keys.size() == 1) {
    if (!argument) argument = &model.arguments.emplace_back(key, "");
    argument->value = joined(value);
  } else {
    if (!argument) throw Error("'" + std::string(specification) + "' says no '" + key + "'");
    const std::string_view inner = models::without_parentheses(argument->value);
    argument->value = '(' + changed(inner, keys.subspan(1), value) + ')';
  }
  std::string text = model.name;
  for (const auto& [name, written] : model.arguments)
    text += (text == model.name ? ":" : ",") + name + (name.empty() ? "" : "=") + written;
  return text;
}

void change(toml::node& node, const std::string& name, Keys keys, Numbers value);

void change(toml::table& table, const std::string& name, Keys keys, Numbers value) {
  const std::string_view key = keys.front();
  if (keys.size() == 1) {
    if (value.size() == 1)
      table.insert_or_assign(key, value.front());
    else
      table.insert_or_assign(key, list_of(value));
    return;
  }
  toml::node* child = table.get(key);
  // Tables that may be left out; any other is one that somebody refers to.
  constexpr std::string_view optional[] = {"camera", "picture", "ambient", "background", "rotate"};
  if (!child && std::ranges::find(optional, key) != std::end(optional))
    child = &table.insert(key, toml::table()).first->second;
  if (!child) {
    std::vector<std::string> known;
    for (const auto& [there, unused] : table) known.emplace_back(there.str());
    throw Error(name + " has no '" + std::string(key) + "'" + did_you_mean(key, known));
  }
  change(*child, std::string(key), keys.subspan(1), value);
}

void change(toml::array& array, const std::string& name, Keys keys, Numbers value) {
  const std::string_view key = keys.front();
  std::size_t index = 0;
  const auto [end, code] = std::from_chars(key.data(), key.data() + key.size(), index);
  if (code != std::errc() || end != key.data() + key.size() || index >= array.size())
    throw Error(name + " has no '" + std::string(key) + "'; there are 0 to " +
                std::to_string(std::ptrdiff_t(array.size()) - 1));
  if (keys.size() > 1) return change(array[index], name, keys.subspan(1), value);
  if (value.size() > 1) throw Error(name + '.' + std::string(key) + " is one number, not a list");
  array.insert(array.erase(array.begin() + std::ptrdiff_t(index)), value.front());
}

void change(toml::node& node, const std::string& name, Keys keys, Numbers value) {
  if (toml::table* table = node.as_table()) return change(*table, name, keys, value);
  if (toml::array* array = node.as_array()) return change(*array, name, keys, value);
  if (toml::value<std::string>* text = node.as_string(); text && name == "model")
    *text = changed(text->get(), keys, value);
  else
    throw Error(name + " has nothing below it that could be '" + std::string(keys.front()) + "'");
}

}  // namespace

void apply(const SceneChange& scene_change, toml::table& root) {
  const auto keys = models::split_outside_parentheses(scene_change.path, '.');
  change(root, "the scene", keys, scene_change.value);
}

}  // namespace scanlit::studio
