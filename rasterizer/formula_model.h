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
// Below the horizon (n_l <= 0) its result, whatever it is, is thrown away.
//
// Its parameters are members. A formula whose parameters are to vary over the surface, too, is a
// template over their type, `template <class P = double>`: see models/formula.h.
#pragma once

#include <type_traits>
#include <utility>

#include "rasterizer/batch.h"
#include "rasterizer/batch_trigonometry.h"
#include "rasterizer/reflection_model.h"
#include "rasterizer/scalar_math.h"

namespace scanlit {

/// A cosine that also knows its angle's versine, 1 - cos. Used as a number it is the cosine. Near 1
/// a float cosine has lost the angle; the versine, formed as a sum of squares, has not.
template <class T>
struct Cosine {
  T cos{};
  T versine{};
  operator const T&() const { return cos; }

  static Cosine of_versine(const T& versine) { return {.cos = T(1) - versine, .versine = versine}; }

  /// sin^2 of the angle, without the cancellation of 1 - cos^2 near 0.
  T sin2() const { return versine * (T(1) + cos); }
};

/// The angles of the lecture, as cosines.
template <class T>
struct Cosines {
  T n_l;          // N.L, in (-1, 1]
  T n_v;          // N.V, in [min_n_v, 1]
  Cosine<T> n_h;  // N.H, H half-way between L and V
  T v_h;          // V.H = L.H, in [0, 1]
  // 1 - N.L and 1 - N.V as sums of squares: what a formula in angles has near the normal, where the
  // cosines have lost them. They cost nothing where they are not used.
  T n_l_versine, n_v_versine;
};

/// The directions in the shading frame: x tangent, y bitangent, z normal; unit.
template <class T>
struct ShadingFrame {
  Vec3<T> l, v, h;
};

/// cos^n for n >= 0. Maximum error in float and Batch: (1 + |n log cos|) * 1.6e-7 relative, also
/// for n = 1e5, because the logarithm is taken of 1 - versine unrounded: the rounding of the cosine
/// would be magnified n times.
template <class T>
T pow(const Cosine<T>& c, const T& n) {
  const T one(1), zero(0);
  const T lost =
      (one - c.cos) - c.versine;  // by rounding to the cosine; both differences are exact
  const T power = exp(n * log_sum(max(c.cos, T(1e-37)), lost));
  return select(c.cos > zero, power, select(n > zero, zero, one));
}

/// The angle in radians, from its versine: alpha = 2 asin(sqrt(versine / 2)). Maximum error in
/// float and Batch, versine in [0, 1]: 4e-7 relative, also near 0, where the acos of a rounded
/// cosine would be off by up to 2.4e-4 rad.
template <class T>
T angle(const Cosine<T>& c) {
  return T(2) * asin(sqrt(T(0.5) * c.versine));
}
/// Its square, for lobes in alpha^2. Maximum error: 8e-7 relative.
template <class T>
T angle2(const Cosine<T>& c) {
  const T alpha = angle(c);
  return alpha * alpha;
}

/// The cosines of unit n, l and v, without cancellation: H's direction is s = l + v, V.H = |s| / 2,
/// and 1 - N.H = |H - N|^2 / 2. This is the one place where N.V is clamped (min_n_v). None exceeds
/// 1, as the dot product of two rounded unit vectors may: sqrt(1 - n_l * n_l) would be NaN.
template <class T>
Cosines<T> cosines(const Vec3<T>& n, const Vec3<T>& l, const Vec3<T>& v) {
  const Vec3<T> s = l + v;
  // Where l = -v, H has no direction: 0/0 without the bound. Taken as perpendicular to N.
  const T s2 = dot(s, s), tiny(1e-20);
  const T inverse_length = T(1) / sqrt(max(s2, tiny));
  const Vec3<T> h_n = s * inverse_length - n;
  const T versine = select(s2 < tiny, T(1), T(0.5) * dot(h_n, h_n));
  const T one(1), half(0.5);
  const Vec3<T> l_n = l - n, v_n = v - n;
  return {.n_l = min(one, dot(n, l)),
          .n_v = min(one, max(dot(n, v), T(min_n_v))),
          .n_h = Cosine<T>::of_versine(versine),
          .v_h = min(one, half * (s2 * inverse_length)),
          .n_l_versine = half * dot(l_n, l_n),
          .n_v_versine = min(half * dot(v_n, v_n), T(1 - min_n_v))};
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

/// What a formula's call operator takes.
template <class Formula>
struct Takes {
  template <class... Arguments>
  static constexpr bool invocable = std::is_invocable_v<const Formula&, Arguments...>;
  static constexpr bool both = invocable<Cosines<float>, ShadingFrame<float>, SurfacePoint<float>>;
  static constexpr bool frame = invocable<Cosines<float>, ShadingFrame<float>> || both;
  static constexpr bool point = invocable<Cosines<float>, SurfacePoint<float>> || both;
  static_assert(invocable<Cosines<float>> || frame || point, "see the top of this file");
};

/// What a formula needs of the engine. One that takes the shading frame but, with the parameters it
/// has, makes no use of it, says so by a member `bool isotropic() const`.
template <class Formula>
Needs needs_of(const Formula& formula) {
  Needs needs{.frame = Takes<Formula>::frame, .surface_point = Takes<Formula>::point};
  if constexpr (requires { formula.isotropic(); }) needs.frame = !formula.isotropic();
  return needs;
}

/// The formula's value; 0 where the light is below the horizon.
template <class T, class Formula>
Reflection<T> above_horizon(const Formula& formula, const Cosines<T>& c,
                            [[maybe_unused]] const ShadingFrame<T>& frame,
                            [[maybe_unused]] const SurfacePoint<T>& point) {
  Reflection<T> value;
  if constexpr (Takes<Formula>::both)
    value = formula(c, frame, point);
  else if constexpr (Takes<Formula>::frame)
    value = formula(c, frame);
  else if constexpr (Takes<Formula>::point)
    value = formula(c, point);
  else
    value = formula(c);
  const auto lit = c.n_l > T(0);
  const auto mask = [&](const Rgb<T>& a) -> Rgb<T> {
    return {select(lit, a.r, T(0)), select(lit, a.g, T(0)), select(lit, a.b, T(0))};
  };
  return {mask(value.diffuse), mask(value.glossy)};
}

/// A single query, in the shading frame.
template <class T, class Formula>
Reflection<T> query(const Formula& formula, const Vec3<T>& l, const Vec3<T>& v,
                    const SurfacePoint<T>& point) {
  if (!(v.z > 0)) return {};
  const Vec3<T> n{T(0), T(0), T(1)}, t{T(1), T(0), T(0)};
  return above_horizon(formula, cosines(n, l, v), shading_frame(n, t, l, v), point);
}

// A vector of a span's points, from point i on.
inline Vec3<Batch> load_vec3(const float* const* a, std::size_t i) {
  return {Batch::load(a[0] + i), Batch::load(a[1] + i), Batch::load(a[2] + i)};
}
inline Rgb<Batch> load_rgb(const float* const* a, std::size_t i) {
  return {Batch::load(a[0] + i), Batch::load(a[1] + i), Batch::load(a[2] + i)};
}
inline SurfacePoint<Batch> load_point(const PointSpan& points, std::size_t i) {
  return {.object_position = load_vec3(points.object_position, i),
          .u = Batch::load(points.texcoord[0] + i),
          .v = Batch::load(points.texcoord[1] + i),
          .vertex_colour = load_rgb(points.vertex_colour, i)};
}
inline void store(const Reflection<Batch>& value, const ReflectionSpan& out, std::size_t i) {
  value.diffuse.r.store(out.diffuse[0] + i), value.glossy.r.store(out.glossy[0] + i);
  value.diffuse.g.store(out.diffuse[1] + i), value.glossy.g.store(out.glossy[1] + i);
  value.diffuse.b.store(out.diffuse[2] + i), value.glossy.b.store(out.glossy[2] + i);
}

template <class Formula>
class FormulaModel final : public ReflectionModel {
  static constexpr std::size_t block_vectors = Batch::lanes == 4 ? 4 : 2;
  // A formula that owns tables is not copied.
  using LocalFormula =
      std::conditional_t<std::is_trivially_copyable_v<Formula>, const Formula, const Formula&>;

 public:
  explicit FormulaModel(Formula formula) : formula_(std::move(formula)) {}

  Needs needs() const override { return needs_of(formula_); }

  // Inlined whole (flatten), whatever the size of the author's formula: a call in the loop would
  // pass its vectors through memory.
  [[gnu::flatten]] void evaluate(const DirectionSpan& directions,
                                 const ReflectionSpan& reflection) const override {
    // Local copies, because a vector store may alias whatever is behind a reference: pointers and
    // parameters would be loaded, and converted to Batch, again for every vector.
    const DirectionSpan in = directions;
    const ReflectionSpan out = reflection;
    const LocalFormula formula = formula_;
    constexpr std::size_t lanes = Batch::lanes, several = block_vectors * lanes;
    std::size_t i = 0;
    for (; i + several <= in.size; i += several) evaluate_block<block_vectors>(formula, in, out, i);
    for (; i < in.size; i += lanes) evaluate_block<1>(formula, in, out, i);
  }

  Reflection<double> evaluate(const Vec3<double>& l, const Vec3<double>& v,
                              const SurfacePoint<double>& point) const override {
    return query(formula_, l, v, point);
  }
  Reflection<float> evaluate(const Vec3<float>& l, const Vec3<float>& v,
                             const SurfacePoint<float>& point) const override {
    return query(formula_, l, v, point);
  }

 private:
  /// `vectors` whole vectors of points from point `first` on. First all cosines, then all formulas:
  /// each is one long chain of dependent operations, and the shorter the chain, the more points the
  /// processor works on at a time.
  template <std::size_t vectors>
  static void evaluate_block(const Formula& formula, const DirectionSpan& in,
                             const ReflectionSpan& out, std::size_t first) {
    constexpr std::size_t lanes = Batch::lanes;
    Cosines<Batch> c[vectors];
#pragma GCC unroll 4
    for (std::size_t k = 0; k < vectors; ++k) {
      const std::size_t i = first + k * lanes;
      c[k] =
          cosines(load_vec3(in.normal, i), load_vec3(in.to_light, i), load_vec3(in.to_viewer, i));
    }
#pragma GCC unroll 4
    for (std::size_t k = 0; k < vectors; ++k) {
      const std::size_t i = first + k * lanes;
      ShadingFrame<Batch> frame;
      if constexpr (Takes<Formula>::frame)
        if (in.tangent[0])
          frame = shading_frame(load_vec3(in.normal, i), load_vec3(in.tangent, i),
                                load_vec3(in.to_light, i), load_vec3(in.to_viewer, i));
      SurfacePoint<Batch> point;
      if constexpr (Takes<Formula>::point) point = load_point(*in.points, i);
      store(above_horizon(formula, c[k], frame, point), out, i);
    }
  }

  Formula formula_;
};

}  // namespace scanlit
