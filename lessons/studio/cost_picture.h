// What `scanlit render --aov cost` draws.
#pragma once

#include <filesystem>

#include "rasterizer/framebuffer.h"
#include "rasterizer/render.h"

namespace scanlit::studio {

/// Beside the picture, for `picture` x.png x-cost.png.
std::filesystem::path cost_file(const std::filesystem::path& picture);

/// Throws Error where the picture of a frame of this size would be too large.
void check_cost_picture(int width, int height);

/// The frame's plane `cost` in false colours, depth tests on the left and evaluations of reflection
/// models on the right, each with its scale below: the same in every picture, so that two can be
/// compared.
Framebuffer draw_cost(const Framebuffer& frame, int samples);

}  // namespace scanlit::studio
