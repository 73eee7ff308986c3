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

#include "models/coat.h"
#include "models/registry.h"

namespace scanlit::models {

/// F_int of an index of refraction: the reflectance from inside, averaged over diffuse light.
double internal_reflectance(double eta);

class ClearCoat final : public ReflectionModel {
 public:
  ClearCoat(std::shared_ptr<const ReflectionModel> base, Coat<> coat);

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
  Vec3<T> refracted(const Vec3<T>& d, const Vec3<T>& n, const T& cosine) const;
  template <class T>
  T transmitted(const Cosines<T>& c, const T& refracted_n_l) const;
  template <class T>
  Rgb<T> deepened(const Rgb<T>& diffuse, const Rgb<T>& kd) const;

  std::shared_ptr<const ReflectionModel> base_;
  Coat<> coat_;
  double internal_;  // F_int
  bool varies_;      // the base's kd, over the surface
  Rgb<double> kd_;   // else this
};

Entry clear_coat_entry();
inline const bool clear_coat_registered = add(clear_coat_entry());

}  // namespace scanlit::models
