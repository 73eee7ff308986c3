// The list of reflection models, and from text to model: "blinn-phong:ks=.4,n=50".
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rasterizer/reflection_model.h"

namespace scanlit::models {

/// One parameter of a model, as `scanlit models` lists it.
struct ParameterInfo {
  std::string key;      // "ks"
  bool colour;          // RGB ("r/g/b", or one number for grey), else one number
  Rgb<double> initial;  // default; .r alone where it is one number
  double min, max;      // allowed, inclusive, per channel
  std::string meaning;  // "glossy reflectance"
};

/// What there is to know of a model before it is made.
struct ModelInfo {
  std::string name;     // "blinn-phong"
  std::string title;    // "Blinn-Phong (N.H)"
  std::string source;   // "Blinn 1977, Models of light reflection ..., eq. ..."
  bool reciprocal;      // f_r(l,v) = f_r(v,l)
  bool energy_bounded;  // directional albedo at most 1 for every allowed parameter
  std::vector<ParameterInfo> parameters;
};

/// All registered models, in the order of the registry.
const std::vector<ModelInfo>& list();

/// A model made from "NAME" or "NAME:key=value,...", and the values its parameters got.
struct NamedModel {
  std::string specification;
  std::shared_ptr<const ReflectionModel> model;
  std::vector<std::pair<std::string, Rgb<double>>> values;  // every parameter, in list() order
};

/// Throws Error: unknown model or key (with the nearest), a value that is no number or out of range
/// (with the range), a key given twice.
NamedModel make(std::string_view specification);

}  // namespace scanlit::models
