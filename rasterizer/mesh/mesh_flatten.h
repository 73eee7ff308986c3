// From OpenMesh's halfedges to the flat arrays of Mesh, once.
#pragma once

#include <span>

#include "rasterizer/mesh.h"
#include "rasterizer/mesh/poly_mesh.h"

namespace scanlit::detail {

/// Triangulates, gives every corner its normal (the mesh's own where it has them and no crease is
/// asked for, else computed) and drops vertices without a face. `originals`: see MeshImporter;
/// empty where no vertex is a copy. `closed` is left false. Throws Error where there is no face or
/// a coordinate is not finite.
Mesh flatten(const PolyMesh& mesh, std::span<const std::uint32_t> originals, std::string name,
             const MeshOptions& options);

}  // namespace scanlit::detail
