// The channels under which a framebuffer's planes stand in an EXR file. Used by stage (11).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rasterizer/framebuffer.h"

namespace scanlit {

struct FloatPlane {
  std::vector<float> Framebuffer::*values;
  int channels;
  std::array<const char*, 4> names;
};
inline constexpr std::array<FloatPlane, 7> float_planes = {{
    {&Framebuffer::colour, 4, {"R", "G", "B", "A"}},
    {&Framebuffer::depth, 1, {"depth.Z"}},
    {&Framebuffer::normal, 3, {"normal.X", "normal.Y", "normal.Z"}},
    {&Framebuffer::ambient, 3, {"ambient.R", "ambient.G", "ambient.B"}},
    {&Framebuffer::diffuse, 3, {"diffuse.R", "diffuse.G", "diffuse.B"}},
    {&Framebuffer::glossy, 3, {"glossy.R", "glossy.G", "glossy.B"}},
    {&Framebuffer::cost, 2, {"cost.tests", "cost.evaluations"}},
}};

struct IdPlane {
  std::vector<std::uint32_t> Framebuffer::*values;
  const char* name;
};
inline constexpr std::array<IdPlane, 2> id_planes = {{
    {&Framebuffer::object_id, "id.object"},
    {&Framebuffer::triangle_id, "id.triangle"},
}};

}  // namespace scanlit
