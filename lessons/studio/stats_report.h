// What `--stats` prints.
#pragma once

#include <ostream>

#include "rasterizer/render.h"

namespace scanlit::studio {

void print_stats(std::ostream& out, const FrameStats& stats);

}  // namespace scanlit::studio
