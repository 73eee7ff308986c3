#include "models/spectrum.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <iterator>

namespace scanlit::models {
namespace {

/// CIE standard illuminant D65, relative spectral power (ISO/CIE 11664-2), 380 to 780 nm in steps
/// of 10 nm; between them linear, as in the standard's own table in steps of 5 nm.
constexpr double d65[] = {49.9755, 54.6482, 82.7549, 91.4860, 93.4318, 86.6823, 104.865,
                          117.008, 117.812, 114.861, 115.923, 108.811, 109.354, 107.802,
                          104.790, 107.689, 104.405, 104.046, 100.000, 96.3342, 95.7880,
                          88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992, 80.0268,
                          80.2146, 82.2778, 78.2842, 69.7213, 71.6091, 74.3490, 61.6040,
                          69.8856, 75.0870, 63.5927, 46.4182, 66.8054, 63.3828};
constexpr int d65_steps = int(std::size(d65)) - 1;

double power(Illuminant light, double wavelength_nm) {
  if (light == Illuminant::equal_energy) return 1;
  const double position = (wavelength_nm - first_wavelength_nm) / 10;
  const int i = std::min(int(position), d65_steps - 1);
  return std::lerp(d65[i], d65[i + 1], position - i);
}

/// Wyman et al. 2013, eq. 4: sums of lobes, each a Gaussian of a different width on either side.
glm::dvec3 colour_matching(double wavelength_nm) {
  const auto lobe = [wavelength_nm](double peak_nm, double below, double above) {
    const double d = wavelength_nm - peak_nm, t = d * (d < 0 ? below : above);
    return std::exp(-0.5 * t * t);
  };
  return {1.056 * lobe(599.8, 0.0264, 0.0323) + 0.362 * lobe(442.0, 0.0624, 0.0374) -
              0.065 * lobe(501.1, 0.0490, 0.0382),
          0.821 * lobe(568.8, 0.0213, 0.0247) + 0.286 * lobe(530.9, 0.0613, 0.0322),
          1.217 * lobe(437.0, 0.0845, 0.0278) + 0.681 * lobe(459.0, 0.0385, 0.0725)};
}

/// Not divided by the light's own Y.
template <class Reflectance>
glm::dvec3 integrate(const Reflectance& reflectance, Illuminant light) {
  constexpr int steps = 80;  // of 5 nm
  glm::dvec3 xyz(0);
  for (int i = 0; i <= steps; ++i) {
    const double nm = std::lerp(first_wavelength_nm, last_wavelength_nm, double(i) / steps);
    const double end = i == 0 || i == steps ? 0.5 : 1;
    xyz += end * power(light, nm) * reflectance(nm) * colour_matching(nm);
  }
  return xyz;
}

double one(double) { return 1; }

/// XYZ, with Y = 1, of a chromaticity.
glm::dvec3 xyz(const Chromaticity& c) { return {c.x / c.y, 1, (1 - c.x - c.y) / c.y}; }

// IEC 61966-2-1: sRGB's primaries and white (D65).
constexpr Chromaticity red{0.64, 0.33}, green{0.30, 0.60}, blue{0.15, 0.06}, white{0.3127, 0.3290};

/// From XYZ to linear sRGB: each primary so bright that together they are white.
glm::dmat3 srgb_from_xyz() {
  const glm::dmat3 primaries(xyz(red), xyz(green), xyz(blue));
  const glm::dvec3 brightness = glm::inverse(primaries) * xyz(white);
  return glm::inverse(glm::dmat3(primaries[0] * brightness.x, primaries[1] * brightness.y,
                                 primaries[2] * brightness.z));
}

}  // namespace

Chromaticity white_point(Illuminant light) {
  const glm::dvec3 w = integrate(one, light);
  return {w.x / (w.x + w.y + w.z), w.y / (w.x + w.y + w.z)};
}

Rgb<double> linear_srgb(const std::function<double(double wavelength_nm)>& reflectance,
                        Illuminant light) {
  static const glm::dmat3 matrix = srgb_from_xyz();
  const glm::dvec3 relative = integrate(reflectance, light) / integrate(one, light);
  const glm::dvec3 rgb = matrix * (relative * xyz(white));
  return {rgb.x, rgb.y, rgb.z};
}

}  // namespace scanlit::models
