#include "lessons/studio/reflect/plane_of_incidence.h"

#include <algorithm>
#include <cmath>

#include "lessons/studio/reflect/query.h"
#include "lessons/studio/text.h"

namespace scanlit::studio {
namespace {

/// The plotted quantity over the viewing angle.
std::function<Rgb<double>(double)> lobe(const PlotRequest& request, const ReflectionModel& model,
                                        double light_deg) {
  const Vec3<double> l = direction_at(light_deg, request.azimuth_deg);
  const double scale = request.quantity == Quantity::brdf ? 1 / (std::numbers::pi * l.z) : 1;
  return [&model, l, scale, azimuth_deg = request.azimuth_deg](double view_deg) {
    return reflected(model, l, direction_at(-view_deg, azimuth_deg)) * scale;
  };
}

}  // namespace

std::string quantity_title(const PlotRequest& request) {
  if (std::ranges::all_of(request.models, is_part)) return find_info(request.models[0])->title;
  return request.quantity == Quantity::value ? "I = π f_r (n·l)" : "f_r [1/sr]";
}

SampleTable sample_lobes(const PlotRequest& request, const std::function<double(double)>& drawn) {
  // At exactly 90 degrees the viewer is not above the horizon.
  constexpr double widest_deg = 89.99;
  SampleTable samples;
  for (const models::NamedModel& named : request.models) {
    auto& of_model = samples.emplace_back();
    for (const double light_deg : request.light_angles_deg)
      of_model.push_back(sample(lobe(request, *named.model, light_deg), -widest_deg, widest_deg,
                                {light_deg, -light_deg}, drawn));
  }
  return samples;
}

double largest_value(const PlotRequest& request) {
  const auto samples = sample_lobes(request, [](double) { return 0.0; });
  const CurveSet set = make_curves(request.models, request.light_angles_deg, samples);
  return set.max > 0 ? set.max : 1;
}

std::string heading(const PlotRequest& request, const std::string& what) {
  if (request.models.size() == 1) return elided(request.models[0].specification, 70);
  const std::string number = std::to_string(request.models.size());
  if (std::ranges::all_of(request.models, is_part)) return number + " parts of reflection models";
  return what + " of " + number + " reflection models";
}

std::string remarks(const PlotRequest& request, const CurveSet& set) {
  std::string text;
  if (request.models.size() > 1 && request.light_angles_deg.size() == 1)
    text += "light at θ_l = " + text_of(request.light_angles_deg[0]) + "°";
  if (request.models.size() == 1 && set.channels_apart)
    text += "light at θ_l = " + text_of(request.light_angles_deg[0]) + "°";
  if (request.azimuth_deg != 0)
    text += (text.empty() ? "" : ", ") + std::string("azimuth φ_l = ") +
            text_of(request.azimuth_deg) + "° from the tangent";
  if (set.of_colour && !set.channels_apart)
    text += (text.empty() ? "" : ", ") + std::string("luminance of the three channels");
  return text;
}

}  // namespace scanlit::studio
