// The commands of `scanlit`, one file each. Each adds itself to the program and returns what to do
// when it is called, which throws Error.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace scanlit::studio {

struct Command {
  CLI::App* app;
  std::function<void()> run;
};

Command add_render_command(CLI::App& program);
Command add_explain_command(CLI::App& program);
Command add_watch_command(CLI::App& program);
Command add_frames_command(CLI::App& program);
Command add_reflect_command(CLI::App& program);
Command add_tradeoff_command(CLI::App& program);
Command add_sheet_command(CLI::App& program);
Command add_models_command(CLI::App& program);
Command add_shapes_command(CLI::App& program);
// Of the program, not of the library: they need what is made of it (lessons/assignments).
Command add_assignment_command(CLI::App& program);
Command add_check_command(CLI::App& program);
Command add_grade_command(CLI::App& program);

}  // namespace scanlit::studio
