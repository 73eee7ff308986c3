// Inputs: what a parameter is where it varies over the surface. An image, a vertex attribute, a
// procedural function of the surface point.
//
// A procedural input is a formula of the surface point, written once as a template over its scalar:
//
//   struct Checker {
//     Rgb<double> a{0.8}, b{0.2};
//     double scale = 8;
//     template <class T>
//     Rgb<T> operator()(const SurfacePoint<T>& p) const { ... }
//     static InputDescription<Checker> describe() { ... }
//   };
//   inline const RegisteredInput<Checker> checker_registered;
//
// and is registered by its file being included in models/catalogue_inputs.cpp. evaluate() calls it
// in Batch, so that there is no `if` on a T here either.
//
// A parameter that is one number takes the first channel; a direction takes the three channels as
// x, y, z in object space, of any length.
#pragma once

#include "models/formula.h"

namespace scanlit::models {

template <class Function>
struct InputDescription {
  std::string name;
  std::string title;
  std::string source;  // author, year; "" where there is none to name
  std::vector<Parameter<Function>> parameters;
};

template <class Function>
class ProceduralInput final : public Input {
 public:
  explicit ProceduralInput(Function function) : function_(std::move(function)) {}

  void evaluate(const PointSpan& points, std::size_t channels, float* const* out) const override {
    for (std::size_t i = 0; i < points.size; i += Batch::lanes) {
      const Rgb<Batch> value = function_(load_point(points, i));
      const Batch* all[3] = {&value.r, &value.g, &value.b};
      for (std::size_t c = 0; c < channels; ++c) all[c]->store(out[c] + i);
    }
  }

 private:
  Function function_;
};

template <class Function>
struct RegisteredInput {
  RegisteredInput() {
    const InputDescription<Function> d = Function::describe();
    ModelInfo info;
    info.kind = Kind::input, info.name = d.name, info.title = d.title, info.source = d.source;
    for (const auto& p : d.parameters) info.parameters.push_back(parameter_info(p));
    add(InputEntry{std::move(info), [](const Values& values) -> std::shared_ptr<const Input> {
                     Function function{};
                     const auto parameters = Function::describe().parameters;
                     for (std::size_t i = 0; i < values.size(); ++i)
                       assign(function, parameters[i], values[i].second);
                     if constexpr (requires { function.prepare(); }) function.prepare();
                     return std::make_shared<ProceduralInput<Function>>(std::move(function));
                   }});
  }
};

}  // namespace scanlit::models
