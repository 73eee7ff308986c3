// The program `scanlit`: meshes and scenes become pictures.
#include <vector>

#include "lessons/studio/commands.h"
#include "lessons/studio/program.h"
#include "rasterizer/error.h"

int main(int argc, char** argv) {
  using namespace scanlit::studio;
  CLI::App app("Draws meshes with local reflection models, by scan conversion.", "scanlit");
  app.set_version_flag("--version", "scanlit " SCANLIT_VERSION);
  app.footer(
      "Example:\n"
      "  scanlit render teapot:16 -o teapot.png\n"
      "\n"
      "Each command explains itself: scanlit render --help");
  const std::vector<Command> commands{add_render_command(app), add_models_command(app),
                                      add_shapes_command(app)};
  return run_program(app, argc, argv, [&] {
    for (const Command& command : commands)
      if (command.app->parsed()) return command.run();
    throw scanlit::Error("no command; see scanlit --help");
  });
}
