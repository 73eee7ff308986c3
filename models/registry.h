// The list of reflection models, and from text to model: "blinn-phong:ks=.4,n=50".
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/parameter.h"
#include "rasterizer/scene.h"

namespace scanlit::models {

/// model: a reflection model. part: a factor of one (D, G or F), which can be drawn and queried
/// alone and is no reflection. input: what a parameter may be that varies over the surface.
enum class Kind { model, part, input };

/// What there is to know of a model before it is made.
struct ModelInfo {
  Kind kind = Kind::model;
  int year = 0;                 // of its publication: the order of the list
  std::string name{};           // "blinn-phong"
  std::string title{};          // "Blinn-Phong (N.H)"
  std::string source{};         // "Blinn 1977, Models of light reflection ..., eq. ..."
  bool reciprocal = false;      // f_r(l,v) = f_r(v,l) for every allowed parameter
  bool energy_bounded = false;  // directional albedo at most 1 for every allowed parameter
  std::string exceptions{};     // to these claims, in words: "form=lecture is neither"
  std::string example{};        // a specification, where the name alone is none
  std::vector<ParameterInfo> parameters{};
};

/// All registered models and parts, by year; all inputs.
const std::vector<ModelInfo>& list();
const std::vector<ModelInfo>& list_inputs();

/// A model made from "NAME" or "NAME:key=value,...", and the values its parameters got.
struct NamedModel {
  std::string specification{};  // as make() was given it, which sets it
  std::shared_ptr<const ReflectionModel> model;
  Values values{};                     // every parameter, in list() order
  std::optional<Tangents> tangents{};  // where a named material brings its own
};

/// Relative files are looked for in `folder`. Throws Error: unknown model or key (with the
/// nearest), a value that is no number or out of range (with the range), a key given twice.
NamedModel make(std::string_view specification, const std::filesystem::path& folder = {});
/// The same for a specification within another; `context.depth` is the other's.
NamedModel make(std::string_view specification, const Context& context);

/// "image(cow.png)". Throws Error likewise.
std::shared_ptr<const Input> make_input(std::string_view call, const Context& context);
bool is_input(std::string_view text);

/// A model's entry in the registry. Most are made by Registered (models/formula.h) from a formula;
/// `make` is given the arguments as they were written.
struct Entry {
  ModelInfo info;
  NamedModel (*make)(const ModelInfo& info, std::span<const Argument> arguments,
                     const Context& context);
};
struct InputEntry {
  ModelInfo info;
  std::shared_ptr<const Input> (*make)(const Values& values);
};
bool add(Entry entry);
bool add(InputEntry entry);

}  // namespace scanlit::models
