// The terms of a reflection model at a point under a light, named as in the lecture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "models/registry.h"
#include "rasterizer/pixel_record.h"

namespace scanlit::studio {

/// The braces' two parts as formulas, "Ks (N.H)^n"; of models without such a name the parts' names.
struct PartNames {
  std::string diffuse, glossy;
};
PartNames part_names(const models::NamedModel& model);

/// A parameter that varies over the surface, at a point: a number, or three channels.
struct ParameterHere {
  std::string key;
  std::vector<double> values;
};
std::vector<ParameterHere> varying_parameters(const models::NamedModel& model,
                                              const PointRecord& point);

/// D, G and F in double; none where the model is not made of them, or where light or viewer is
/// below the horizon.
struct Facets {
  double D, G;  // D in 1/sr
  Rgb<double> F;
};
std::optional<Facets> facets_at(const models::NamedModel& model, const PointRecord& point,
                                const LightRecord& light);

}  // namespace scanlit::studio
