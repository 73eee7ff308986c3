// A sum of models: sum:(MODEL),.5*(MODEL),...
//
// Reflectances add, each with a weight of at least 0. What a sum of several lobes reflects is at
// most the sum of what each reflects alone.
#pragma once

#include <memory>
#include <vector>

#include "models/registry.h"

namespace scanlit::models {

struct Term {
  double weight;
  std::shared_ptr<const ReflectionModel> model;
};

class Sum final : public ReflectionModel {
 public:
  explicit Sum(std::vector<Term> terms);

  /// What any of its terms needs; their parameter arrays one after another.
  Needs needs() const override { return needs_; }
  void evaluate_parameters(const PointSpan& points, float* const* out) const override;
  void evaluate(const DirectionSpan& in, const ReflectionSpan& out) const override;
  bool bounds(const BoundedCosines& in, BoundedReflection& out) const override;
  Reflection<double> evaluate(const Vec3<double>& l, const Vec3<double>& v,
                              const SurfacePoint<double>& point) const override;
  Reflection<float> evaluate(const Vec3<float>& l, const Vec3<float>& v,
                             const SurfacePoint<float>& point) const override;

 private:
  std::vector<Term> terms_;
  Needs needs_;
};

Entry sum_entry();
inline const bool sum_registered = add(sum_entry());

}  // namespace scanlit::models
