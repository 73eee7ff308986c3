#include "lessons/studio/reflect/metal_curves.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lessons/studio/reflect/query.h"
#include "lessons/studio/text.h"
#include "models/fresnel.h"
#include "rasterizer/error.h"
#include "rasterizer/image/image_encoding.h"

namespace scanlit::studio {
namespace {

double cosine(double angle_deg) { return std::max(0.0, std::cos(radians_of(angle_deg))); }

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

Curve curve_of(const std::function<double(double)>& f, double low, double high,
               const Stroke& stroke) {
  Curve curve{stroke, {}};
  const auto as_is = [](double value) { return value; };
  for (const Sample& s : sample([&](double x) { return Rgb<double>(f(x)); }, low, high, {}, as_is))
    curve.points.push_back({s.angle_deg, s.value.r});
  return curve;
}

/// From dark to bright, an order that print in grey keeps; the three colours are chosen by eye.
Rgb<double> ramp(double t) {
  const Rgb<double> dark(0.008, 0.01, 0.12), middle(0.45, 0.01, 0.13), bright(0.95, 0.42, 0.02);
  return t < 0.5 ? dark * (1 - 2 * t) + middle * (2 * t)
                 : middle * (2 - 2 * t) + bright * (2 * t - 1);
}

}  // namespace

const models::Metal& metal_of(const models::NamedModel& named) {
  const std::vector<std::string>& names = models::metal_names();
  const auto is_metal = [&](const std::string& word) {
    return std::ranges::find(names, word) != names.end();
  };
  for (const auto& [key, value] : named.values)
    if (const auto* word = std::get_if<std::string>(&value); word && is_metal(*word))
      return models::find_metal(*word);
  std::vector<std::string> having;
  for (const models::ModelInfo& info : models::list())
    for (const models::ParameterInfo& parameter : info.parameters)
      if (std::ranges::any_of(parameter.choices, is_metal))
        having.push_back(info.name + ":" + parameter.key + "=METAL");
  throw Error("--plot", "no spectrum is known of '" + named.specification + "'; of these it is: " +
                            joined(having) + ", where METAL is " + joined(names));
}

double reflectance_at(const models::Metal& metal, double wavelength_nm, double angle_deg) {
  return models::reflectance(metal, wavelength_nm, cosine(angle_deg));
}

Rgb<double> hue(double wavelength_nm) {
  // Further out chromaticity hardly changes, but the fit of the colour-matching functions, whose
  // tails alone are left there, would have it go round to green.
  const double nearest_nm = std::clamp(wavelength_nm, 440.0, 650.0);
  const Rgb<double> c =
      models::linear_srgb([=](double nm) { return std::abs(nm - nearest_nm) < 2.5 ? 1.0 : 0.0; });
  const double brightest = std::max({c.r, c.g, c.b});
  const auto shown = [=](double x) { return std::max(0.0, x / brightest); };
  return {shown(c.r), shown(c.g), shown(c.b)};
}

std::string screen_colour(const Rgb<double>& colour) {
  static const EightBitEncoder code(Encoding::srgb);
  char text[8];
  std::snprintf(text, sizeof text, "#%02X%02X%02X", code(float(colour.r)), code(float(colour.g)),
                code(float(colour.b)));
  return text;
}

MetalColours::MetalColours(const models::Metal& metal)
    : spectrum([&](double deg) { return models::spectral_rgb(metal, cosine(deg)); }),
      fit([f = models::MetalFresnel(metal)](double deg) { return f(cosine(deg)); }),
      schlick([f = models::SchlickFresnel<>{spectrum(0)}](double deg) { return f(cosine(deg)); }),
      fit_error(0) {
  for (double deg = 0; deg <= 90; deg += 0.25) {
    const Rgb<double> exact = spectrum(deg), fitted = fit(deg);
    for (const Channel& c : channels)
      fit_error =
          std::max(fit_error, std::abs(std::clamp(exact.*c.value, 0.0, 1.0) - fitted.*c.value));
  }
}

LabelledCurves curves_over_wavelength(const models::Metal& metal,
                                      const std::vector<double>& angles_deg) {
  LabelledCurves result;
  for (std::size_t i = 0; i < angles_deg.size(); ++i) {
    const double angle_deg = angles_deg[i];
    const double t = angles_deg.size() < 2 ? 0 : double(i) / double(angles_deg.size() - 1);
    const Stroke stroke{screen_colour(ramp(t)), curve_width};
    result.legend.push_back({"θ = " + text_of(angle_deg) + "°", stroke});
    result.curves.push_back(
        curve_of([&](double nm) { return reflectance_at(metal, nm, angle_deg); },
                 models::first_wavelength_nm, models::last_wavelength_nm, stroke));
  }
  return result;
}

LabelledCurves curves_over_angle(const models::Metal& metal) {
  constexpr double brightest = 0.25;  // luminance that a line on white may have; chosen by eye
  LabelledCurves result;
  for (const auto& [nm, dash] :
       {std::pair{450, "2 3"}, {500, "6 3 2 3"}, {550, "10 4"}, {600, "14 4 3 4"}, {700, ""}}) {
    const Rgb<double> c = hue(nm);
    const Stroke stroke{screen_colour(c * std::min(1.0, brightest / luminance(c))), curve_width,
                        dash};
    result.legend.push_back({std::to_string(nm) + " nm", stroke});
    result.curves.push_back(
        curve_of([&](double deg) { return reflectance_at(metal, nm, deg); }, 0, 90, stroke));
  }
  return result;
}

LabelledCurves channels_over_angle(const MetalColours& colours) {
  LabelledCurves result;
  for (const Channel& c : channels) {
    const Stroke solid{c.colour, curve_width}, dashed{c.colour, 1.4, "6 4"};
    result.legend.push_back({c.name, solid});
    result.curves.push_back(
        curve_of([&](double deg) { return colours.spectrum(deg).*c.value; }, 0, 90, solid));
    result.curves.push_back(
        curve_of([&](double deg) { return colours.schlick(deg).*c.value; }, 0, 90, dashed));
  }
  result.legend.push_back({"Schlick 1994", {"#555555", 1.4, "6 4"}});
  return result;
}

PlotPoint lowest(const Curve& curve) {
  return *std::ranges::min_element(curve.points, {}, &PlotPoint::y);
}

}  // namespace scanlit::studio
