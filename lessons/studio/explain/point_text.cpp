#include "lessons/studio/explain/point_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lessons/studio/explain/rows.h"
#include "lessons/studio/explain/terms.h"
#include "lessons/studio/text.h"

namespace scanlit::studio {
namespace {

/// Padded, so that another one may follow.
std::string text_of_angle(float cosine) {
  const double degrees = std::acos(std::clamp(double(cosine), -1.0, 1.0)) * 180 / std::numbers::pi;
  const std::string text = fixed(double(cosine), 5) + " (" + fixed(degrees, 1) + " deg)";
  return text + std::string(22 - std::min<std::size_t>(text.size(), 21), ' ');
}

/// The reflection model at one point.
class PointText {
 public:
  PointText(std::ostream& out, const Explanation& all, const FragmentRecord& fragment)
      : rows_(out), all_(all), fragment_(fragment), model_(all.model_of(fragment)) {}

  void point(const std::string& title, const PointRecord& point) const {
    rows_.title(title, xyz);
    rows_.vector("P", point.position, "world space");
    if (all_.object_of(fragment_).shading == Shading::phong)
      rows_.vector("N, interpolated", point.object_normal, "object space");
    rows_.vector("N", point.normal, "world space, normalised");
    rows_.vector("V", point.to_viewer, "towards the viewer");
    for (const auto& [key, values] : varying_parameters(model_, point))
      rows_.numbers(key, values, "varies: here");
    for (std::size_t k = 0; k < point.lights.size(); ++k) light(k, point);
  }

 private:
  void light(std::size_t k, const PointRecord& point) const {
    const LightRecord& light = point.lights[k];
    const std::string number = std::to_string(k);
    rows_.vector("L" + number, light.to_light, "towards light " + number + ", " + described(k));
    if (!(light.n_l > 0) || light.share == 0) {
      rows_.text("", light.n_l > 0 ? "out of its cone: it adds nothing"
                                   : "N.L = " + short_text(double(light.n_l), 4) +
                                         ": behind the surface, it adds nothing");
      return;
    }
    rows_.vector("H" + number, light.half_way, "half-way between L and V");
    rows_.text("angles", "N.L " + text_of_angle(light.n_l) + "N.V " + text_of_angle(light.n_v));
    rows_.text("", "N.H " + text_of_angle(light.n_h) + "V.H " + text_of_angle(light.v_h));
    if (const auto facets = facets_at(model_, point, light)) {
      const Rgb<double>& F = facets->F;
      rows_.text("D, G", short_text(facets->D) + " /sr, " + short_text(facets->G) +
                             "   (D, G and F are evaluated once more, in double)");
      rows_.numbers("F(V.H)", {F.r, F.g, F.b});
    }
    const PartNames names = part_names(model_);
    part(names.diffuse, light.braces.diffuse, light.radiance.diffuse, light.diffuse_light, light);
    part(names.glossy, light.braces.glossy, light.radiance.glossy, light.glossy_light, light);
  }

  /// One of the braces' two, and what it makes of the light.
  void part(const std::string& name, const Rgb<float>& value, const Rgb<float>& radiance,
            const Rgb<float>& colour, const LightRecord& light) const {
    const bool unit = colour == Rgb<float>(1) && light.share == 1;
    rows_.colour(name, value, unit ? "x light 1" : "");
    if (!unit) rows_.colour("  x light", radiance, light_text(colour, light));
  }

  static std::string light_text(const Rgb<float>& colour, const LightRecord& light) {
    const std::string text = "x " + colour_text(colour);
    return light.share == 1 ? text : text + " x " + short_text(double(light.share), 4);
  }

  static std::string colour_text(const Rgb<float>& c) {
    const std::string red = short_text(double(c.r), 4);
    if (c.r == c.g && c.g == c.b) return red;
    return red + "/" + short_text(double(c.g), 4) + "/" + short_text(double(c.b), 4);
  }

  std::string described(std::size_t k) const {
    const Light& light = all_.scene.lights[k];
    for (const auto& [name, kind] : light_kinds)
      if (kind == light.kind) return name;
    return "";
  }

  Rows rows_;
  const Explanation& all_;
  const FragmentRecord& fragment_;
  const models::NamedModel& model_;
};

}  // namespace

void print_points(std::ostream& out, const Explanation& all, const FragmentRecord& f) {
  const PointText text(out, all, f);
  switch (all.object_of(f).shading) {
    case Shading::phong: return text.point("Point, at the pixel", f.points[0]);
    case Shading::flat: return text.point("Point, the face's centroid", f.points[0]);
    case Shading::gouraud: break;
  }
  for (std::size_t k = 0; k < 3; ++k)
    text.point(
        "Vertex " + std::string(1, char('A' + k)) + " = " + std::to_string(f.points[k].element),
        f.points[k]);
}

}  // namespace scanlit::studio
