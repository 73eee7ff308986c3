#include "lessons/studio/toml_table.h"

#include <algorithm>
#include <tuple>

namespace scanlit::studio {

TomlTable::TomlTable(const toml::table& table, std::string file, std::string what)
    : table_(&table), file_(std::move(file)), what_(std::move(what)) {}

std::string TomlTable::place(const toml::source_region& region) const {
  if (region.begin.line == 0) return file_;  // a change of the scene, which no line says
  return file_ + ':' + std::to_string(region.begin.line) + ':' +
         std::to_string(region.begin.column);
}

std::string TomlTable::where(std::string_view key) const {
  const toml::node* value = table_->get(key);
  return place(value ? value->source() : table_->source());
}

void TomlTable::refuse(std::string_view key, const std::string& what) const {
  throw Error(where(key), what);
}

const toml::node* TomlTable::node(const char* key) {
  known_keys_.push_back(key);
  return table_->get(key);
}

std::optional<std::string> TomlTable::text(const char* key) {
  const toml::node* value = node(key);
  if (!value) return std::nullopt;
  if (!value->is_string()) refuse(key, std::string(key) + " must be text in quotes");
  return value->as_string()->get();
}

double TomlTable::finite_number(const char* key, const toml::node& value,
                                const Range& range) const {
  const std::string at = place(value.source());
  if (!value.is_number()) throw Error(at, std::string(key) + " must be a number");
  return in_range(at + ": " + key, *value.value<double>(), range);
}

std::optional<double> TomlTable::number(const char* key, const Range& range) {
  const toml::node* value = node(key);
  return value ? std::optional(finite_number(key, *value, range)) : std::nullopt;
}

std::optional<int> TomlTable::integer(const char* key, const Range& range) {
  const toml::node* value = node(key);
  if (!value) return std::nullopt;
  if (!value->is_integer()) refuse(key, std::string(key) + " must be a whole number");
  return static_cast<int>(finite_number(key, *value, range));
}

std::optional<bool> TomlTable::boolean(const char* key) {
  const toml::node* value = node(key);
  if (!value) return std::nullopt;
  if (!value->is_boolean()) refuse(key, std::string(key) + " must be true or false");
  return value->as_boolean()->get();
}

void TomlTable::append_numbers(const char* key, const toml::node& list, std::size_t count,
                               const Range& range, std::vector<double>& numbers) const {
  const toml::array* array = list.as_array();
  if (!array || array->size() != count)
    throw Error(place(list.source()),
                std::string(key) + ": a list of " + std::to_string(count) + " numbers is expected");
  for (const toml::node& element : *array) numbers.push_back(finite_number(key, element, range));
}

std::optional<std::vector<double>> TomlTable::numbers(const char* key, std::size_t count,
                                                      const Range& range) {
  const toml::node* value = node(key);
  if (!value) return std::nullopt;
  std::vector<double> numbers;
  append_numbers(key, *value, count, range, numbers);
  return numbers;
}

std::optional<std::vector<double>> TomlTable::matrix(const char* key, std::size_t rows,
                                                     const Range& range) {
  const toml::node* value = node(key);
  if (!value) return std::nullopt;
  const toml::array* array = value->as_array();
  if (!array || array->size() != rows)
    refuse(key, std::string(key) + " must be a list of " + std::to_string(rows) + " rows");
  std::vector<double> numbers;
  for (const toml::node& row : *array) append_numbers(key, row, rows, range, numbers);
  return numbers;
}

std::optional<glm::dvec3> TomlTable::vector(const char* key) {
  const auto v = numbers(key, 3, any_coordinate);
  return v ? std::optional(glm::dvec3((*v)[0], (*v)[1], (*v)[2])) : std::nullopt;
}

std::optional<Rgb<double>> TomlTable::colour(const char* key, const Range& range) {
  const toml::node* value = table_->get(key);
  if (value && value->is_number()) return Rgb<double>(*number(key, range));
  if (value && !value->is_array())
    refuse(key, std::string(key) + " must be a colour: [red, green, blue], or one number for grey");
  const auto rgb = numbers(key, 3, range);
  return rgb ? std::optional(Rgb<double>((*rgb)[0], (*rgb)[1], (*rgb)[2])) : std::nullopt;
}

std::optional<TomlTable> TomlTable::table(const char* key, const std::string& what) {
  const toml::node* value = node(key);
  if (!value) return std::nullopt;
  if (!value->is_table()) refuse(key, std::string(key) + " must be a table");
  return TomlTable(*value->as_table(), file_, what);
}

std::vector<TomlTable> TomlTable::tables(const char* key) {
  const toml::node* value = node(key);
  if (!value) return {};
  const std::string brackets = "[[" + std::string(key) + "]]";
  const toml::array* array = value->as_array();
  if (!array) refuse(key, std::string(key) + " is a list: write " + brackets);
  std::vector<TomlTable> tables;
  for (const toml::node& element : *array) {
    if (!element.is_table())
      throw Error(place(element.source()), std::string(key) + " is a list of tables: " + brackets);
    tables.emplace_back(*element.as_table(), file_, brackets);
  }
  return tables;
}

std::vector<std::string> TomlTable::keys() const {
  using Place = std::tuple<toml::source_index, toml::source_index, std::string>;
  std::vector<Place> places;
  for (const auto& [key, value] : *table_)
    places.emplace_back(key.source().begin.line, key.source().begin.column, key.str());
  std::sort(places.begin(), places.end());
  std::vector<std::string> keys;
  keys.reserve(places.size());
  for (const Place& key : places) keys.push_back(std::get<std::string>(key));
  return keys;
}

void TomlTable::refuse_unknown_keys() const {
  for (const std::string& key : keys()) {
    if (std::find(known_keys_.begin(), known_keys_.end(), key) != known_keys_.end()) continue;
    throw Error(place(table_->find(key)->first.source()),
                "unknown key '" + key + "' in " + what_ + did_you_mean(key, known_keys_));
  }
}

}  // namespace scanlit::studio
