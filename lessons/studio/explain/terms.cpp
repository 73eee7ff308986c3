#include "lessons/studio/explain/terms.h"

#include <algorithm>

#include "lessons/studio/reflect/model_part.h"
#include "lessons/studio/reflect/query.h"
#include "lessons/studio/text.h"
#include "models/materials.h"

namespace scanlit::studio {
namespace {

std::string name_of(const models::NamedModel& model) {
  return models::parse_specification(models::model_behind(model.specification)).name;
}

/// Whether a choice or number of the model is set to this.
bool is(const models::NamedModel& model, const char* key, const std::string& word) {
  const auto* text = std::get_if<std::string>(&models::value_of(model.values, key));
  return text && *text == word;
}

}  // namespace

PartNames part_names(const models::NamedModel& model) {
  const std::string name = name_of(model);
  if (name == "lambert") return {"Kd (N.L)", "none"};
  if (name == "phong") return {"Kd (N.L)", "Ks (R.V)^n"};
  if (name == "blinn-phong" && is(model, "normalised", "0")) return {"Kd (N.L)", "Ks (N.H)^n"};
  if (name == "torrance-sparrow") return {"Kd (N.L)", "Ks pi/4 D G F / (N.V)"};
  if (name == "cook-torrance")
    return {"Kd (N.L)",
            is(model, "form", "lecture") ? "Ks D/D(N) G F / (N.V)" : "Ks pi/4 D G F / (N.V)"};
  return {"diffuse", "glossy"};
}

std::vector<ParameterHere> varying_parameters(const models::NamedModel& model,
                                              const PointRecord& point) {
  std::vector<ParameterHere> varying;
  const models::ModelInfo* info = find_info(name_of(model));
  auto next = point.parameters.begin();
  for (const auto& [key, value] : model.values) {
    if (!std::holds_alternative<std::shared_ptr<const models::Input>>(value)) continue;
    const auto p = std::ranges::find(info->parameters, key, &models::ParameterInfo::key);
    const auto end = next + (p->kind == models::ParameterKind::number ? 1 : 3);
    varying.push_back({key, {next, end}});
    next = end;
  }
  return varying;
}

std::optional<Facets> facets_at(const models::NamedModel& model, const PointRecord& point,
                                const LightRecord& light) {
  const Vec3<double>&l = light.to_light_local, &v = light.to_viewer_local;
  if (!has_parts(model) || !(l.z > 0) || !(v.z > 0)) return std::nullopt;
  std::vector<models::Argument> here;
  for (const auto& [key, values] : varying_parameters(model, point)) {
    here.push_back({key, ""});
    for (const double value : values)
      here.back().value += (here.back().value.empty() ? "" : "/") + text_of(value);
  }
  const ModelPart D(model, "distribution", here), G(model, "masking", here),
      F(model, "fresnel", here);
  return Facets{D(l, v).r, G(l, v).r, F(l, v)};
}

}  // namespace scanlit::studio
