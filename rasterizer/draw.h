// (2) Objects become draws: what stages (3) to (9) ask of an object, worked out once a frame.
#pragma once

#include "rasterizer/pipeline.h"

namespace scanlit {

/// All but `illumination`, which lighting.h works out.
Draw make_draw(const Object& object, std::uint32_t index, const glm::dmat4& clip_from_world,
               ClusterCache& clusters);

}  // namespace scanlit
