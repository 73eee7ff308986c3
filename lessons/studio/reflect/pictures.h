// The pictures of `scanlit reflect`: linear light, to be written as an image file.
#pragma once

#include <vector>

#include "models/registry.h"
#include "rasterizer/framebuffer.h"

namespace scanlit::studio {

struct PictureRequest {
  std::vector<models::NamedModel> models;
  std::vector<double> light_angles_deg;  // spheres only
  int cell = 280;                        // side of one sphere or slice, in pixels
};

/// Spheres, a row for each model, a column for each light; parallel projection. The one light is so
/// many degrees from the viewer's direction, towards the upper left.
Framebuffer draw_spheres(const PictureRequest& request);

/// The slice phi_d = 90 degrees of pi f_r over half-vector angle (to the right) and difference
/// angle (upwards), 0 to 90 degrees each, as in Burley 2012, "Physically-based shading at Disney",
/// section 3: on the left the specular peak, at the top left Fresnel's, at the bottom what
/// retro-reflects, on the right what grazes.
Framebuffer draw_slices(const PictureRequest& request);

}  // namespace scanlit::studio
