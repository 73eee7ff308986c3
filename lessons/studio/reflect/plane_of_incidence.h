// A model's lobe in the plane of incidence: the light fixed, the viewer going over the hemisphere.
#pragma once

#include "lessons/studio/reflect/curves.h"
#include "lessons/studio/reflect/plots.h"

namespace scanlit::studio {

/// "I = π f_r (n·l)" or "f_r [1/sr]", or, of D, G or F, what it is: what stands on the axis.
std::string quantity_title(const PlotRequest& request);

/// samples[model][light angle] over viewing angles of -90 to 90 degrees: positive on the side of
/// the mirror direction, negative on the light's.
SampleTable sample_lobes(const PlotRequest& request, const std::function<double(double)>& drawn);

/// The largest value of any curve; 1 where all are 0.
double largest_value(const PlotRequest& request);

/// What is plotted, for a title: "Lobe in the plane of incidence".
std::string heading(const PlotRequest& request, const std::string& what);

/// What a reader must know beside the axes: whose luminance, at which azimuth.
std::string remarks(const PlotRequest& request, const CurveSet& set);

}  // namespace scanlit::studio
