// The error that an observer notices who flips between two pictures.
//
// Pontus Andersson, Jim Nilsson, Tomas Akenine-Moller, Magnus Oskarsson, Kalle Astrom, Mark D.
// Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proceedings of the ACM in
// Computer Graphics and Interactive Techniques 3(2), 2020. Written from the paper, with its
// constants; the variant for pictures that a screen can show (values are clamped to [0, 1]).
#pragma once

#include <vector>

#include "rasterizer/reference/reference.h"

namespace scanlit {

/// How many pixels an observer sees in a degree: the paper's, of a screen .7 m wide with 3840
/// pixels, seen from .7 m.
constexpr double flip_pixels_per_degree = 67.02;

/// For each pixel 0 (no difference is seen) to 1. Colours are linear light. Of equal size.
std::vector<double> flip(const ExactPicture& reference, const ExactPicture& picture,
                         double pixels_per_degree = flip_pixels_per_degree);

/// Its mean over the picture.
double mean_flip(const ExactPicture& reference, const ExactPicture& picture);

}  // namespace scanlit
