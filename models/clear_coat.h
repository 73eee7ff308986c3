// A clear coat over any model: varnish, glaze, the clear layer of car paint.
//
//   f = D G F / (4 (N.L) (N.V)) + T_l T_v / eta^2 f_base(l', v')
//
// The coat's surface mirrors: GGX, Smith's height-correlated G, and F of a dielectric. What enters,
// T = 1 - F, is refracted: l' and v' are l and v inside the coat, (N.L')^2 = 1 - (1 - (N.L)^2) /
// eta^2. 1 / eta^2 is the change of solid angle: dw (N.L) = eta^2 dw' (N.L'). Andrea Weidlich and
// Alexander Wilkie, "Arbitrarily layered micro-facet surfaces", GRAPHITE 2007, refract both
// directions so; nothing is absorbed here, and T is that of a smooth coat, however rough it is.
//
// Of the light that a diffuse base sends up, more than half is reflected back down by the coat's
// inner side, and so on: the base's diffuse part is divided by 1 - kd F_int, with F_int the mean
// reflectance from inside. J. L. Saunderson, "Calculation of the color of pigmented plastics", JOSA
// 32(12), 1942. This makes coated colours deeper. kd is the base's diffuse part at l = v = N, taken
// as 1 at most. Light that the base's glossy part sends up leaves once and is not followed further.
//
//   base     the model under the coat
//   eta      the coat's index of refraction
//   a        roughness of its surface (models/microfacet/ggx.h)
#pragma once

#include <memory>

#include "models/fresnel.h"
#include "models/microfacet/ggx.h"
#include "models/microfacet/masking.h"
#include "models/registry.h"

namespace scanlit::models {

/// The coat by itself.
struct Coat {
  double eta = 1.5;
  double a = 0.05;

  /// N.L' of N.L. Written as a sum, which does not cancel; at eta = 1 it is N.L.
  template <class T>
  T refracted_cosine(const T& n_l) const {
    return sqrt(max(T((eta - 1) * (eta + 1)) + n_l * n_l, T(1e-30))) * T(1 / eta);
  }

  /// d' of d, with N.d' known: what is parallel to the surface becomes shorter by eta.
  template <class T>
  Vec3<T> refracted(const Vec3<T>& d, const Vec3<T>& n, const T& cosine) const {
    const T n_d = dot(n, d);
    return (d - n * n_d) * T(1 / eta) + n * cosine;
  }

  template <class T>
  T glossy(const Cosines<T>& c) const {
    const microfacet::Ggx<microfacet::Isotropic<double>> ggx{{a}};
    const Vec3<T> unused{};
    const T lambdas = ggx.lambda(c.n_l, unused) + ggx.lambda(c.n_v, unused);
    return T(std::numbers::pi / 4) * ggx(c.n_h, unused) * dielectric_reflectance(c.v_h, T(eta)) /
           ((T(1) + lambdas) * c.n_v);
  }

  /// What the base's pi f_base (N.L') is multiplied by to become pi f (N.L). 0 below the horizon.
  template <class T>
  T transmitted(const Cosines<T>& c, const T& refracted_n_l) const {
    const auto entering = [this](const T& n_d) {
      return T(1) - dielectric_reflectance(n_d, T(eta));
    };
    const T n_l = max(c.n_l, T(0));
    return entering(n_l) * entering(c.n_v) * T(1 / (eta * eta)) * n_l / refracted_n_l;
  }

  /// F_int: the reflectance from inside, averaged over diffuse light.
  double internal_reflectance() const;
};

class ClearCoat final : public ReflectionModel {
 public:
  ClearCoat(std::shared_ptr<const ReflectionModel> base, Coat coat);

  Needs needs() const override { return base_->needs(); }
  void evaluate_parameters(const PointSpan& points, float* const* out) const override {
    base_->evaluate_parameters(points, out);
  }
  void evaluate(const DirectionSpan& in, const ReflectionSpan& out) const override;
  Reflection<double> evaluate(const Vec3<double>& l, const Vec3<double>& v,
                              const SurfacePoint<double>& point) const override;
  Reflection<float> evaluate(const Vec3<float>& l, const Vec3<float>& v,
                             const SurfacePoint<float>& point) const override;

 private:
  template <class T>
  Reflection<T> query(const Vec3<T>& l, const Vec3<T>& v, const SurfacePoint<T>& point) const;
  template <class T>
  Rgb<T> deepened(const Rgb<T>& diffuse, const Rgb<T>& kd) const;

  std::shared_ptr<const ReflectionModel> base_;
  Coat coat_;
  double internal_;  // F_int
  bool varies_;      // the base's kd, over the surface
  Rgb<double> kd_;   // else this
};

Entry clear_coat_entry();
inline const bool clear_coat_registered = add(clear_coat_entry());

}  // namespace scanlit::models
