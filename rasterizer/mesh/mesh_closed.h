// Whether a mesh encloses a volume.
#pragma once

#include "rasterizer/mesh.h"

namespace scanlit::detail {

enum class Closedness { open, outward, inside_out };

/// Not open: every edge is shared by exactly two triangles that run along it in opposite
/// directions, where vertices at equal positions count as one and triangles that have two of them
/// are left out. Outward where the signed volume is positive.
Closedness closedness(const Mesh& mesh);

}  // namespace scanlit::detail
