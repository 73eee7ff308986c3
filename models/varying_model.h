// A model whose parameters vary over the surface: the same formula, with the vector type in place
// of double as the type of its parameters.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "models/formula_parameter.h"
#include "rasterizer/formula_model.h"

namespace scanlit::models {

/// Which parameter varies, in the order of the description, and what it is.
struct Varying {
  std::size_t parameter;
  std::shared_ptr<const Input> input;
};

/// Formula is the formula with constant parameters, Formula<double>.
template <class Formula>
class VaryingModel final : public ReflectionModel {
  template <class T>
  using Of = typename WithParameters<Formula>::template Of<T>;

 public:
  VaryingModel(Formula constants, std::vector<Varying> varying)
      : constants_(std::move(constants)), varying_(std::move(varying)) {
    needs_ = needs_of(constants_);
    needs_.surface_point = true;
    for (const Varying& v : varying_) {
      const auto& p = parameters<double>()[v.parameter];
      needs_.parameters += p.channels();
      needs_.frame |= p.direction() != nullptr;
      needs_.texcoord_derivatives |= v.input->needs_texcoord_derivatives();
    }
  }

  Needs needs() const override { return needs_; }

  void evaluate_parameters(const PointSpan& points, float* const* out) const override {
    for (const Varying& v : varying_) {
      const auto& p = parameters<double>()[v.parameter];
      v.input->evaluate(points, p.channels(), out);
      if (p.direction())
        into_shading_frame(points, out);
      else
        for (std::size_t c = 0; c < p.channels(); ++c) clamp(p, points.size, out[c]);
      out += p.channels();
    }
  }

  void evaluate(const DirectionSpan& in, const ReflectionSpan& out) const override {
    Of<Batch> formula = with_constants<Batch>();
    for (std::size_t i = 0; i < in.size; i += Batch::lanes) {
      set_varying(formula,
                  [&](std::size_t array) { return Batch::load(in.parameters[array] + i); });
      const Vec3<Batch> n = load_vec3(in.normal, i), l = load_vec3(in.to_light, i),
                        v = load_vec3(in.to_viewer, i);
      ShadingFrame<Batch> frame;
      if (in.tangent[0]) frame = shading_frame(n, load_vec3(in.tangent, i), l, v);
      store(above_horizon(formula, cosines(n, l, v), frame, load_point(*in.points, i)), out, i);
    }
  }

  std::size_t radiance(const ViewedSpan& in, std::span<const LightSource> lights,
                       const RadianceSpan& out) const override {
    Of<Batch> formula = with_constants<Batch>();
    std::size_t evaluations = 0;
    for (std::size_t i = 0; i < in.size; i += Batch::lanes) {
      set_varying(formula,
                  [&](std::size_t array) { return Batch::load(in.parameters[array] + i); });
      const auto reflect = [&](std::size_t, const Cosines<Batch>& c, const Vec3<Batch>& l,
                               const Vec3<Batch>& h) {
        ShadingFrame<Batch> frame;
        if (in.tangent[0]) frame = frame_of(in, i, l, h);
        return value_of(formula, c, frame, load_point(*in.points, i));
      };
      evaluations += radiance_of_block<1>(in, lights, out, i, reflect);
    }
    return evaluations;
  }

  Reflection<double> evaluate(const Vec3<double>& l, const Vec3<double>& v,
                              const SurfacePoint<double>& point) const override {
    return query_at(l, v, point);
  }
  Reflection<float> evaluate(const Vec3<float>& l, const Vec3<float>& v,
                             const SurfacePoint<float>& point) const override {
    return query_at(l, v, point);
  }

 private:
  template <class T>
  static const std::vector<Parameter<Of<T>>>& parameters() {
    static const std::vector<Parameter<Of<T>>> all = Of<T>::describe().parameters;
    return all;
  }

  template <class T>
  Of<T> with_constants() const {
    Of<T> result;
    for (std::size_t i = 0; i < parameters<T>().size(); ++i) {
      const auto& from = parameters<double>()[i];
      const auto& to = parameters<T>()[i];
      if (const auto* number = to.number()) result.** number = T(constants_.**from.number());
      if (const auto* choice = to.choice()) result.** choice = constants_.**from.choice();
      if (const auto* colour = to.colour()) {
        const Rgb<double>& c = constants_.**from.colour();
        result.** colour = {T(c.r), T(c.g), T(c.b)};
      }
      if (const auto* direction = to.direction()) {
        const Vec3<double>& d = constants_.**from.direction();
        result.** direction = {T(d.x), T(d.y), T(d.z)};
      }
    }
    return result;
  }

  /// `value(k)` is the k-th of the arrays that evaluate_parameters() fills.
  template <class T, class Value>
  void set_varying(Of<T>& formula, const Value& value) const {
    std::size_t k = 0;
    for (const Varying& v : varying_) {
      const auto& p = parameters<T>()[v.parameter];
      if (const auto* number = p.number()) formula.** number = value(k);
      if (const auto* colour = p.colour())
        formula.** colour = {value(k), value(k + 1), value(k + 2)};
      if (const auto* direction = p.direction())
        formula.** direction = {value(k), value(k + 1), value(k + 2)};
      k += p.channels();
    }
    if constexpr (requires { formula.prepare(); }) formula.prepare();
  }

  /// Into the parameter's range; NaN becomes its lower end.
  static void clamp(const Parameter<Formula>& p, std::size_t size, float* values) {
    for (std::size_t i = 0; i < size; i += Batch::lanes)
      min(max(Batch::load(values + i), Batch(p.min)), Batch(p.max)).store(values + i);
  }

  /// A direction of object space, in place. One of no length becomes the tangent.
  static void into_shading_frame(const PointSpan& points, float* const* direction) {
    const auto& m = points.world_from_object;
    // Only its direction matters; the squares of a very large or small object's would leave float.
    float largest = 1e-30f;
    for (const auto& column : m)
      for (const float entry : column) largest = std::max(largest, std::abs(entry));
    for (std::size_t i = 0; i < points.size; i += Batch::lanes) {
      const Vec3<Batch> d = load_vec3(direction, i) * Batch(1 / largest);
      const auto row = [&](int r) {
        return d.x * Batch(m[0][r]) + d.y * Batch(m[1][r]) + d.z * Batch(m[2][r]);
      };
      const Vec3<Batch> world{row(0), row(1), row(2)};
      const Vec3<Batch> n = load_vec3(points.normal, i), t = load_vec3(points.tangent, i);
      const Batch length2 = dot(world, world),
                  inverse = Batch(1) / sqrt(max(length2, Batch(1e-30f)));
      const auto has_length = length2 > Batch(1e-30f);  // else 0/0
      select(has_length, dot(t, world) * inverse, Batch(1)).store(direction[0] + i);
      select(has_length, dot(cross(n, t), world) * inverse, Batch(0)).store(direction[1] + i);
      select(has_length, dot(n, world) * inverse, Batch(0)).store(direction[2] + i);
    }
  }

  /// Inputs are evaluated in float, whatever the query's precision.
  template <class T>
  Reflection<T> query_at(const Vec3<T>& l, const Vec3<T>& v, const SurfacePoint<T>& point) const {
    const Vec3<T>& at = point.object_position;
    const Rgb<T>& rgb = point.vertex_colour;
    float one_point[14][max_lanes] = {};
    const T values[14] = {at.x,  at.y, at.z, point.u, point.v, rgb.r, rgb.g,
                          rgb.b, 0,    0,    1,       1,       0,     0};
    for (std::size_t k = 0; k < 14; ++k) std::fill_n(one_point[k], max_lanes, float(values[k]));
    PointSpan points{.size = 1};
    for (int c = 0; c < 3; ++c) {
      points.object_position[c] = one_point[c];
      if (c < 2) points.texcoord[c] = one_point[3 + c];
      points.vertex_colour[c] = one_point[5 + c];
      points.normal[c] = one_point[8 + c];
      points.tangent[c] = one_point[11 + c];
    }
    std::vector<float> storage(needs_.parameters * max_lanes);
    std::vector<float*> arrays(needs_.parameters);
    for (std::size_t k = 0; k < arrays.size(); ++k) arrays[k] = &storage[k * max_lanes];
    evaluate_parameters(point.drawn ? *point.drawn : points, arrays.data());
    Of<T> formula = with_constants<T>();
    set_varying(formula, [&](std::size_t k) { return T(arrays[k][0]); });
    return query(formula, l, v, point);
  }

  Formula constants_;
  std::vector<Varying> varying_;
  Needs needs_;
};

}  // namespace scanlit::models
