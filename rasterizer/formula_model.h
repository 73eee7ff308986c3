// From one formula, written once as a template over its scalar, to a ReflectionModel in double,
// float and Batch.
//
// A formula is a class with a call operator that takes the four cosines and, only if it needs them,
// the shading frame or the surface point; asking for the argument is what declares the need:
//
//   template <class T>
//   Reflection<T> operator()(const Cosines<T>& c) const;
//   Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const;
//   Reflection<T> operator()(const Cosines<T>& c, const SurfacePoint<T>& p) const;
//   Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f,
//                            const SurfacePoint<T>& p) const;
//
// It is called for n_l > 0 or its result is thrown away: it must be finite but need not be right
// below the horizon.
#pragma once

#include <type_traits>
#include <utility>

#include "rasterizer/batch.h"
#include "rasterizer/reflection_model.h"
#include "rasterizer/scalar_math.h"

namespace scanlit {

/// A cosine that also knows its angle's squared sine. Used as a number it is the cosine. Near 1 a
/// float cosine has lost the angle (1 - cos^2 cancels); the sine, formed from a cross product, has
/// not.
template <class T>
struct Cosine {
  T cos{};
  T sin2{};
  operator const T&() const { return cos; }
};

/// The angles of the lecture, as cosines.
template <class T>
struct Cosines {
  T n_l;          // N.L, in (-1, 1]
  T n_v;          // N.V, in [min_n_v, 1]
  Cosine<T> n_h;  // N.H, H half-way between L and V
  T v_h;          // V.H = L.H, in [0, 1]
};

/// The directions in the shading frame: x tangent, y bitangent, z normal; unit.
template <class T>
struct ShadingFrame {
  Vec3<T> l, v, h;
};

/// cos^n, accurate to (1 + n sin2) 2e-7 relative in float also for n = 1e5: below 45 degrees the
/// logarithm is taken of 1 - sin2, with the rounding of that subtraction put back, because the
/// rounding of the cosine itself would be magnified n times.
template <class T>
T pow(const Cosine<T>& c, const T& n) {
  const T one(1), zero(0);
  const auto small_angle = c.sin2 < T(0.5);
  const T cos2 = select(small_angle, one - c.sin2, c.cos * c.cos);
  // (1 - cos2) is exact for cos2 in [1/2, 1], so `lost` is what rounding 1 - sin2 dropped.
  const T lost = select(small_angle, (one - cos2) - c.sin2, zero);
  const T log_cos = T(0.5) * (log(max(cos2, T(1e-37))) + lost / max(cos2, T(0.5)));
  return select(c.cos > zero, exp(n * log_cos), select(n > zero, zero, one));
}
template <class T>
requires(!std::is_same_v<T, double>) T pow(const Cosine<T>& c, double n) { return pow(c, T(n)); }

/// The cosines of unit n, l and v, without cancellation: H's direction is s = l + v, V.H = |s| / 2,
/// and sin^2(N,H) = |n x s|^2 / |s|^2. This is the one place where N.V is clamped (min_n_v).
template <class T>
Cosines<T> cosines(const Vec3<T>& n, const Vec3<T>& l, const Vec3<T>& v) {
  const Vec3<T> s = l + v, t = cross(n, s);
  // Where l = -v, H has no direction: 0/0 without the bound. Taken as perpendicular to N.
  const T s2 = dot(s, s), tiny(1e-20);
  const auto opposite = s2 < tiny;
  const T inverse = T(1) / max(s2, tiny), length = sqrt(s2);
  return {.n_l = dot(n, l),
          .n_v = max(dot(n, v), T(min_n_v)),
          .n_h = {.cos = select(opposite, T(0), dot(n, s) * (length * inverse)),
                  .sin2 = select(opposite, T(1), dot(t, t) * inverse)},
          .v_h = T(0.5) * length};
}

/// Directions into the shading frame of unit n and tangent t (perpendicular to n).
template <class T>
ShadingFrame<T> shading_frame(const Vec3<T>& n, const Vec3<T>& t, const Vec3<T>& l,
                              const Vec3<T>& v) {
  const Vec3<T> b = cross(n, t), s = l + v;
  const T inverse = T(1) / sqrt(max(dot(s, s), T(1e-20)));  // as in cosines()
  const auto local = [&](const Vec3<T>& d) { return Vec3<T>{dot(t, d), dot(b, d), dot(n, d)}; };
  return {.l = local(l), .v = local(v), .h = local(s * inverse)};
}

template <class Formula>
class FormulaModel final : public ReflectionModel {
  template <class... Arguments>
  static constexpr bool takes = std::is_invocable_v<const Formula&, Arguments...>;
  static constexpr bool takes_both =
      takes<Cosines<float>, ShadingFrame<float>, SurfacePoint<float>>;
  static constexpr bool takes_frame = takes<Cosines<float>, ShadingFrame<float>> || takes_both;
  static constexpr bool takes_point = takes<Cosines<float>, SurfacePoint<float>> || takes_both;
  static_assert(takes<Cosines<float>> || takes_frame || takes_point, "see the top of this file");

  // A formula that owns tables is not copied.
  using LocalFormula =
      std::conditional_t<std::is_trivially_copyable_v<Formula>, const Formula, const Formula&>;

 public:
  explicit FormulaModel(Formula formula) : formula_(std::move(formula)) {}

  Needs needs() const override { return {.frame = takes_frame, .surface_point = takes_point}; }

  // Inlined whole (flatten), whatever the size of the author's formula: a call in the loop would
  // pass its vectors through memory.
  [[gnu::flatten]] void evaluate(const DirectionSpan& directions,
                                 const ReflectionSpan& reflection) const override {
    // Local copies, because a vector store may alias whatever is behind a reference: pointers and
    // parameters would be loaded, and converted to Batch, again for every vector.
    const DirectionSpan in = directions;
    const ReflectionSpan out = reflection;
    const LocalFormula formula = formula_;
    const auto vec3 = [](const float* const* a, std::size_t i) -> Vec3<Batch> {
      return {Batch::load(a[0] + i), Batch::load(a[1] + i), Batch::load(a[2] + i)};
    };
    const auto store = [](const Rgb<Batch>& c, float* const* a, std::size_t i) {
      c.r.store(a[0] + i), c.g.store(a[1] + i), c.b.store(a[2] + i);
    };
    for (std::size_t i = 0; i < in.size; i += std::size_t(Batch::lanes)) {
      const auto n = vec3(in.normal, i), l = vec3(in.to_light, i), v = vec3(in.to_viewer, i);
      ShadingFrame<Batch> frame;
      SurfacePoint<Batch> point;
      if constexpr (takes_frame) frame = shading_frame(n, vec3(in.tangent, i), l, v);
      if constexpr (takes_point)
        point = {.object_position = vec3(in.object_position, i),
                 .u = Batch::load(in.texcoord[0] + i),
                 .v = Batch::load(in.texcoord[1] + i)};
      const auto result = above_horizon(formula, cosines(n, l, v), frame, point);
      store(result.diffuse, out.diffuse, i);
      store(result.glossy, out.glossy, i);
    }
  }

  Reflection<double> evaluate(const Vec3<double>& l, const Vec3<double>& v,
                              const SurfacePoint<double>& point) const override {
    return query(l, v, point);
  }
  Reflection<float> evaluate(const Vec3<float>& l, const Vec3<float>& v,
                             const SurfacePoint<float>& point) const override {
    return query(l, v, point);
  }

 private:
  template <class T>
  Reflection<T> query(const Vec3<T>& l, const Vec3<T>& v, const SurfacePoint<T>& point) const {
    if (!(v.z > 0)) return {};
    const Vec3<T> n{0, 0, 1}, t{1, 0, 0};
    return above_horizon(formula_, cosines(n, l, v), shading_frame(n, t, l, v), point);
  }

  template <class T>
  static Reflection<T> above_horizon(const Formula& formula, const Cosines<T>& c,
                                     [[maybe_unused]] const ShadingFrame<T>& frame,
                                     [[maybe_unused]] const SurfacePoint<T>& point) {
    Reflection<T> value;
    if constexpr (takes_both)
      value = formula(c, frame, point);
    else if constexpr (takes_frame)
      value = formula(c, frame);
    else if constexpr (takes_point)
      value = formula(c, point);
    else
      value = formula(c);
    const auto lit = c.n_l > T(0);
    const auto mask = [&](const Rgb<T>& a) -> Rgb<T> {
      return {select(lit, a.r, T(0)), select(lit, a.g, T(0)), select(lit, a.b, T(0))};
    };
    return {mask(value.diffuse), mask(value.glossy)};
  }

  Formula formula_;
};

}  // namespace scanlit
