// A scene in TOML becomes a Description. lessons/scenes/teapot.toml shows every key.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/studio/description.h"

namespace scanlit::studio {

/// A short scene, for `--help`.
extern const char* const scene_example;

/// A number, or a list of them, in place of what a scene file says. The path is the file's own:
/// camera.fov, light.0.intensity, object.1.translate.0, material.copper.model.n (whether the model
/// is written as text or as a table). What a table leaves out can be put there.
struct SceneChange {
  std::string path;
  std::vector<double> value;
};

/// Throws Error "scene.toml:12:5: unknown model 'blin-phong'; did you mean 'blinn-phong'?": no such
/// file, not a regular file or larger than 64 MiB; malformed TOML; an unknown key; a value of the
/// wrong type or out of range; a material nobody defined; no object at all; a change of what is not
/// there.
Description read_scene_file(const std::filesystem::path& file,
                            std::span<const SceneChange> changes = {});

/// The same from text; `file` names it in messages and its folder is where mesh files are looked
/// for.
Description read_scene(std::string_view text, const std::filesystem::path& file,
                       std::span<const SceneChange> changes = {});

}  // namespace scanlit::studio
