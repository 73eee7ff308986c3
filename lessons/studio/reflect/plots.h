// The plots of `scanlit reflect`, each as the text of an SVG file.
#pragma once

#include <string>
#include <vector>

#include "models/registry.h"

namespace scanlit::studio {

/// What of a model is plotted: the intensity it reflects of light with Ii = 1, pi f_r (n.l), or
/// f_r alone, in 1/sr.
enum class Quantity { value, brdf };

struct PlotRequest {
  std::vector<models::NamedModel> models;
  std::vector<double> light_angles_deg;  // from the normal
  double azimuth_deg = 0;                // of the light, from the tangent
  Quantity quantity = Quantity::value;
  bool logarithmic = false;  // cartesian: a second panel with a logarithmic axis
};

/// The lobe in the plane of incidence, the light fixed, as a polar curve over the viewing angle.
std::string plot_polar(const PlotRequest& request);
/// The same over a straight axis of viewing angles.
std::string plot_cartesian(const PlotRequest& request);
/// Directional albedo over the viewing angle, 0 to 90 degrees.
std::string plot_albedo(const PlotRequest& request);
/// A metal's Fresnel reflectance over wavelength, over the angle of incidence, and as a colour. Of
/// the request only the one model and, for the curves over wavelength, the angles matter. Throws
/// Error where the model has no metal's name.
std::string plot_spectrum(const PlotRequest& request);

}  // namespace scanlit::studio
