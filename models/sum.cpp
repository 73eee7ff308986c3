#include "models/sum.h"

#include <charconv>
#include <cmath>

#include "models/scratch_span.h"
#include "rasterizer/batch.h"
#include "rasterizer/bounded_directions.h"
#include "rasterizer/error.h"

namespace scanlit::models {

Sum::Sum(std::vector<Term> terms) : terms_(std::move(terms)) {
  for (const Term& term : terms_) {
    const Needs needs = term.model->needs();
    needs_.frame |= needs.frame;
    needs_.surface_point |= needs.surface_point;
    needs_.texcoord_derivatives |= needs.texcoord_derivatives;
    needs_.parameters += needs.parameters;
  }
}

void Sum::evaluate_parameters(const PointSpan& points, float* const* out) const {
  for (const Term& term : terms_) {
    if (const std::size_t count = term.model->needs().parameters) {
      term.model->evaluate_parameters(points, out);
      out += count;
    }
  }
}

void Sum::evaluate(const DirectionSpan& in, const ReflectionSpan& out) const {
  ScratchReflection scratch(in.size);
  DirectionSpan of_term = in;
  bool first = true;
  for (const auto& [weight, model] : terms_) {
    model->evaluate(of_term, scratch.span);
    if (of_term.parameters) of_term.parameters += model->needs().parameters;
    const auto add = [&, w = Batch(weight)](const float* from, float* to) {
      for (std::size_t i = 0; i < in.size; i += Batch::lanes) {
        const Batch value = w * Batch::load(from + i);
        (first ? value : Batch::load(to + i) + value).store(to + i);
      }
    };
    for (int c = 0; c < 3; ++c) {
      add(scratch.span.diffuse[c], out.diffuse[c]);
      add(scratch.span.glossy[c], out.glossy[c]);
    }
    first = false;
  }
}

bool Sum::bounds(const BoundedCosines& in, BoundedReflection& out) const {
  out.value = {Rgb<Bounded>(Bounded(0)), Rgb<Bounded>(Bounded(0))};
  for (const auto& [weight, model] : terms_) {
    BoundedReflection term;
    if (!model->bounds(in, term)) return false;
    out.value.diffuse = out.value.diffuse + term.value.diffuse * Bounded(weight);
    out.value.glossy = out.value.glossy + term.value.glossy * Bounded(weight);
  }
  return true;
}

namespace {

template <class T>
Reflection<T> query(const std::vector<Term>& terms, const Vec3<T>& l, const Vec3<T>& v,
                    const SurfacePoint<T>& point) {
  Reflection<T> sum;
  for (const auto& [weight, model] : terms) {
    const Reflection<T> value = model->evaluate(l, v, point);
    sum = {sum.diffuse + value.diffuse * T(weight), sum.glossy + value.glossy * T(weight)};
  }
  return sum;
}

constexpr double max_weight = 100;

/// "(MODEL)" or "NUMBER*(MODEL)".
Term read_term(const std::string& text, const Context& context) {
  const auto refuse = [&] {
    throw Error(
        context.where,
        "wants models, (MODEL) or .5*(MODEL), with factors from 0 to 100; not '" + text + "'");
  };
  const auto open = text.find('(');
  if (open == text.npos || text.back() != ')') refuse();
  double weight = 1;
  if (open > 0) {
    const auto [end, problem] = std::from_chars(text.data(), text.data() + open, weight);
    if (problem != std::errc() || end != text.data() + open - 1 || *end != '*') refuse();
  }
  if (!(weight >= 0 && weight <= max_weight)) refuse();
  return {weight, make(without_parentheses(std::string_view(text).substr(open)), context).model};
}

NamedModel make_sum(const ModelInfo&, std::span<const Argument> arguments, const Context& context) {
  if (arguments.empty()) throw Error(context.where, "of which models? sum:(MODEL),.5*(MODEL)");
  std::vector<Term> terms;
  for (const auto& [key, value] : arguments)
    terms.push_back(read_term(key.empty() ? value : key + "=" + value, context));
  return {.model = std::make_shared<Sum>(std::move(terms))};
}

}  // namespace

Reflection<double> Sum::evaluate(const Vec3<double>& l, const Vec3<double>& v,
                                 const SurfacePoint<double>& point) const {
  return query(terms_, l, v, point);
}
Reflection<float> Sum::evaluate(const Vec3<float>& l, const Vec3<float>& v,
                                const SurfacePoint<float>& point) const {
  return query(terms_, l, v, point);
}

Entry sum_entry() {
  return {.info = {.year = 2026,
                   .name = "sum",
                   .title = "A sum of models, each with a factor: sum:(MODEL),.5*(MODEL),...",
                   .source = "reflectances add",
                   .reciprocal = true,
                   .energy_bounded = false,
                   .exceptions = "reciprocal where its models are",
                   .example = "sum:.7*(lambert:kd=.8/.3/.2),(ward)"},
          .make = &make_sum};
}

}  // namespace scanlit::models
