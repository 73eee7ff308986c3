// The built-in shapes, with vertex normals and texture coordinates. What n means, `shapes()` says.
#pragma once

#include "rasterizer/mesh/poly_mesh.h"

namespace scanlit::detail {

PolyMesh make_plane(int n);
PolyMesh make_cube(int n);
PolyMesh make_sphere(int n);
PolyMesh make_icosphere(int n);
PolyMesh make_cylinder(int n);
PolyMesh make_cone(int n);
PolyMesh make_torus(int n);
PolyMesh make_trefoil(int n);
PolyMesh make_teapot(int n);

}  // namespace scanlit::detail
