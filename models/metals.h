// Metals by name: their Fresnel reflectance as colour, from measured optical constants.
//
// reflectance() is that of one wavelength: ConductorFresnel of the measured n + i k. spectral_rgb()
// sums it over the spectrum, which is right and far too slow for a fragment. MetalFresnel is its
// fit, for rendering.
//
// The optical constants are measurements collected by refractiveindex.info (public domain, CC0);
// each metal names its paper.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "models/polynomial.h"
#include "models/spectrum.h"

namespace scanlit::models {

/// The complex refractive index n + i k at one wavelength.
struct OpticalConstants {
  double wavelength_nm, n, k;
};

struct Metal {
  std::string name;                         // "copper"
  std::string source;                       // "Johnson and Christy 1972"
  std::span<const OpticalConstants> table;  // by wavelength; covers 380 to 780 nm

  /// n and k linear between the table's wavelengths, constant beyond its ends.
  OpticalConstants at(double wavelength_nm) const;
};

/// The fit. Maximum error against spectral_rgb() clamped to [0, 1]: 2e-4 per channel, over all
/// metals and angles; in float 1e-5 more.
///
/// F = 1 - x p(x), with a polynomial p of degree 7 and x = 1.3 c / (c + 0.3), c = V.H; exactly 1 at
/// grazing. In x rather than in c because a metal's F falls from 1 within c of about 1 / |n + i k|,
/// .15 for aluminium, which a polynomial in c follows badly (of equal degree: to 6e-3). 0.3 is
/// chosen by trial.
///
/// Clamped to [0, 1] on purpose: gold is more saturated than sRGB can show (its red is 1.035 at
/// normal incidence), and a reflectance above 1 would create light.
class MetalFresnel {
 public:
  explicit MetalFresnel(const Metal& metal);

  template <class T>
  Rgb<T> operator()(const T& v_h) const {
    const T x = compressed(v_h);
    const auto reflectance = [&x](const Polynomial<size>& p) {
      return min(max(T(1) - x * value_at(x, p), T(0)), T(1));
    };
    return {reflectance(red_), reflectance(green_), reflectance(blue_)};
  }

 private:
  static constexpr std::size_t size = 8;  // coefficients of x^0 to x^7

  template <class T>
  static T compressed(const T& c) {
    return T(1.3) * c / (c + T(0.3));
  }
  /// c once: the bounds are sharper.
  static Bounded compressed(const Bounded& c) {
    return Bounded(1.3) - Bounded(0.39) / (c + Bounded(0.3));
  }

  Polynomial<size> red_, green_, blue_;
};

/// All metals, by name.
const std::vector<Metal>& metals();
const std::vector<std::string>& metal_names();

/// Throws Error where there is no such metal: "unknown metal 'coper'; did you mean 'copper'?".
const Metal& find_metal(std::string_view name);
/// Its place among metals() and metal_names(). Throws likewise.
int metal_index(std::string_view name);
/// Its fit, made at the first call (of all metals, some milliseconds) and kept.
const MetalFresnel& metal(std::string_view name);

/// Reflectance 0..1 at one wavelength; cos_theta = V.H, 0..1.
double reflectance(const Metal& metal, double wavelength_nm, double cos_theta);

/// Linear sRGB of light mirrored off the metal; not clamped: outside the sRGB gamut a channel is
/// below 0 or above 1.
Rgb<double> spectral_rgb(const Metal& metal, double cos_theta, Illuminant light = Illuminant::d65);

}  // namespace scanlit::models
