// Helmholtz reciprocity, f_r(l, v) = f_r(v, l), and by how much a model breaks it.
#pragma once

#include "rasterizer/reflection_model.h"

namespace scanlit::studio {

struct Violation {
  double relative =
      0;  // |f_r(l,v) - f_r(v,l)| / max of the two, of the channel where it is largest
  Vec3<double> l, v;
  Rgb<double> forward, backward;  // f_r(l,v), f_r(v,l); 1/sr
};

/// Nearer to the horizon a model is not asked: there n.v is held above min_n_v (reflection_model.h)
/// and n.l is not, which no model can help.
constexpr double least_cosine = 1e-3;

/// The largest found among 20,000 pairs of directions, spread by a seeded generator over the
/// hemisphere, to grazing and about the mirror direction, and by small steps from the worst of
/// them. Values below 1e-9 of the model's largest are taken for 0.
Violation worst_violation(const ReflectionModel& model);

}  // namespace scanlit::studio
