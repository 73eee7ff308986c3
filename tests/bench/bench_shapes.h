// The shapes of the comparison's scenes that are defined to the last vertex.
#pragma once

#include "rasterizer/mesh.h"

namespace scanlit::bench {

/// Unit sphere about the origin: theta = pi i / stacks, phi = 2 pi j / slices, vertex
/// i (slices + 1) + j at (sin theta sin phi, cos theta, sin theta cos phi); seam and poles repeat
/// their vertices. 2 slices (stacks - 1) triangles.
Mesh sphere(int stacks, int slices);

/// Major radius .7, minor .3, its axis z turned about x by -40 degrees. 2 around tube triangles.
Mesh torus(int around, int tube);

/// The axis-parallel cube about the origin of edge 1: 12 triangles, a normal for each side.
Mesh unit_cube();

}  // namespace scanlit::bench
