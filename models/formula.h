// What a model's file includes: the formula's vocabulary, its description, its registration.
//
// A model is a template over P, the type of its parameters: `double` where they are constant, and
// the type T of the cosines where they vary over the surface. So
//
//   template <class P = double>
//   struct Lambert {
//     Rgb<P> kd{0.8};
//     template <class T>
//     Reflection<T> operator()(const Cosines<T>& c) const { return {.diffuse = kd * c.n_l, ...}; }
//     static Description<Lambert> describe() { ... }
//   };
//   inline const Registered<Lambert<>> lambert_registered;
//
// Rgb times T takes care of the types; a number is written T(m). What follows from the parameters
// alone and costs something may be computed in a member `void prepare()`, called once where they
// are constant. Not a template, a model works as well, and its parameters are constant.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "models/formula_parameter.h"
#include "models/registry.h"
#include "models/varying_model.h"
#include "rasterizer/formula_model.h"

namespace scanlit::models {

template <class Formula>
struct Description {
  std::string name;
  int year;  // of publication
  std::string title;
  std::string source;
  bool reciprocal;
  bool energy_bounded;
  std::vector<Parameter<Formula>> parameters;
  std::string exceptions = "";  // to the two claims
  Kind kind = Kind::model;
};

template <class Formula>
ParameterInfo parameter_info(const Parameter<Formula>& p) {
  static const Formula initial{};
  ParameterInfo info{.key = p.key,
                     .min = p.min,
                     .max = p.max,
                     .choices = p.choices,
                     .meaning = p.meaning,
                     .only_with = p.only_with,
                     .varies = can_vary<Formula>};
  const auto set = [&](ParameterKind kind, Value value) {
    info.kind = kind, info.initial = std::move(value);
  };
  if (const auto* number = p.number()) set(ParameterKind::number, initial.**number);
  if (const auto* colour = p.colour()) set(ParameterKind::colour, initial.**colour);
  if (const auto* direction = p.direction()) set(ParameterKind::direction, initial.**direction);
  if (const auto* choice = p.choice())
    set(ParameterKind::choice, p.choices[std::size_t(initial.**choice)]), info.varies = false;
  return info;
}

/// A formula with the constant ones of its parameters set.
template <class Formula>
Formula make_formula(const Values& values) {
  static const std::vector<Parameter<Formula>> parameters = Formula::describe().parameters;
  Formula formula{};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::holds_alternative<std::shared_ptr<const Input>>(values[i].second))
      assign(formula, parameters[i], values[i].second);
  if constexpr (requires { formula.prepare(); }) formula.prepare();
  return formula;
}

template <class Formula>
std::shared_ptr<const ReflectionModel> make_formula_model(const Values& values) {
  Formula formula = make_formula<Formula>(values);
  if constexpr (can_vary<Formula>) {
    std::vector<Varying> varying;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (const auto* input = std::get_if<std::shared_ptr<const Input>>(&values[i].second))
        varying.push_back({i, *input});
    if (!varying.empty())
      return std::make_shared<VaryingModel<Formula>>(std::move(formula), std::move(varying));
  }
  return std::make_shared<FormulaModel<Formula>>(std::move(formula));
}

/// `inline const Registered<MyModel<>> my_model_registered;` at the end of a model's file puts it
/// into the registry of every program that includes the file, once.
template <class Formula>
struct Registered {
  Registered() {
    const Description<Formula> d = Formula::describe();
    ModelInfo info{.kind = d.kind,
                   .year = d.year,
                   .name = d.name,
                   .title = d.title,
                   .source = d.source,
                   .reciprocal = d.reciprocal,
                   .energy_bounded = d.energy_bounded,
                   .exceptions = d.exceptions};
    for (const auto& p : d.parameters) info.parameters.push_back(parameter_info(p));
    add(Entry{std::move(info), &make_model});
  }

 private:
  static NamedModel make_model(const ModelInfo& info, std::span<const Argument> arguments,
                               const Context& context) {
    Values values = read_values(context, info.parameters, arguments);
    auto model = make_formula_model<Formula>(values);
    return {.model = std::move(model), .values = std::move(values)};
  }
};

}  // namespace scanlit::models
