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

#include "rasterizer/bounded_directions.h"
#include "rasterizer/radiance.h"

namespace scanlit {

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

/// Whether a formula is evaluated over bounds (bounded.h): not if it looks at the surface point, of
/// which nothing is known, or if it calls what Bounded has not and says so by a member
/// `static constexpr bool has_bounds = false`.
template <class Formula>
constexpr bool has_bounds() {
  if constexpr (requires { Formula::has_bounds; }) return Formula::has_bounds;
  return !Takes<Formula>::point;
}

/// The formula's value, whatever it is where the light is below the horizon.
template <class T, class Formula>
Reflection<T> value_of(const Formula& formula, const Cosines<T>& c,
                       [[maybe_unused]] const ShadingFrame<T>& frame,
                       [[maybe_unused]] const SurfacePoint<T>& point) {
  if constexpr (Takes<Formula>::both)
    return formula(c, frame, point);
  else if constexpr (Takes<Formula>::frame)
    return formula(c, frame);
  else if constexpr (Takes<Formula>::point)
    return formula(c, point);
  else
    return formula(c);
}

/// The formula's value; 0 where the light is below the horizon.
template <class T, class Formula>
Reflection<T> above_horizon(const Formula& formula, const Cosines<T>& c,
                            const ShadingFrame<T>& frame, const SurfacePoint<T>& point) {
  const Reflection<T> value = value_of(formula, c, frame, point);
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
  if (!(v.z > 0) && !point.drawn) return {};
  const Vec3<T> n{T(0), T(0), T(1)}, t{T(1), T(0), T(0)};
  return above_horizon(formula, cosines(n, l, v), shading_frame(n, t, l, v), point);
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

/// The shading frame at a vector of points.
inline ShadingFrame<Batch> frame_of(const ViewedSpan& in, std::size_t i, const Vec3<Batch>& l,
                                    const Vec3<Batch>& h) {
  const Vec3<Batch> v = in.to_viewer[0] ? load_vec3(in.to_viewer, i) : broadcast(in.far_viewer);
  return shading_frame(load_vec3(in.normal, i), load_vec3(in.tangent, i), l, v, h);
}

template <class Formula>
class FormulaModel final : public ReflectionModel {
  static constexpr std::size_t block_vectors = Batch::lanes == 4 ? 4 : 2;
  static constexpr std::size_t radiance_vectors = 8;
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

  // Flattened for the same reason.
  [[gnu::flatten]] std::size_t radiance(const ViewedSpan& viewed,
                                        std::span<const LightSource> lights,
                                        const RadianceSpan& sent) const override {
    const ViewedSpan in = viewed;
    const RadianceSpan out = sent;
    const LocalFormula formula = formula_;
    const auto reflect = [&](std::size_t i, const Cosines<Batch>& c,
                             [[maybe_unused]] const Vec3<Batch>& l,
                             [[maybe_unused]] const Vec3<Batch>& h) {
      ShadingFrame<Batch> frame;
      if constexpr (Takes<Formula>::frame)
        if (in.tangent[0]) frame = frame_of(in, i, l, h);
      SurfacePoint<Batch> point;
      if constexpr (Takes<Formula>::point) point = load_point(*in.points, i);
      return value_of(formula, c, frame, point);
    };
    constexpr std::size_t several = radiance_vectors * std::size_t(Batch::lanes);
    std::size_t evaluations = 0;
    for (std::size_t i = 0; i < in.size; i += several)
      evaluations += radiance_of_block<radiance_vectors>(in, lights, out, i, reflect);
    return evaluations;
  }

  // Not inlined: once for many points, it need not be fast, and the compiler would take long.
  bool bounds([[maybe_unused]] const BoundedCosines& in,
              [[maybe_unused]] BoundedReflection& out) const override {
    if constexpr (has_bounds<Formula>()) {
      const bool framed = needs_of(formula_).frame;
      if (framed && !in.axes) return false;
      ShadingFrame<Bounded> frame;
      if constexpr (Takes<Formula>::frame)
        if (framed) frame = shading_frame(in);
      out.value = value_of(formula_, in.cosines, frame, SurfacePoint<Bounded>{});
      return true;
    }
    return false;
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
