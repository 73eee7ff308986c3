// scanlit models
#include <iostream>
#include <memory>

#include "lessons/studio/commands.h"
#include "lessons/studio/table.h"
#include "lessons/studio/text.h"
#include "models/materials.h"
#include "models/registry.h"
#include "rasterizer/error.h"

namespace scanlit::studio {
namespace {

std::string kind_of(const models::ParameterInfo& parameter) {
  static constexpr const char* words[] = {"number", "colour", "direction", "choice",
                                          "file",   "model",  "group"};
  return words[int(parameter.kind)];
}

std::string initial_of(const models::ParameterInfo& parameter) {
  if (const auto* number = std::get_if<double>(&parameter.initial)) return text_of(*number);
  if (const auto* colour = std::get_if<Rgb<double>>(&parameter.initial)) return text_of(*colour);
  if (const auto* d = std::get_if<Vec3<double>>(&parameter.initial))
    return text_of(d->x) + '/' + text_of(d->y) + '/' + text_of(d->z);
  if (const auto* text = std::get_if<std::string>(&parameter.initial)) return *text;
  return "";
}

std::string allowed_for(const models::ParameterInfo& parameter) {
  const bool has_range = parameter.kind == models::ParameterKind::number ||
                         parameter.kind == models::ParameterKind::colour;
  return has_range ? text_of(parameter.min) + " to " + text_of(parameter.max) : "";
}

/// What it means, the words of a choice, and where it has a meaning.
std::string explanation_of(const models::ParameterInfo& parameter) {
  std::string text = parameter.meaning;
  for (const std::string& word : parameter.choices)
    text += (word == parameter.choices.front() ? ": " : ", ") + word;
  return text + (parameter.only_with.empty() ? "" : " (with " + parameter.only_with + ")");
}

void print_parameters(const models::ModelInfo& model) {
  std::vector<std::vector<std::string>> rows;
  for (const models::ParameterInfo& parameter : model.parameters)
    rows.push_back({parameter.key, kind_of(parameter), initial_of(parameter),
                    allowed_for(parameter), explanation_of(parameter)});
  print_columns(std::cout, rows, "    ");
}

void print_model(const models::ModelInfo& model) {
  std::cout << '\n' << model.name << ": " << model.title << '\n';
  if (!model.source.empty()) print_wrapped(std::cout, model.source, "  ");
  if (model.kind == models::Kind::model)
    print_wrapped(std::cout,
                  std::string(model.reciprocal ? "reciprocal, " : "not reciprocal, ") +
                      (model.energy_bounded ? "energy-bounded" : "not energy-bounded") +
                      (model.exceptions.empty() ? "" : "; " + model.exceptions),
                  "  ");
  print_parameters(model);
  if (!model.example.empty()) std::cout << "    for example " << model.example << '\n';
}

void print_material(const models::NamedMaterial& material) {
  std::cout << '\n' << material.name << ": " << material.source << '\n';
  print_wrapped(std::cout, material.specification, "    ");
}

void list_models() {
  std::cout << "Reflection models, with each parameter's kind, default, range and meaning.\n";
  for (const models::ModelInfo& model : models::list())
    if (model.kind == models::Kind::model) print_model(model);
  std::cout << "\nFactors of models, which can be drawn and queried alone.\n";
  for (const models::ModelInfo& model : models::list())
    if (model.kind == models::Kind::part) print_model(model);
  std::cout
      << "\nInputs: what a number, colour or direction may be that varies over the surface.\n";
  for (const models::ModelInfo& input : models::list_inputs()) print_model(input);
  std::cout
      << "\nMaterials: material:NAME is the model after it; material:NAME,key=value changes one.\n";
  for (const models::NamedMaterial& material : models::materials()) print_material(material);
  std::cout << "\nA colour is r/g/b, linear, or one number for grey. Example:\n"
               "  scanlit render teapot --model blinn-phong:kd=.6/.3/.2,n=50\n";
}

/// One model, part, input or material.
void print_named(const std::string& name) {
  std::vector<std::string> names;
  for (const auto* infos : {&models::list(), &models::list_inputs()})
    for (const models::ModelInfo& info : *infos) {
      if (info.name == name) return print_model(info);
      names.push_back(info.name);
    }
  for (const models::NamedMaterial& material : models::materials()) {
    if (material.name == name) return print_material(material);
    names.push_back(material.name);
  }
  throw Error("unknown model '" + name + "'" + did_you_mean(name, names));
}

}  // namespace

Command add_models_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("models", "Lists the reflection models");
  const auto name = std::make_shared<std::string>();
  app->add_option("NAME", *name, "one model, part, input or material (all of them)");
  app->footer("Example:\n  scanlit models cook-torrance");
  return {app, [name] { name->empty() ? list_models() : print_named(*name); }};
}

}  // namespace scanlit::studio
