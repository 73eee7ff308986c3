#include "lessons/studio/reflect/model_part.h"

#include <algorithm>

#include "lessons/studio/reflect/query.h"
#include "models/materials.h"

namespace scanlit::studio {

bool has_parts(const models::NamedModel& model) {
  const std::string name =
      models::parse_specification(models::model_behind(model.specification)).name;
  return name == "cook-torrance" || name == "torrance-sparrow";
}

ModelPart::ModelPart(const models::NamedModel& whole, const std::string& part,
                     std::span<const models::Argument> at_point) {
  const models::Specification given =
      models::parse_specification(models::model_behind(whole.specification));
  std::string arguments;
  for (const models::ParameterInfo& p : find_info(part)->parameters) {
    const auto here = std::ranges::find(at_point, p.key, &models::Argument::key);
    const auto written = std::ranges::find(given.arguments, p.key, &models::Argument::key);
    std::string value;
    if (here != at_point.end())
      value = here->value;
    else if (written != given.arguments.end())
      value = written->value;
    else if (p.kind == models::ParameterKind::choice)  // the model's default, not the part's
      value = std::get<std::string>(models::value_of(whole.values, p.key));
    if (!value.empty()) arguments += (arguments.empty() ? ":" : ",") + p.key + "=" + value;
  }
  model_ = models::make(part + arguments).model;
}

}  // namespace scanlit::studio
