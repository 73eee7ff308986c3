#include "lessons/studio/tradeoff/spectral_metal.h"

#include <cmath>
#include <utility>

#include "models/fresnel.h"
#include "models/metals.h"
#include "models/spectrum.h"

namespace scanlit::studio {

SpectralMetal::SpectralMetal(std::shared_ptr<const ReflectionModel> facets, std::string_view name)
    : facets_(std::move(facets)) {
  const models::Metal& metal = models::find_metal(name);
  // The sum over the spectrum is linear: a wavelength's weight is the colour of its line alone.
  for (double nm = models::first_wavelength_nm; nm <= models::last_wavelength_nm; nm += 5) {
    const auto line = [nm](double at_nm) { return std::abs(at_nm - nm) < 1 ? 1.0 : 0.0; };
    const auto constants = metal.at(nm);
    spectrum_.push_back({constants.n, constants.k, models::linear_srgb(line)});
  }
}

template <class T>
Rgb<T> SpectralMetal::fresnel(const Vec3<T>& l, const Vec3<T>& v) const {
  const Vec3<T> s = l + v;
  const T v_h = min(T(0.5) * sqrt(dot(s, s)), T(1));
  Rgb<T> sum{T(0), T(0), T(0)};
  for (const auto& [n, k, weight] : spectrum_)
    sum = sum + weight * models::conductor_reflectance(v_h, T(n), T(k));
  const auto shown = [](const T& value) { return min(max(value, T(0)), T(1)); };
  return {shown(sum.r), shown(sum.g), shown(sum.b)};
}

Reflection<double> SpectralMetal::evaluate(const Vec3<double>& l, const Vec3<double>& v,
                                           const SurfacePoint<double>& point) const {
  const auto [diffuse, glossy] = facets_->evaluate(l, v, point);
  return {diffuse, glossy * fresnel(l, v)};
}
Reflection<float> SpectralMetal::evaluate(const Vec3<float>& l, const Vec3<float>& v,
                                          const SurfacePoint<float>& point) const {
  const auto [diffuse, glossy] = facets_->evaluate(l, v, point);
  return {diffuse, glossy * fresnel(l, v)};
}

void SpectralMetal::evaluate(const DirectionSpan& in, const ReflectionSpan& out) const {
  facets_->evaluate(in, out);
  for (std::size_t i = 0; i < in.size; i += Batch::lanes) {
    const auto at = [i](const float* const(&a)[3]) {
      return Vec3<Batch>{Batch::load(a[0] + i), Batch::load(a[1] + i), Batch::load(a[2] + i)};
    };
    const Rgb<Batch> f = fresnel(at(in.to_light), at(in.to_viewer));
    const Batch shares[3] = {f.r, f.g, f.b};
    for (int c = 0; c < 3; ++c)
      (Batch::load(out.glossy[c] + i) * shares[c]).store(out.glossy[c] + i);
  }
}

}  // namespace scanlit::studio
