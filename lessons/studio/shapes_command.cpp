// scanlit shapes
#include <iostream>

#include "lessons/studio/commands.h"
#include "lessons/studio/table.h"
#include "rasterizer/shapes.h"

namespace scanlit::studio {
namespace {

void list_shapes() {
  std::cout << "Built-in shapes: NAME, or NAME:N with N the tessellation.\n\n";
  std::vector<std::vector<std::string>> rows{{"NAME", "N", "RANGE OF N", "WHAT IT IS"}};
  for (const ShapeInfo& shape : shapes())
    rows.push_back(
        {shape.name, std::to_string(shape.default_tessellation),
         std::to_string(shape.min_tessellation) + " to " + std::to_string(shape.max_tessellation),
         shape.description + "; N: " + shape.parameter});
  print_columns(std::cout, rows, "  ");
  std::cout << "\nThe second column is the N of a bare NAME. Example:\n"
               "  scanlit render torus:48\n";
}

}  // namespace

Command add_shapes_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("shapes", "Lists the built-in shapes");
  app->footer("Example:\n  scanlit shapes");
  return {app, list_shapes};
}

}  // namespace scanlit::studio
