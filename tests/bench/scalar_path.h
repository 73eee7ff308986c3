// The rival: the same formulas, point by point in scalar float, compiled without vectorisation.
#pragma once

#include <functional>
#include <string>

#include "rasterizer/lighting.h"

namespace scanlit::bench {

struct ScalarPath {
  /// What FormulaModel::evaluate does with a span.
  std::function<void(const DirectionSpan&, const ReflectionSpan&)> evaluate;
  /// What light() does with a span seen in perspective, of a formula that needs no frame and no
  /// surface point, under one directional light in colour form 1.
  std::function<void(const Frame&, const Draw&, SurfaceSpan&, LitSpan&)> light;
};

/// For a model of the registry that is one formula with constant parameters.
ScalarPath scalar_path(const std::string& specification);

}  // namespace scanlit::bench
