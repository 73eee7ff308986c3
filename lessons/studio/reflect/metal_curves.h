// What there is to draw of a metal's Fresnel reflectance F: curves over wavelength and over the
// angle of incidence, and the colour that is made of it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lessons/studio/reflect/curves.h"
#include "models/metals.h"

namespace scanlit::studio {

/// The metal whose name one of the model's parameters has, as in "fresnel:F=copper". Throws Error
/// where there is none: only of metals a spectrum is known.
const models::Metal& metal_of(const models::NamedModel& named);

/// models::reflectance() over the angle.
double reflectance_at(const models::Metal& metal, double wavelength_nm, double angle_deg);

/// Linear sRGB, 0..1, that stands for light of one wavelength in nm, a multiple of 5: its hue, as
/// saturated as a screen can be.
Rgb<double> hue(double wavelength_nm);

/// "#FF8000" of linear sRGB, clamped to [0, 1].
std::string screen_colour(const Rgb<double>& colour);

using ColourOverAngle = std::function<Rgb<double>(double angle_deg)>;

/// A metal's colour thrice, in linear sRGB: as the spectrum has it, as it is rendered, and as
/// Schlick's approximation has it with the same F at normal incidence.
struct MetalColours {
  ColourOverAngle spectrum, fit, schlick;
  double fit_error;  // the largest of a channel; what is beyond a screen is not counted

  explicit MetalColours(const models::Metal& metal);  // which must outlive this
};

struct LabelledCurves {
  std::vector<Curve> curves;
  std::vector<LegendEntry> legend;
};

LabelledCurves curves_over_wavelength(const models::Metal& metal,
                                      const std::vector<double>& angles_deg);
LabelledCurves curves_over_angle(const models::Metal& metal);
LabelledCurves channels_over_angle(const MetalColours& colours);

/// The lowest point of a curve.
PlotPoint lowest(const Curve& curve);

}  // namespace scanlit::studio
