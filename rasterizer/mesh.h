// (1) Mesh: a file or a built-in shape becomes flat arrays in object space.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace scanlit {

/// An indexed triangle mesh, flattened once from OpenMesh and never changed after. Right-handed
/// object space; a front face is counter-clockwise seen from outside.
/// Invariants (ensured by every function that returns a Mesh): positions and normals are finite;
/// normals has positions' size and unit length; texcoords, tangents and colours have positions'
/// size or are empty, tangents being there where texcoords are; every index is below
/// positions.size(); indices.size() is a multiple of 3.
struct Mesh {
  std::string name;                    // file name or shape specification, for messages
  std::vector<glm::vec3> positions;    // object space
  std::vector<glm::vec3> normals;      // object space, unit
  std::vector<glm::vec2> texcoords;    // (u, v), empty where the source has none
  std::vector<glm::vec3> tangents;     // object space, in which u grows: unit and perpendicular to
                                       // the normal, or zero where u has no direction
  std::vector<glm::vec3> colours;      // linear RGB, 0..1, empty where the source has none
  std::vector<std::uint32_t> indices;  // three per triangle
  bool closed = false;                 // no boundary, consistently oriented, outward: only front
                                       // faces can be seen from outside
  std::vector<std::string> warnings;   // what was mended or dropped on the way, one line each

  std::size_t triangle_count() const { return indices.size() / 3; }
};

enum class NormalWeight { area, angle };

struct MeshOptions {
  NormalWeight normal_weight = NormalWeight::angle;  // where the file has no normals
  std::optional<double> crease_deg;  // split normals at edges whose faces meet at a larger angle,
                                     // in degrees, 0..180; given, it overrides the file's normals
};

/// Reads OBJ, PLY (ascii, binary), OFF, STL or OM through OpenMesh, by the file's suffix.
/// Polygons are triangulated. Vertex colours are read from OBJ (x y z r g b), PLY (red green blue)
/// and OFF (COFF); whole numbers, 8 or 16 bits, are taken for sRGB codes and decoded, fractions
/// 0..1 for linear light; what is out of range is clamped and counted in `warnings`. What OpenMesh
/// refuses (complex edges, repeated vertices in a face) is drawn all the same, by duplicated
/// vertices, and counted in `warnings`. Throws Error naming the file (and line, where the format
/// has lines): missing, empty, truncated or malformed file; a face that names a vertex that does
/// not exist; NaN or Inf coordinates; header counts that the file's size cannot hold; no face at
/// all.
Mesh load_mesh(const std::filesystem::path& file, const MeshOptions& options = {});

/// A mesh of the given faces (each a list of vertex indices), with normals as `options` say.
/// For tests and for callers that make geometry of their own. Throws Error as load_mesh does.
Mesh make_mesh(std::string name, const std::vector<glm::vec3>& positions,
               const std::vector<std::vector<std::uint32_t>>& faces,
               const MeshOptions& options = {});

}  // namespace scanlit
