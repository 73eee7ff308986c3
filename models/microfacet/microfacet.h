// The microfacet term, which Torrance-Sparrow and Cook-Torrance share.
//
// A surface of tiny mirrors. What it reflects from l to v are those mirrors whose normal is the
// half vector H: there are D of them, light and viewer both see the share G, each reflects the
// share F.
//
//   Specular = k D G F / (N.V)        the lecture's
//
// With k = pi / 4 it is pi f_r (N.L) of the f_r that conserves energy, D G F / (4 (N.L)(N.V)): the
// N.L of the light on the surface has cancelled, and is not to be multiplied by again. The 4 is the
// change of solid angle from H to L. Bruce Walter et al., "Microfacet models for refraction through
// rough surfaces", EGSR 2007, eq. 20.
#pragma once

#include "models/microfacet/fresnel_choice.h"
#include "models/microfacet/masking.h"

namespace scanlit::models::microfacet {

template <class P = double>
struct Microfacet : Masking<P>, Fresnel<P> {
  Rgb<P> kd{P(0.0)}, ks{P(1.0)};

  void prepare() { Distribution<P>::prepare(), Fresnel<P>::prepare(); }

  template <class T>
  Reflection<T> reflection(const T& scale, const Cosines<T>& c, const ShadingFrame<T>& f) const {
    const T D = this->D(c, f);  // 1/sr
    const T G = this->G(c, f);
    const Rgb<T> F = this->F(c.v_h);
    return {.diffuse = kd * c.n_l, .glossy = ks * (F * (scale * D * G * reciprocal(c.n_v)))};
  }
};

template <class Formula>
std::vector<Parameter<Formula>> microfacet_parameters() {
  auto parameters = masking_parameters<Formula>();
  for (auto& p : fresnel_parameters<Formula>()) parameters.push_back(std::move(p));
  parameters.push_back({"kd", &Formula::kd, 0, 1, "diffuse reflectance"});
  parameters.push_back({"ks", &Formula::ks, 0, 1, "factor of the glossy part"});
  return parameters;
}

}  // namespace scanlit::models::microfacet
