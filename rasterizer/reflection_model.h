// The one small interface through which a reflection model is plugged into the engine. The engine
// owns it and knows no model; `formula_model.h` implements it for any formula written once as a
// template over its scalar type.
//
// A model returns the lecture's braces, { Kd (N.L) + Ks (N.H)^n }, that is pi f_r(l, v) (n.l):
// dimensionless, per channel, cosine included, so that light at grazing angles needs no division;
// in two parts, diffuse and glossy, so that both colour forms can be expressed. f_r itself is 1/sr.
#pragma once

#include <cstddef>
#include <span>

#include "rasterizer/light_source.h"

namespace scanlit {

/// The two parts of pi f_r (n.l). Linear RGB, >= 0.
template <class T>
struct Reflection {
  Rgb<T> diffuse;
  Rgb<T> glossy;
};

struct PointSpan;

/// The surface point a formula sees if it asks for it.
template <class T>
struct SurfacePoint {
  Vec3<T> object_position;       // object space
  T u{}, v{};                    // texture coordinates; 0 where the mesh has none
  Rgb<T> vertex_colour{T(1.0)};  // linear; white where the mesh has none
  // Single queries: a span of this one point, where it is one of a picture. It is visible then, so
  // that a viewer below the horizon is taken for one just above; and parameters that vary see what
  // the span holds.
  const PointSpan* drawn = nullptr;
};

/// What a model asks the engine to provide beyond the four cosines.
struct Needs {
  bool frame = false;                 // tangents: l, v, h in the shading frame
  bool surface_point = false;         // DirectionSpan::points
  bool texcoord_derivatives = false;  // in those points
  std::size_t parameters = 0;         // arrays that evaluate_parameters() fills
};

/// The smallest n_v a formula ever sees. An interpolated normal can tilt away from the viewer near
/// a silhouette although the fragment is visible; without the clamp D G F / (N.V) divides by zero
/// or a visible fragment is treated as unseen. `cosines()` in cosines.h applies it, nowhere
/// else.
constexpr double min_n_v = 1e-4;

/// Arrays of floats for `size` points of one object's surface, one array per component. Each array
/// holds whole vectors: it may be read up to `size` rounded up to a multiple of max_lanes.
struct PointSpan {
  std::size_t size = 0;
  const float* object_position[3] = {};
  const float* texcoord[2] = {};       // 0 where the mesh has none
  const float* vertex_colour[3] = {};  // linear RGB; 1 where the mesh has none
  // By how much texcoord grows to the next pixel, on the right and below; null where nobody needs
  // it or the points are no pixels (vertices, faces, single queries).
  const float* texcoord_dx[2] = {};
  const float* texcoord_dy[2] = {};
  const float* normal[3] = {};   // world space, unit
  const float* tangent[3] = {};  // world space, unit; only if needs().frame
  float world_from_object[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // [column][row], directions
};
constexpr std::size_t max_lanes = 16;

/// The directions at a span's points, in any one space; arrays as in PointSpan.
struct DirectionSpan {
  std::size_t size = 0;
  const float* normal[3] = {};               // unit
  const float* to_light[3] = {};             // unit
  const float* to_viewer[3] = {};            // unit
  const float* tangent[3] = {};              // unit, perpendicular to normal; only if needs().frame
  const PointSpan* points = nullptr;         // only if needs().surface_point
  const float* const* parameters = nullptr;  // as evaluate_parameters() filled them
};

/// Where a span's result goes; written up to `size` rounded up to a multiple of max_lanes.
struct ReflectionSpan {
  float* diffuse[3] = {};
  float* glossy[3] = {};
};

/// A span's points as the viewer sees them, world space; arrays as in PointSpan, `size` at most
/// FragmentSpan::capacity.
struct ViewedSpan {
  std::size_t size = 0;
  const float* normal[3] = {};     // unit
  const float* position[3] = {};   // only if some light is not far
  const float* to_viewer[3] = {};  // unit; null where the viewer is infinitely far:
  Vec3<float> far_viewer{};        // the direction to it, then
  const float* tangent[3] = {};    // as in DirectionSpan, as all that follows
  const PointSpan* points = nullptr;
  const float* const* parameters = nullptr;
  bool skip_dark = true;  // points that a light does not reach
};

/// Where a span's radiance goes; written as ReflectionSpan. What is null is not wanted.
struct RadianceSpan {
  float* diffuse[3] = {};
  float* glossy[3] = {};
  float* colour[3] = {};  // ambient + (diffuse + glossy)
  Rgb<float> ambient{};
  float* evaluations = nullptr;  // adds 1 to each point's for each light it is evaluated under
};

struct BoundedCosines;
struct BoundedReflection;

class ReflectionModel {
 public:
  virtual ~ReflectionModel() = default;

  virtual Needs needs() const = 0;

  /// Fills needs().parameters arrays with what varies over the surface and not with the light. The
  /// engine calls it once for a span, before evaluate() for each light, and only if there are any.
  virtual void evaluate_parameters(const PointSpan&, float* const* /*parameters*/) const {}

  /// A whole span in one call, in vector arithmetic. Light below the horizon gives 0. A viewer
  /// below it is taken for one just above (min_n_v): the span's points are visible.
  virtual void evaluate(const DirectionSpan& in, const ReflectionSpan& out) const = 0;

  /// What a span sends to the viewer: evaluate(), weighted by each light and summed. Returns at how
  /// many (point, light) pairs the model was evaluated. A model need not override it; FormulaModel
  /// does, because sums that stay in registers cost half the time.
  virtual std::size_t radiance(const ViewedSpan& in, std::span<const LightSource> lights,
                               const RadianceSpan& out) const;

  /// What is known of the reflection where no more is known of the cosines than this, and how fast
  /// it changes along a row of pixels; above the horizon. False where nothing is: all points are to
  /// be evaluated, then. FormulaModel gets it from the formula itself.
  virtual bool bounds(const BoundedCosines&, BoundedReflection& /*out*/) const { return false; }

  /// A single query: l towards the light, v towards the viewer, unit, in the shading frame (x
  /// tangent, y bitangent, z normal). 0 where light or viewer is at or below the horizon (but see
  /// SurfacePoint::drawn).
  virtual Reflection<double> evaluate(const Vec3<double>& l, const Vec3<double>& v,
                                      const SurfacePoint<double>& point = {}) const = 0;
  virtual Reflection<float> evaluate(const Vec3<float>& l, const Vec3<float>& v,
                                     const SurfacePoint<float>& point = {}) const = 0;
};

}  // namespace scanlit
