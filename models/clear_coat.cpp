#include "models/clear_coat.h"

#include "models/scratch_span.h"

namespace scanlit::models {

// By what enters from outside: dw (N.L) = eta^2 dw' (N.L'), and T is the same from both sides, so
// that 1 - F_int = (1 - F_ext) / eta^2. From outside F is smooth, while from inside it has a kink
// at the critical angle, which would spoil Simpson's rule.
double internal_reflectance(double eta) {
  constexpr int panels = 2048;  // error below 1e-12
  const auto integrand = [eta](double c) { return 2 * c * dielectric_reflectance(c, eta); };
  double external = 0;
  for (int i = 0; i < panels; ++i) {
    const double from = double(i) / panels, to = double(i + 1) / panels;
    external += (integrand(from) + 4 * integrand((from + to) / 2) + integrand(to)) / (6 * panels);
  }
  return 1 - (1 - external) / (eta * eta);
}

ClearCoat::ClearCoat(std::shared_ptr<const ReflectionModel> base, Coat<> coat)
    : base_(std::move(base)), coat_(coat), internal_(internal_reflectance(coat.eta)) {
  varies_ = base_->needs().surface_point;
  kd_ = base_->evaluate(Vec3<double>{0, 0, 1}, Vec3<double>{0, 0, 1}).diffuse;
}

// d' of d, with N.d' known: what is parallel to the surface becomes shorter by eta.
template <class T>
Vec3<T> ClearCoat::refracted(const Vec3<T>& d, const Vec3<T>& n, const T& cosine) const {
  const T n_d = dot(n, d);
  return (d - n * n_d) * T(1 / coat_.eta) + n * cosine;
}

// What the base's pi f_base (N.L') is multiplied by to become pi f (N.L). 0 below the horizon; at
// the horizon, if eta = 1, 0/0 without the bound.
template <class T>
T ClearCoat::transmitted(const Cosines<T>& c, const T& refracted_n_l) const {
  const T n_l = max(c.n_l, T(0));
  return coat_.transmittance(n_l) * coat_.transmittance(c.n_v) * T(1 / (coat_.eta * coat_.eta)) *
         n_l / max(refracted_n_l, T(1e-15));
}

template <class T>
Rgb<T> ClearCoat::deepened(const Rgb<T>& diffuse, const Rgb<T>& kd) const {
  const auto channel = [this](const T& value, const T& albedo) {
    return value / (T(1) - T(internal_) * min(albedo, T(1)));
  };
  return {channel(diffuse.r, kd.r), channel(diffuse.g, kd.g), channel(diffuse.b, kd.b)};
}

namespace {

void store_vec3(const Vec3<Batch>& v, ScratchArrays& to, std::size_t array, std::size_t i) {
  v.x.store(to[array] + i), v.y.store(to[array + 1] + i), v.z.store(to[array + 2] + i);
}
void point_at(const float* (&to)[3], ScratchArrays& from, std::size_t array) {
  for (std::size_t c = 0; c < 3; ++c) to[c] = from[array + c];
}

}  // namespace

void ClearCoat::evaluate(const DirectionSpan& in, const ReflectionSpan& out) const {
  ScratchArrays inside(in.size, 6);
  for (std::size_t i = 0; i < in.size; i += Batch::lanes) {
    const Vec3<Batch> n = load_vec3(in.normal, i), l = load_vec3(in.to_light, i),
                      v = load_vec3(in.to_viewer, i);
    const Cosines<Batch> c = cosines(n, l, v);
    store_vec3(refracted(l, n, coat_.refracted_cosine(c.n_l)), inside, 0, i);
    store_vec3(refracted(v, n, coat_.refracted_cosine(c.n_v)), inside, 3, i);
  }
  DirectionSpan below = in;
  point_at(below.to_light, inside, 0), point_at(below.to_viewer, inside, 3);
  base_->evaluate(below, out);

  ScratchReflection head_on(varies_ ? in.size : 0);
  if (varies_) {
    for (int c = 0; c < 3; ++c) below.to_light[c] = below.to_viewer[c] = in.normal[c];
    base_->evaluate(below, head_on.span);
  }
  for (std::size_t i = 0; i < in.size; i += Batch::lanes) {
    const Cosines<Batch> c =
        cosines(load_vec3(in.normal, i), load_vec3(in.to_light, i), load_vec3(in.to_viewer, i));
    const Batch share = transmitted(c, coat_.refracted_cosine(c.n_l));
    const Rgb<Batch> kd = varies_ ? load_rgb(head_on.span.diffuse, i)
                                  : Rgb<Batch>{Batch(kd_.r), Batch(kd_.g), Batch(kd_.b)};
    const Batch mirrored = select(c.n_l > Batch(0), coat_.glossy(c), Batch(0));
    store(Reflection<Batch>{deepened(load_rgb(out.diffuse, i), kd) * share,
                            load_rgb(out.glossy, i) * share + Rgb<Batch>(mirrored)},
          out, i);
  }
}

template <class T>
Reflection<T> ClearCoat::query(const Vec3<T>& l, const Vec3<T>& v,
                               const SurfacePoint<T>& point) const {
  if (!(l.z > 0) || (!(v.z > 0) && !point.drawn)) return {};
  const Vec3<T> n{T(0), T(0), T(1)};
  const Cosines<T> c = cosines(n, l, v);
  const T n_l = coat_.refracted_cosine(c.n_l);
  const Reflection<T> base =
      base_->evaluate(refracted(l, n, n_l), refracted(v, n, coat_.refracted_cosine(c.n_v)), point);
  const Rgb<T> kd = varies_ ? base_->evaluate(n, n, point).diffuse : kd_ * T(1);
  const T share = transmitted(c, n_l);
  return {deepened(base.diffuse, kd) * share, base.glossy * share + Rgb<T>(coat_.glossy(c))};
}

Reflection<double> ClearCoat::evaluate(const Vec3<double>& l, const Vec3<double>& v,
                                       const SurfacePoint<double>& point) const {
  return query(l, v, point);
}
Reflection<float> ClearCoat::evaluate(const Vec3<float>& l, const Vec3<float>& v,
                                      const SurfacePoint<float>& point) const {
  return query(l, v, point);
}

namespace {

constexpr const char* default_base = "(lambert:kd=.7/.1/.05)";

NamedModel make_clear_coat(const ModelInfo& info, std::span<const Argument> arguments,
                           const Context& context) {
  Values values = read_values(context, info.parameters, arguments);
  const Value& base = value_of(values, "base");
  const auto* given = std::get_if<std::shared_ptr<const ReflectionModel>>(&base);
  auto model = std::make_shared<ClearCoat>(
      given ? *given : make(without_parentheses(default_base), context).model,
      Coat<>{std::get<double>(value_of(values, "eta")), std::get<double>(value_of(values, "a"))});
  return {.model = std::move(model), .values = std::move(values)};
}

}  // namespace

Entry clear_coat_entry() {
  return {.info = {.year = 2007,
                   .name = "clear-coat",
                   .title = "A clear coat over any model",
                   .source = "Weidlich and Wilkie 2007, Arbitrarily layered micro-facet surfaces; "
                             "Saunderson 1942, Calculation of the color of pigmented plastics",
                   .reciprocal = true,
                   .energy_bounded = true,
                   .exceptions = "where its base is",
                   .parameters = {{.key = "base",
                                   .kind = ParameterKind::model,
                                   .initial = std::string(default_base),
                                   .meaning = "the model under the coat"},
                                  {.key = "eta",
                                   .initial = 1.5,
                                   .min = 1,
                                   .max = 3,
                                   .meaning = "the coat's index of refraction"},
                                  {.key = "a",
                                   .initial = 0.05,
                                   .min = 1e-3,
                                   .max = 0.5,
                                   .meaning = "roughness of its surface (GGX)"}}},
          .make = &make_clear_coat};
}

}  // namespace scanlit::models
