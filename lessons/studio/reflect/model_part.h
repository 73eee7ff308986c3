// D, G or F of a model that is made of them, alone.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "models/registry.h"

namespace scanlit::studio {

/// Whether the model is cook-torrance or torrance-sparrow, or a material of either.
bool has_parts(const models::NamedModel& model);

class ModelPart {
 public:
  /// `part` is distribution, masking or fresnel; `at_point` takes the place of the model's own
  /// arguments: what a parameter that varies is at one point.
  ModelPart(const models::NamedModel& whole, const std::string& part,
            std::span<const models::Argument> at_point = {});

  /// D is in 1/sr. Directions in the shading frame.
  Rgb<double> operator()(const Vec3<double>& l, const Vec3<double>& v) const {
    return model_->evaluate(l, v).glossy;
  }

 private:
  std::shared_ptr<const ReflectionModel> model_;
};

}  // namespace scanlit::studio
