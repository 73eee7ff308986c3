#include <nlohmann/json.hpp>

#include "lessons/studio/tradeoff/answer.h"
#include "lessons/studio/tradeoff/page.h"
#include "lessons/studio/tradeoff/study_scene.h"

namespace scanlit::studio {
namespace {

using Json = nlohmann::ordered_json;

Json figures(const PixelErrors& errors) {
  return {{"pixels", errors.pixels},         {"differing_8bit", errors.differing},
          {"rms_steps", errors.rms_steps},   {"max_steps", errors.max_steps},
          {"rms_linear", errors.rms_linear}, {"max_linear", errors.max_linear}};
}

Json figures(const Measured& point) {
  return {{"series", point.series},
          {"label", point.label},
          {"triangles", point.triangles},
          {"default", point.is_default},
          {"ms", point.ms},
          {"frames", point.frames},
          {"interior", figures(point.error.interior)},
          {"silhouette", figures(point.error.silhouette)},
          {"peak_linear", point.error.peak},
          {"mean_flip", point.flip},
          {"pareto", point.pareto}};
}

Json figures(const ShadingCost& cost) {
  return {{"triangles", cost.triangles}, {"ms", cost.ms}, {"rms_steps", cost.steps}};
}

}  // namespace

std::string tradeoff_json(const std::vector<AxisResult>& axes) {
  Json all{{"machine", machine()},
           {"threads", 1},
           {"time", "median processor time of a frame, ms"},
           {"steps", "8-bit steps of sRGB, before rounding"},
           {"picture", {study_width, study_height}},
           {"default", {{"shape", study_shape}, {"model", study_model}, {"shading", "phong"}}},
           {"axes", Json::array()}};
  for (const AxisResult& axis : axes) {
    Json one{{"name", axis.name}, {"title", axis.title}, {"against", axis.truth}};
    if (const auto found = answer(axis)) {
      one["answer"] = {{"words", words(axis, *found)}, {"phong", figures(found->phong)}};
      if (found->gouraud) one["answer"]["gouraud"] = figures(*found->gouraud);
    }
    for (const Measured& point : axis.points) one["points"].push_back(figures(point));
    all["axes"].push_back(one);
  }
  return all.dump(1) + "\n";
}

}  // namespace scanlit::studio
