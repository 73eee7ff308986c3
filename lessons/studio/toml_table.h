// A TOML table read key by key, each value checked for type and range, each error with its place.
#pragma once

#include <toml++/toml.h>

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/studio/text.h"

namespace scanlit::studio {

/// Every getter returns nothing where the key is absent, throws Error where its value is not what
/// it should be, and remembers the key: what was never asked for is unknown.
class TomlTable {
 public:
  /// `what` names the table in messages: "[camera]". The toml::table must outlive this.
  TomlTable(const toml::table& table, std::string file, std::string what);

  /// "scene.toml:12:5", of the key's value, or of the table where the key is absent.
  std::string where(std::string_view key = {}) const;

  std::optional<std::string> text(const char* key);
  std::optional<double> number(const char* key, const Range& range);
  std::optional<int> integer(const char* key, const Range& range);
  std::optional<bool> boolean(const char* key);
  std::optional<std::vector<double>> numbers(const char* key, std::size_t count, const Range&);
  /// A square matrix as a list of rows; the result is row by row.
  std::optional<std::vector<double>> matrix(const char* key, std::size_t rows, const Range& range);
  std::optional<glm::dvec3> vector(const char* key);
  std::optional<Rgb<double>> colour(const char* key, const Range& range);  // one number, or three
  std::optional<TomlTable> table(const char* key, const std::string& what);
  std::vector<TomlTable> tables(const char* key);  // [[key]]

  template <class E>
  std::optional<E> choice(const char* key, const Choices<E>& choices) {
    const auto word = text(key);
    return word ? std::optional(choose(where(key), key, *word, choices)) : std::nullopt;
  }

  /// The raw value, for keys of several types.
  const toml::node* node(const char* key);

  /// In the order of the file.
  std::vector<std::string> keys() const;

  /// Throws at the first key that nobody asked for.
  void refuse_unknown_keys() const;

  /// Throws an Error at the key's value: "scene.toml:12:5: what".
  [[noreturn]] void refuse(std::string_view key, const std::string& what) const;

 private:
  std::string place(const toml::source_region& region) const;
  double finite_number(const char* key, const toml::node& value, const Range& range) const;
  void append_numbers(const char* key, const toml::node& list, std::size_t count,
                      const Range& range, std::vector<double>& numbers) const;

  const toml::table* table_;
  std::string file_, what_;
  std::vector<std::string> known_keys_;
};

}  // namespace scanlit::studio
