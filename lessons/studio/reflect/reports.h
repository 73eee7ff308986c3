// What `scanlit reflect` prints of a model: tables as text.
#pragma once

#include <string>
#include <vector>

#include "models/registry.h"

namespace scanlit::studio {

/// Directional albedo per channel, with its error, at viewing angles in the plane of this azimuth.
std::string furnace_report(const models::NamedModel& model, const std::vector<double>& angles_deg,
                           double azimuth_deg);

/// The worst violation of reciprocity that a search finds, and where.
std::string reciprocity_report(const models::NamedModel& model);

/// D, G and F apart, in the plane of incidence, for each light angle over viewing angles. Throws
/// Error where the model is not made of them.
std::string terms_report(const models::NamedModel& model,
                         const std::vector<double>& light_angles_deg, double azimuth_deg);

}  // namespace scanlit::studio
