// scanlit models
#include <iostream>

#include "lessons/studio/commands.h"
#include "lessons/studio/table.h"
#include "lessons/studio/text.h"
#include "models/registry.h"

namespace scanlit::studio {
namespace {

void print_model(const models::ModelInfo& model) {
  std::cout << '\n' << model.name << ": " << model.title << '\n';
  print_wrapped(std::cout, model.source, "  ");
  std::vector<std::vector<std::string>> rows;
  for (const models::ParameterInfo& parameter : model.parameters)
    rows.push_back({parameter.key, parameter.colour ? "colour" : "number",
                    text_of(parameter.colour ? parameter.initial : Rgb(parameter.initial.r)),
                    text_of(parameter.min) + " to " + text_of(parameter.max), parameter.meaning});
  print_columns(std::cout, rows, "    ");
}

void list_models() {
  std::cout << "Reflection models, with each parameter's kind, default, range and meaning.\n";
  for (const models::ModelInfo& model : models::list()) print_model(model);
  std::cout << "\nA colour is r/g/b, linear, or one number for grey. Example:\n"
               "  scanlit render teapot --model blinn-phong:kd=.6/.3/.2,n=50\n";
}

}  // namespace

Command add_models_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("models", "Lists the reflection models");
  app->footer("Example:\n  scanlit models");
  return {app, list_models};
}

}  // namespace scanlit::studio
