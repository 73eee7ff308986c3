// (9) Tangents: which way the surface is brushed, at every point of a span. Only anisotropic models
// (Needs::frame) ask for it.
//
// A tangent is carried to world space by the linear part of world_from_object, as any direction in
// the surface is (a normal is not), and then made perpendicular to the shading normal. The third
// axis is the bitangent N x T: the shading frame is right-handed always. On a back face, whose
// normal is flipped, and in a mirrored object, whose tangents are mirrored with it, the bitangent
// therefore points the other way along the same line. A model that tells T's left from its right
// (most do not: they square both) sees the two exchanged there.
#pragma once

#include "rasterizer/surface.h"

namespace scanlit {

/// Whether the field is the mesh's own: `texcoord`, and the mesh has tangents. Where it has none,
/// `texcoord` is taken for `around`.
bool follows_texcoord(const Draw& draw);

/// The way the surface is brushed at places in object space, before it is made perpendicular to the
/// normal: in world space, of any length, and linear in the place. Not where follows_texcoord().
Vec3<Batch> brushed(const Draw& draw, const Vec3<Batch>& object_position);

/// Fills surface.tangent for points whose normals are in world space already. Every tangent is unit
/// and perpendicular to the normal within 1e-6, whatever the field, the mesh and the transform.
void place_tangents(const Draw& draw, SurfaceSpan& surface);

}  // namespace scanlit
