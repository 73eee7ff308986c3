// The options of `scanlit render`, and what each does to the picture described. Those that say what
// there is to see are those of `scanlit frames`, too.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "lessons/studio/description.h"
#include "lessons/studio/scene_file.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace scanlit::studio {

/// An option that changes the Description, given as `--name TEXT`; it applies to every object.
struct Edit {
  const char* group;
  const char* option;
  const char* type;  // "" for a flag
  const char* help;
  void (*apply)(Description&, const std::string& where, const std::string& text);
};

struct GivenEdit {
  const Edit* edit;
  std::string text;
};

struct SceneOptions {
  std::string input;
  std::vector<std::pair<const Edit*, CLI::Option*>> edits;

  std::vector<GivenEdit> given() const;
};

struct RenderOptions : SceneOptions {
  std::string output;
  std::vector<std::string> aovs;       // EXR files, and `aov_cost`
  std::vector<std::string> skips_off;  // names of skip_switches()
  bool stats = false;

  static constexpr const char* aov_cost = "cost";
  bool wants_cost_picture() const;
  std::vector<std::filesystem::path> aov_files() const;
  /// Throws Error where a name of skips_off is none.
  Skips skips() const;

  /// Where the picture goes: `output`, else the input's name with .png, in the current folder.
  std::filesystem::path output_file() const;
};

/// Whether the input is a scene file, and neither a mesh file nor a shape.
bool is_scene(const std::string& input);

/// What --skip-off takes: "outside-objects, ...".
std::string switch_names();

/// The scene file's picture with the changes, or one of the mesh or shape, and then the edits.
/// Throws Error where they do not fit.
Description describe(const std::string& input, std::span<const GivenEdit> edits,
                     std::span<const SceneChange> changes = {});

/// `options` must outlive the parsing of the command line.
void add_scene_options(CLI::App& app, SceneOptions& options);
void add_render_options(CLI::App& app, RenderOptions& options);

}  // namespace scanlit::studio
