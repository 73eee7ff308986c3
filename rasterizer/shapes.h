// Built-in shapes, made as OpenMesh meshes and flattened like any other.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rasterizer/mesh.h"

namespace scanlit {

/// What `scanlit shapes` prints of a shape.
struct ShapeInfo {
  std::string name;         // "torus"
  std::string description;  // "major radius 0.7, minor 0.3, axis z"
  std::string parameter;    // what N means: "segments around the tube; 2 N along the ring"
  int default_tessellation;
  int min_tessellation;
  int max_tessellation;
};

/// plane, cube, sphere, icosphere, cylinder, cone, torus, trefoil, teapot.
const std::vector<ShapeInfo>& shapes();

/// Whether `specification` names a shape ("teapot", "sphere:64") rather than a file, its number
/// right or wrong.
bool is_shape(std::string_view specification);

/// "NAME" or "NAME:N", N the tessellation. Normals are analytic, texture coordinates are set;
/// vertices that differ in them only (seams, poles, sharp edges) lie at the same position to the
/// bit.
/// Throws Error: unknown shape (with the nearest name), N not a whole number or out of range.
Mesh make_shape(std::string_view specification);

}  // namespace scanlit
