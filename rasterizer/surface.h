// (9) The surface that is lit: a mesh's attributes at a face, at a vertex, or interpolated to every
// fragment of a span. Nothing is prepared that the model does not need.
#pragma once

#include <array>
#include <cstring>
#include <span>
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
  // Where they are seen, if they are fragments (FragmentSpan).
  const std::uint32_t* pixel = nullptr;
  alignas(cache_line) float position[3][padded] = {};  // object space
  float normal[3][padded] = {};    // in: object space, any length, on the viewer's side;
                                   // out: world space, unit
  float texcoord[2][padded] = {};  // 0 where the mesh has none
  float texcoord_dx[2][padded] = {}, texcoord_dy[2][padded] = {};  // if with_derivatives
  bool with_derivatives = false;  // the points are pixels whose FragmentSpan has them
  // The vertex colour, linear; 1 where the mesh has none.
  alignas(cache_line) float colour[3][padded] = {};
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

/// Sites of a flat or Gouraud object become points: the faces' centroids, or the vertices. At most
/// SurfaceSpan::capacity.
void put_sites(const Draw& draw, const Needs& needs, std::span<const LitSites::Site> sites,
               SurfaceSpan& surface);

/// An attribute over the runs of a span: a0 + b1 (a1 - a0) + b2 (a2 - a0), the small terms first,
/// so that only one sum is rounded at the size of a0. A solid texture's fine fibres magnify what a
/// position has lost.
class RunAttribute {
 public:
  /// Of the corners of run r's triangle.
  template <class V>
  void put(int r, const V& a, const V& b, const V& c) {
    std::memcpy(corners_[0][r], &a, sizeof(V));
    std::memcpy(corners_[1][r], &b, sizeof(V));
    std::memcpy(corners_[2][r], &c, sizeof(V));
  }

  /// At all fragments, up to a whole vector; where there is a sign, each run's times its own.
  template <int channels>
  void interpolate(const FragmentSpan& span, float (&out)[channels][SurfaceSpan::padded],
                   const float* sign = nullptr) {
    for (int r = 0; r < span.run_count; r += Batch::lanes)
      put_differences<channels>(r, sign ? Batch::load(sign + r) : Batch(1));
    for (int i = 0; i < span.size; i += Batch::lanes) {
      const OfRuns of(span.run + i);
      const Batch b1 = Batch::load(span.b1 + i), b2 = Batch::load(span.b2 + i);
#pragma GCC unroll 3
      for (int c = 0; c < channels; ++c) {
        const Batch a0 = of(a0_[c]), d1 = of(d1_[c]), d2 = of(d2_[c]);
        (a0 + mul_add(b2, d2, b1 * d1)).store(out[c] + i);
      }
    }
  }

 private:
  /// Of a vector of runs.
  template <int channels>
  void put_differences(int r, const Batch& sign) {
    Batch a[3][4];
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
      hn::LoadInterleaved4(Batch::tag, corners_[k][r], a[k][0].raw, a[k][1].raw, a[k][2].raw,
                           a[k][3].raw);
#pragma GCC unroll 3
    for (int c = 0; c < channels; ++c) {
      const Batch a0 = sign * a[0][c];
      a0.store(a0_[c] + r);
      (sign * a[1][c] - a0).store(d1_[c] + r);
      (sign * a[2][c] - a0).store(d2_[c] + r);
    }
  }

  alignas(cache_line) float corners_[3][FragmentSpan::padded][4];
  FragmentSpan::PerRun a0_[3], d1_[3], d2_[3];
};

/// At the fragments of one run alone: an attribute with these values at its triangle's corners.
template <class V>
void interpolate_run(const FragmentSpan& span, const Run& run, const V& a, const V& b, const V& c,
                     float (&out)[3][SurfaceSpan::padded]) {
  for (int i = run.first, end = run.first + run.size; i < end; i += Batch::lanes) {
    const Batch b1 = Batch::load(span.b1 + i), b2 = Batch::load(span.b2 + i);
    const auto own = Batch::iota(float(i)) < Batch(end);
    for (int k = 0; k < 3; ++k) {
      const Batch value = mul_add(b2, Batch(c[k] - a[k]), mul_add(b1, Batch(b[k] - a[k]), a[k]));
      select(own, value, Batch::load(out[k] + i)).store(out[k] + i);
    }
  }
}

/// Every fragment of the span becomes a point, with what its object's Illumination needs.
void interpolate_surface(const FragmentSpan& span, SurfaceSpan& surface);

}  // namespace scanlit
