// Vertex tangents computed from texture coordinates.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "rasterizer/mesh.h"

namespace scanlit::detail {

/// One tangent per vertex: the mean of dp/du over the triangles at the vertex, each a unit vector
/// weighted by the angle the triangle makes there, made perpendicular to the vertex's normal; unit.
/// Zero where no triangle has a dp/du (texture coordinates on one line or in one point) or the mean
/// has no direction in the surface. Needs the mesh's positions, normals, texcoords and indices.
/// As exact as the triangles are small: at a seam, where all of them lie on one side, it is off by
/// up to half the angle that one of them spans.
std::vector<glm::vec3> texcoord_tangents(const Mesh& mesh);

}  // namespace scanlit::detail
