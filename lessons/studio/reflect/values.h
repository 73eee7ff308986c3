// A model's values for given directions, in each of the three precisions it has.
#pragma once

#include <span>
#include <vector>

#include "lessons/studio/reflect/rows.h"
#include "rasterizer/reflection_model.h"

namespace scanlit::studio {

/// batch: float, whole spans in one call, as the renderer does it.
enum class Precision { double_, float_, batch };

/// pi f_r (n.l), diffuse and glossy together, for each row; the surface point is the origin of
/// object space, with texture coordinates 0 and a white vertex colour. A viewer below the horizon
/// gives 0 in all precisions.
std::vector<Rgb<double>> evaluate_rows(const ReflectionModel& model,
                                       std::span<const DirectionRow> rows, Precision precision);

}  // namespace scanlit::studio
