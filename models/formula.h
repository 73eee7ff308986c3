// What a model's file includes: the formula's vocabulary, its description, its registration.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "models/registry.h"
#include "rasterizer/formula_model.h"

namespace scanlit::models {

/// A parameter: its key, the member that holds it (one number, or RGB), the allowed range
/// (inclusive, per channel), its meaning. The member's initial value is the default.
template <class Formula>
struct Parameter {
  std::string key;
  std::variant<double Formula::*, Rgb<double> Formula::*> member;
  double min, max;
  std::string meaning;
};

template <class Formula>
struct Description {
  std::string name;
  std::string title;
  std::string source;
  bool reciprocal;
  bool energy_bounded;
  std::vector<Parameter<Formula>> parameters;
};

using Values = std::vector<std::pair<std::string, Rgb<double>>>;

/// A model's entry in the registry: what it is, and how to make it from values that were checked
/// against its parameters (all of them, in their order).
struct Entry {
  ModelInfo info;
  std::shared_ptr<const ReflectionModel> (*make)(const Values& values);
};
void add(Entry entry);

template <class Formula>
std::shared_ptr<const ReflectionModel> make_formula_model(const Values& values) {
  static const Description<Formula> description = Formula::describe();
  Formula formula;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto& member = description.parameters[i].member;
    if (const auto* number = std::get_if<double Formula::*>(&member))
      formula.** number = values[i].second.r;
    else
      formula.*std::get<Rgb<double> Formula::*>(member) = values[i].second;
  }
  return std::make_shared<FormulaModel<Formula>>(std::move(formula));
}

/// `inline const Registered<MyModel> my_model_registered;` at the end of a model's file puts it
/// into the registry of every program that includes the file, once.
template <class Formula>
struct Registered {
  Registered() {
    Description<Formula> d = Formula::describe();
    ModelInfo info{d.name, d.title, d.source, d.reciprocal, d.energy_bounded, {}};
    const Formula initial;
    for (const Parameter<Formula>& p : d.parameters) {
      const auto* number = std::get_if<double Formula::*>(&p.member);
      const auto value = number ? Rgb<double>(initial.**number)
                                : initial.*std::get<Rgb<double> Formula::*>(p.member);
      info.parameters.push_back({p.key, !number, value, p.min, p.max, p.meaning});
    }
    add({std::move(info), &make_formula_model<Formula>});
  }
};

}  // namespace scanlit::models
