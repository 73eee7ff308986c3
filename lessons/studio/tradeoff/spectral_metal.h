// A metal's Fresnel reflectance summed over the spectrum at every point that is lit, as physics has
// it and no renderer of three channels does.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "rasterizer/reflection_model.h"

namespace scanlit::studio {

/// A microfacet model without Fresnel reflectance (F=one), times that of a metal at 81 wavelengths,
/// 380 to 780 nm, in linear sRGB and clamped to [0, 1], as MetalFresnel clamps it.
class SpectralMetal final : public ReflectionModel {
 public:
  SpectralMetal(std::shared_ptr<const ReflectionModel> facets, std::string_view metal);

  Needs needs() const override { return facets_->needs(); }
  void evaluate(const DirectionSpan& in, const ReflectionSpan& out) const override;
  Reflection<double> evaluate(const Vec3<double>& l, const Vec3<double>& v,
                              const SurfacePoint<double>& point) const override;
  Reflection<float> evaluate(const Vec3<float>& l, const Vec3<float>& v,
                             const SurfacePoint<float>& point) const override;

 private:
  struct Wavelength {
    double n, k;
    Rgb<double> weight;  // its share of linear sRGB
  };

  /// Of directions in any one space.
  template <class T>
  Rgb<T> fresnel(const Vec3<T>& l, const Vec3<T>& v) const;

  std::shared_ptr<const ReflectionModel> facets_;
  std::vector<Wavelength> spectrum_;
};

}  // namespace scanlit::studio
