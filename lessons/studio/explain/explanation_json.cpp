#include <nlohmann/json.hpp>

#include "lessons/studio/explain/explanation.h"
#include "lessons/studio/explain/terms.h"
#include "lessons/studio/text.h"

namespace scanlit::studio {
namespace {

using Json = nlohmann::ordered_json;  // the derivation's order

template <class T>
Json json_of(const Vec3<T>& v) {
  return {v.x, v.y, v.z};
}
template <class T>
Json json_of(const Rgb<T>& c) {
  return {c.r, c.g, c.b};
}

Json json_of(const LightRecord& light, const models::NamedModel& model, const PointRecord& point) {
  Json json{{"L", json_of(light.to_light)},
            {"H", json_of(light.half_way)},
            {"N.L", light.n_l},
            {"N.V", light.n_v},
            {"N.H", light.n_h},
            {"V.H", light.v_h}};
  if (const auto facets = facets_at(model, point, light))
    json.update(Json{{"D", facets->D}, {"G", facets->G}, {"F", json_of(facets->F)}});
  json.update(
      Json{{"braces",
            {{"diffuse", json_of(light.braces.diffuse)}, {"glossy", json_of(light.braces.glossy)}}},
           {"share", light.share},
           {"light",
            {{"diffuse", json_of(light.diffuse_light)}, {"glossy", json_of(light.glossy_light)}}},
           {"radiance",
            {{"diffuse", json_of(light.radiance.diffuse)},
             {"glossy", json_of(light.radiance.glossy)}}}});
  return json;
}

Json json_of(const PointRecord& point, const models::NamedModel& model) {
  Json json{{"element", point.element},
            {"P", json_of(point.position)},
            {"N_object", json_of(point.object_normal)},
            {"N", json_of(point.normal)},
            {"V", json_of(point.to_viewer)}};
  for (const auto& [key, values] : varying_parameters(model, point))
    json["parameters"][key] = values;
  json["lights"] = Json::array();
  for (const LightRecord& light : point.lights)
    json["lights"].push_back(json_of(light, model, point));
  json.update(Json{{"ambient", json_of(point.ambient)},
                   {"diffuse", json_of(point.diffuse)},
                   {"glossy", json_of(point.glossy)},
                   {"colour", json_of(point.colour)}});
  return json;
}

Json json_of(const FragmentRecord& f, const Explanation& all) {
  const Object& object = all.object_of(f);
  const models::NamedModel& model = all.model_of(f);
  Json json{{"object", f.object},           {"name", object.name},
            {"model", model.specification}, {"triangle", f.triangle},
            {"back_facing", f.back_facing}, {"clipped", f.clipped}};
  for (const auto& [name, shading] : shadings)
    if (shading == object.shading) json["shading"] = name;
  for (const ScreenVertex& v : f.screen.vertices)
    json["corners"].push_back({{"x_px", double(v.x) / subpixel},
                               {"y_px", double(v.y) / subpixel},
                               {"depth", v.depth},
                               {"1/w", v.inv_w}});
  json.update(Json{{"span", {f.x_begin, f.x_end}},
                   {"barycentric", {1 - f.b1 - f.b2, f.b1, f.b2}},
                   {"weight", f.weight}});
  for (const PointRecord& point : f.points) json["points"].push_back(json_of(point, model));
  json.update(Json{{"ambient", json_of(f.ambient)},
                   {"diffuse", json_of(f.diffuse)},
                   {"glossy", json_of(f.glossy)},
                   {"colour", json_of(f.colour)}});
  return json;
}

Json json_of(const SampleRecord& sample) {
  Json layers = Json::array();
  for (const LayerRecord& layer : sample.layers)
    layers.push_back(
        {{"object", layer.object}, {"triangle", layer.triangle}, {"depth", layer.depth}});
  return {{"offset_px", {double(sample.offset.x) / subpixel, double(sample.offset.y) / subpixel}},
          {"layers", layers}};
}

}  // namespace

void print_explanation_json(std::ostream& out, const Explanation& all) {
  const PixelRecord& record = all.record;
  Json json{{"input", all.input},
            {"pixel", {record.x, record.y}},
            {"size", {all.picture().width, all.picture().height}}};
  json["samples"] = Json::array(), json["fragments"] = Json::array();
  for (const SampleRecord& sample : record.samples) json["samples"].push_back(json_of(sample));
  for (const FragmentRecord& f : record.fragments) json["fragments"].push_back(json_of(f, all));
  const Codes codes = codes_of(record.colour, all.picture().image);
  json.update(Json{{"covered", record.covered},
                   {"background", json_of(all.scene.background)},
                   {"linear", record.colour},
                   {"encoded", {codes.r, codes.g, codes.b}}});
  out << json.dump(2, ' ', true, Json::error_handler_t::replace) << '\n';
}

}  // namespace scanlit::studio
