// The options of `scanlit render`, and what each does to the picture described.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "lessons/studio/description.h"

namespace scanlit::studio {

/// An option that changes the Description, given as `--name TEXT`; it applies to every object.
struct Edit {
  const char* group;
  const char* option;
  const char* type;  // "" for a flag
  const char* help;
  void (*apply)(Description&, const std::string& where, const std::string& text);
};

struct RenderOptions {
  std::string input, output, aov;
  bool stats = false;
  std::vector<std::pair<const Edit*, CLI::Option*>> edits;

  /// Where the picture goes: `output`, else the input's name with .png, in the current folder.
  std::filesystem::path output_file() const;

  /// The scene file's picture, or one of the mesh or shape, with the options given applied to it.
  Description describe() const;
};

/// `options` must outlive the parsing of the command line.
void add_render_options(CLI::App& app, RenderOptions& options);

}  // namespace scanlit::studio
