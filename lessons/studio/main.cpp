// The program `scanlit`: meshes and scenes become pictures.
#include <vector>

#include "lessons/studio/commands.h"
#include "lessons/studio/program.h"
#include "lessons/studio/version.h"
#include "rasterizer/error.h"

namespace scanlit::studio {

std::function<void()> set_up(CLI::App& app) {
  app.description("Draws meshes with local reflection models, by scan conversion.");
  app.set_version_flag("--version", version_text);
  app.footer(
      "Example:\n"
      "  scanlit render teapot:16 -o teapot.png\n"
      "\n"
      "Each command explains itself: scanlit render --help");
  const std::vector<Command> commands{
      add_render_command(app),   add_frames_command(app),     add_sheet_command(app),
      add_reflect_command(app),  add_explain_command(app),    add_watch_command(app),
      add_tradeoff_command(app), add_assignment_command(app), add_check_command(app),
      add_grade_command(app),    add_models_command(app),     add_shapes_command(app)};
  return [commands] {
    for (const Command& command : commands)
      if (command.app->parsed()) return command.run();
    throw Error("no command; see scanlit --help");
  };
}

}  // namespace scanlit::studio

int main(int argc, char** argv) {
  return scanlit::studio::run_program("scanlit", argc, argv, scanlit::studio::set_up);
}
