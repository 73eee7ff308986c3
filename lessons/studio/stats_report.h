// What `--stats` prints.
#pragma once

#include <ostream>

#include "rasterizer/render.h"

namespace scanlit::studio {

/// Where the time went, how much of the scene was left out at each stage, and what was left to do.
void print_stats(std::ostream& out, const FrameStats& stats, const Scene& scene,
                 const Skips& skips);

}  // namespace scanlit::studio
