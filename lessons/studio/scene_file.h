// A scene in TOML becomes a Description. lessons/scenes/teapot.toml shows every key.
#pragma once

#include <filesystem>
#include <string_view>

#include "lessons/studio/description.h"

namespace scanlit::studio {

/// A short scene, for `--help`.
extern const char* const scene_example;

/// Throws Error "scene.toml:12:5: unknown model 'blin-phong'; did you mean 'blinn-phong'?": no such
/// file, not a regular file or larger than 64 MiB; malformed TOML; an unknown key; a value of the
/// wrong type or out of range; a material nobody defined; no object at all.
Description read_scene_file(const std::filesystem::path& file);

/// The same from text; `file` names it in messages and its folder is where mesh files are looked
/// for.
Description read_scene(std::string_view text, const std::filesystem::path& file);

}  // namespace scanlit::studio
