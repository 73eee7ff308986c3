// The rival: the same formulas, point by point in scalar float, compiled without vectorisation.
// Made for BlinnPhong, Phong and Lambert.
#pragma once

#include "rasterizer/lighting.h"

namespace scanlit::bench {

/// What FormulaModel<Formula>::evaluate does with a span.
template <class Formula>
void evaluate_scalar(const Formula& formula, const DirectionSpan& in, const ReflectionSpan& out);

/// What light() does with a span seen in perspective, of a formula that needs no frame and no
/// surface point, under one directional light in colour form 1.
template <class Formula>
void light_scalar(const Formula& formula, const Frame& frame, const Draw& draw,
                  SurfaceSpan& surface, LitSpan& lit);

}  // namespace scanlit::bench
