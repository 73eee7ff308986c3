// The parts of a scene file, each read from its table; scene_file.cpp puts them together.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "lessons/studio/description.h"
#include "lessons/studio/scene_file.h"
#include "lessons/studio/toml_table.h"

namespace scanlit::studio {

using Materials = std::map<std::string, MaterialDescription>;

Light read_light(TomlTable table);
MaterialDescription read_material(TomlTable table, const std::filesystem::path& folder);
ObjectDescription read_object(TomlTable table, const Materials& materials,
                              const std::filesystem::path& folder);

/// Throws Error where the path leads nowhere; whether the value may stand there, the reader says.
void apply(const SceneChange& change, toml::table& root);

/// A key that is absent leaves its default.
template <class T>
void set(T& target, const std::optional<T>& value) {
  if (value) target = *value;
}

}  // namespace scanlit::studio
