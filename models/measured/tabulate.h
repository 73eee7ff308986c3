// From a reflection model to a table: the right answer is known, so that what a table and a look-up
// lose can be seen, and measured tables can be tested without a measurement.
//
// Sampled in double, diffuse and glossy part together, f_r = value / (pi N.L), at the default
// surface point: a table knows no texture.
#pragma once

#include <filesystem>

#include "rasterizer/reflection_model.h"

namespace scanlit::models {

/// A MERL table of the model at the bins' centres (the nearest look-up takes a bin for its whole
/// interval). Where light or viewer would be below the horizon, or nearer to it than min_n_v, the
/// entry is -1: not measured. Throws Error, with the file's name, for what the format cannot hold:
/// a model that is not isotropic, not reciprocal (both tried out, at seeded directions), not
/// finite; and for a file that cannot be written.
void tabulate_merl(const ReflectionModel& model, const std::filesystem::path& file);

/// A UTIA table. Nothing but infinity is refused, and much is lost: what happens within 15 degrees
/// of theta and 7.5 of phi, and everything beyond 75 degrees, where the look-up holds f_r. A model
/// whose f_r grows towards grazing (Fresnel; a glossy term without N.L) is darker there as a table.
void tabulate_utia(const ReflectionModel& model, const std::filesystem::path& file);

}  // namespace scanlit::models
