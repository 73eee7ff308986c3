// The reflection model at the points where it was evaluated for a fragment.
#pragma once

#include "lessons/studio/explain/explanation.h"

namespace scanlit::studio {

/// Directions, angles and terms at the pixel (Phong), at the face (flat) or at the three vertices
/// (Gouraud), under each light.
void print_points(std::ostream& out, const Explanation& explanation,
                  const FragmentRecord& fragment);

}  // namespace scanlit::studio
