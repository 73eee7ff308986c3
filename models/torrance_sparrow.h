// Torrance-Sparrow: the first model of a surface as many small mirrors.
//
//   Kd (N.L) + Ks pi D G F / (4 (N.V))
//
// Torrance and Sparrow, physicists, explained in 1967 why rough surfaces reflect most not in the
// mirror direction but beyond it, with V-shaped grooves and a Gaussian D: the default here. Blinn
// brought the model to graphics in 1977, with other D, among them the power of N.H that bears his
// name (D=blinn), and G in the form used since. Cook and Torrance 1982 gave it
// Beckmann's D and metals: cook_torrance.h, which is the same term, normalised, with other
// defaults.
//
// K. E. Torrance, E. M. Sparrow, "Theory for off-specular reflection from roughened surfaces", JOSA
// 57(9), 1967; James F. Blinn, "Models of light reflection for computer synthesized pictures",
// SIGGRAPH 1977. The factor pi / 4: models/microfacet/microfacet.h.
//
//   kd   Kd, diffuse reflectance per channel
//   ks   Ks, factor of the glossy part per channel
#pragma once

#include "models/microfacet/microfacet.h"

namespace scanlit::models {

template <class P = double>
struct TorranceSparrow : microfacet::Microfacet<P> {
  TorranceSparrow() { this->distribution = this->gaussian, this->fresnel = this->dielectric; }

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    return this->reflection(T(std::numbers::pi / 4), c, f);
  }

  static Description<TorranceSparrow> describe() {
    return {.name = "torrance-sparrow",
            .year = 1967,
            .title = "Torrance-Sparrow (D G F)",
            .source =
                "Torrance and Sparrow 1967, Theory for off-specular reflection from "
                "roughened surfaces",
            .reciprocal = true,
            .energy_bounded = false,
            .parameters = microfacet::microfacet_parameters<TorranceSparrow>(),
            .exceptions =
                "bounded in energy where kd + ks <= 1 and G=vcavity, or smith or "
                "smith-correlated with a D of Beckmann or GGX"};
  }
};

inline const Registered<TorranceSparrow<>> torrance_sparrow_registered;

}  // namespace scanlit::models
