// (9) The surface that is lit: a mesh's attributes at a face, at a vertex, or interpolated to every
// fragment of a span. Nothing is prepared that the model does not need.
#pragma once

#include <array>
#include <vector>

#include "rasterizer/of_runs.h"

namespace scanlit {

/// Points of one object's surface. Arrays may be read and written up to `size` rounded up to a
/// whole vector; what they hold beyond `size` is any float. What the model does not need (see
/// needs_points and Needs) is left as it is.
struct SurfaceSpan {
  static constexpr int capacity = FragmentSpan::capacity;
  static constexpr int padded = FragmentSpan::padded;

  int size = 0;
  const std::uint32_t* pixel =
      nullptr;                     // where they are seen, if they are fragments (FragmentSpan)
  float position[3][padded] = {};  // object space
  float normal[3][padded] = {};    // in: object space, any length, on the viewer's side;
                                   // out: world space, unit
  float texcoord[2][padded] = {};  // 0 where the mesh has none
  float texcoord_dx[2][padded] = {}, texcoord_dy[2][padded] = {};  // if with_derivatives
  bool with_derivatives = false;  // the points are pixels whose FragmentSpan has them
  float colour[3][padded] = {};   // the vertex colour, linear; 1 where the mesh has none
  float tangent[3][padded] = {};  // in: the mesh's, if follows_texcoord(), any length;
                                  // out: world space, unit, perpendicular to normal
  // What evaluate_parameters() fills; kept from span to span.
  std::vector<std::array<float, padded>> parameters{};
};

/// Whether a model sees a PointSpan.
inline bool needs_points(const Needs& needs) { return needs.surface_point || needs.parameters > 0; }

/// A triangle of the mesh as a plane: its centroid and its unit normal (0 if it has no area).
struct Face {
  glm::vec3 centroid, normal;
};
Face face(const Mesh& mesh, std::uint32_t triangle);

/// A site of a flat or Gouraud object becomes point i: the face's centroid, or the vertex.
void put_site(const Draw& draw, const Needs& needs, const LitSites::Site& site, int i,
              SurfaceSpan& surface);

/// An attribute's channels over the runs of a span: a0 + b1 (a1 - a0) + b2 (a2 - a0). `fine`: the
/// small terms first, so that only one sum is rounded at the size of a0. A solid texture's fine
/// fibres magnify what a position has lost; normals and colours save an operation.
template <int channels, bool fine = false>
class RunAttribute {
 public:
  /// Of run r, times `sign`; `corner` points at the attribute in each corner of its triangle.
  void put(int r, const float* const (&corner)[3], float sign) {
#pragma GCC unroll 3
    for (int c = 0; c < channels; ++c) {
      const float a0 = sign * corner[0][c];
      a0_[c][r] = a0;
      d1_[c][r] = sign * corner[1][c] - a0;
      d2_[c][r] = sign * corner[2][c] - a0;
    }
  }

  /// Channel c at a vector of fragments.
  Batch at(const OfRuns& of, int c, const Batch& b1, const Batch& b2) const {
    if constexpr (fine) return of(a0_[c]) + mul_add(b2, of(d2_[c]), b1 * of(d1_[c]));
    return mul_add(b2, of(d2_[c]), mul_add(b1, of(d1_[c]), of(a0_[c])));
  }

  /// At all of them, up to a whole vector.
  void interpolate(const FragmentSpan& span, float (&out)[channels][SurfaceSpan::padded]) const {
    for (int i = 0; i < span.size; i += Batch::lanes) {
      const OfRuns of(span.run + i);
      const Batch b1 = Batch::load(span.b1 + i), b2 = Batch::load(span.b2 + i);
#pragma GCC unroll 3
      for (int c = 0; c < channels; ++c) at(of, c, b1, b2).store(out[c] + i);
    }
  }

 private:
  FragmentSpan::PerRun a0_[channels], d1_[channels], d2_[channels];
};

/// Every fragment of the span becomes a point, with what its object's Illumination needs.
void interpolate_surface(const FragmentSpan& span, SurfaceSpan& surface);

}  // namespace scanlit
