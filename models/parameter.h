// Parameters of models and inputs: what a value may be, and from text to checked values.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "models/specification.h"
#include "rasterizer/reflection_model.h"

namespace scanlit::models {

/// What a parameter is where it varies over the surface; models/input.h says how to write one.
class Input {
 public:
  virtual ~Input() = default;
  virtual bool needs_texcoord_derivatives() const { return false; }
  /// Writes `channels` arrays, 1 or 3, of points.size values; up to a whole vector.
  virtual void evaluate(const PointSpan& points, std::size_t channels, float* const* out) const = 0;
};

/// A number; linear RGB; a direction in the shading frame (x tangent, z normal), of any length; a
/// word of a choice or a file's path; another model; or, in place of one of the first three, an
/// input.
using Value = std::variant<double, Rgb<double>, Vec3<double>, std::string,
                           std::shared_ptr<const ReflectionModel>, std::shared_ptr<const Input>>;
using Values = std::vector<std::pair<std::string, Value>>;  // by key, in the parameters' order

/// group: several key=value in parentheses, which the model itself reads.
enum class ParameterKind { number, colour, direction, choice, file, model, group };

/// One parameter, as `scanlit models` lists it.
struct ParameterInfo {
  std::string key{};  // "ks"
  ParameterKind kind = ParameterKind::number;
  Value initial = 0.0;                 // default; an empty text or model: it must be given
  double min = 0, max = 0;             // number, colour: allowed, inclusive, per channel
  std::vector<std::string> choices{};  // choice: the words
  std::string meaning{};               // "glossy reflectance"
  std::string only_with{};  // "D=blinn|ggx": it has a meaning only where D is one of them
  bool varies = false;      // may be an input
};

/// Where a specification stands: for messages, and for files it names.
struct Context {
  std::string where;             // "model 'phong'"
  std::filesystem::path folder;  // what relative paths are relative to; empty: the current one
  int depth = 0;                 // of models within models
};

/// One value for each parameter: as given, or its default. Throws Error: unknown key (with the
/// nearest), a value that is not what the parameter wants, a key given twice, or given where
/// `only_with` says that it has no meaning, or missing where there is no default.
Values read_values(const Context& context, std::span<const ParameterInfo> parameters,
                   std::span<const Argument> arguments);

/// The value under `key`, which must be there.
const Value& value_of(const Values& values, std::string_view key);

/// A number as grey; a colour as it is. Throws std::bad_variant_access for other kinds.
Rgb<double> colour_of(const Value& value);

}  // namespace scanlit::models
