// From a spectrum of reflectances to linear sRGB: what the eye, and so a picture, makes of it.
//
//   X = sum S(lambda) R(lambda) x(lambda) / sum S(lambda) y(lambda), likewise Y and Z
//   RGB = M (X, Y, Z)
//
// S is the light, R the reflectance, x y z the CIE 1931 colour-matching functions in the analytic
// fit of Wyman, Sloan and Shirley, "Simple analytic approximations to the CIE XYZ color matching
// functions", JCGT 2(2), 2013, eq. 4. Sums over 380 to 780 nm in steps of 5 nm, the two ends
// halved.
//
// A perfect mirror (R = 1) must be white, (1, 1, 1), but the fit's own white is not quite that of
// sRGB. So X, Y and Z are each scaled to sRGB's white, as far as the fit is off.
#pragma once

#include <functional>

#include "rasterizer/vec.h"

namespace scanlit::models {

constexpr double first_wavelength_nm = 380, last_wavelength_nm = 780;

/// The light a colour is seen under. D65, average daylight, is that of sRGB. Equal energy, S = 1,
/// is what remains if the light is left out of the sum: simpler, and often done.
enum class Illuminant { d65, equal_energy };

/// Chromaticity (x, y) of a perfect mirror, before the scaling: how good the fit is.
struct Chromaticity {
  double x, y;
};
Chromaticity white_point(Illuminant light);

/// Linear sRGB of a reflectance spectrum R(wavelength in nm), 0..1. A saturated colour may lie
/// outside the sRGB gamut: a channel is then below 0 or above 1. It is not clamped here.
Rgb<double> linear_srgb(const std::function<double(double wavelength_nm)>& reflectance,
                        Illuminant light = Illuminant::d65);

}  // namespace scanlit::models
