#include "scalar_path.h"

#include <glm/geometric.hpp>
#include <map>
#include <stdexcept>

#include "models/ashikhmin_shirley.h"
#include "models/blinn_phong.h"
#include "models/cook_torrance.h"
#include "models/finished_wood.h"
#include "models/lambert.h"
#include "models/oren_nayar.h"
#include "models/oren_nayar_full.h"
#include "models/phong.h"
#include "models/torrance_sparrow.h"
#include "models/ward.h"
#include "rasterizer/formula_model.h"

// Inlined whole: of a template's function that stays a call the linker might keep another file's
// copy, compiled with other flags.
#define SCANLIT_INLINED_WHOLE [[gnu::flatten]]

namespace scanlit::bench {

namespace {

template <class Array>
Vec3<float> load(const Array& a, std::size_t i) {
  return {a[0][i], a[1][i], a[2][i]};
}

template <class V>
Vec3<float> convert(const V& v) {
  return {float(v.x), float(v.y), float(v.z)};
}

Vec3<float> transform(const glm::mat3& m, const Vec3<float>& v) {
  const auto row = [&](int i) { return m[0][i] * v.x + m[1][i] * v.y + m[2][i] * v.z; };
  return {row(0), row(1), row(2)};
}

Vec3<float> normalize(const Vec3<float>& v) { return v * (1 / sqrt(dot(v, v))); }

template <class Formula>
Reflection<float> reflect(const Formula& formula, const Vec3<float>& n, const Vec3<float>& l,
                          const Vec3<float>& v, const float* const* tangent = nullptr,
                          std::size_t i = 0) {
  const Cosines<float> c = cosines(n, l, v);
  if (!(c.n_l > 0)) return {};
  if constexpr (Takes<Formula>::frame) {
    ShadingFrame<float> frame;
    if (tangent && tangent[0]) frame = shading_frame(n, load(tangent, i), l, v);
    return formula(c, frame);
  } else {
    return formula(c);
  }
}

template <class Formula>
SCANLIT_INLINED_WHOLE void evaluate_scalar(const Formula& formula, const DirectionSpan& in,
                                           const ReflectionSpan& out) {
  for (std::size_t i = 0; i < in.size; ++i) {
    const Reflection<float> value = reflect(formula, load(in.normal, i), load(in.to_light, i),
                                            load(in.to_viewer, i), in.tangent, i);
    out.diffuse[0][i] = value.diffuse.r, out.glossy[0][i] = value.glossy.r;
    out.diffuse[1][i] = value.diffuse.g, out.glossy[1][i] = value.glossy.g;
    out.diffuse[2][i] = value.diffuse.b, out.glossy[2][i] = value.glossy.b;
  }
}

template <class Formula>
SCANLIT_INLINED_WHOLE void light_scalar(const Formula& formula, const Frame& frame,
                                        const Draw& draw, SurfaceSpan& surface, LitSpan& lit) {
  const Light& source = frame.scene.lights[0];
  const Vec3<float> to_light = convert(glm::normalize(source.direction));
  const Rgb<float> tint = source.colour * float(source.intensity);
  const Vec3<float> eye = convert(frame.camera.eye);
  const glm::mat4& m = draw.object->world_from_object;
  const glm::mat3 linear(m);
  const Vec3<float> origin = convert(m[3]);
  for (std::size_t i = 0; i < std::size_t(surface.size); ++i) {
    const Vec3<float> position = transform(linear, load(surface.position, i)) + origin;
    const Vec3<float> to_viewer = normalize(eye - position);
    const Vec3<float> normal =
        normalize(transform(draw.normal_from_object, load(surface.normal, i)));
    surface.normal[0][i] = normal.x, surface.normal[1][i] = normal.y;
    surface.normal[2][i] = normal.z;
    const Reflection<float> value = reflect(formula, normal, to_light, to_viewer);
    const Rgb<float> diffuse = tint * value.diffuse, glossy = tint * value.glossy;
    lit.diffuse[0][i] = diffuse.r, lit.glossy[0][i] = glossy.r;
    lit.diffuse[1][i] = diffuse.g, lit.glossy[1][i] = glossy.g;
    lit.diffuse[2][i] = diffuse.b, lit.glossy[2][i] = glossy.b;
  }
}

template <class Formula>
ScalarPath path_of(const models::Values& values) {
  const auto formula = models::make_formula<Formula>(values);
  return {[formula](const DirectionSpan& in, const ReflectionSpan& out) {
            evaluate_scalar(formula, in, out);
          },
          [formula](const Frame& frame, const Draw& draw, SurfaceSpan& surface, LitSpan& lit) {
            light_scalar(formula, frame, draw, surface, lit);
          }};
}

}  // namespace

ScalarPath scalar_path(const std::string& specification) {
  static const std::map<std::string, ScalarPath (*)(const models::Values&)> paths = {
      {"lambert", &path_of<models::Lambert<>>},
      {"phong", &path_of<models::Phong<>>},
      {"blinn-phong", &path_of<models::BlinnPhong<>>},
      {"torrance-sparrow", &path_of<models::TorranceSparrow<>>},
      {"cook-torrance", &path_of<models::CookTorrance<>>},
      {"ward", &path_of<models::Ward<>>},
      {"oren-nayar", &path_of<models::OrenNayar<>>},
      {"oren-nayar-full", &path_of<models::OrenNayarFull<>>},
      {"ashikhmin-shirley", &path_of<models::AshikhminShirley<>>},
      {"finished-wood", &path_of<models::FinishedWood<>>},
  };
  const auto path = paths.find(specification.substr(0, specification.find(':')));
  if (path == paths.end()) throw std::logic_error("no scalar path of " + specification);
  return path->second(models::make(specification).values);
}

}  // namespace scanlit::bench
