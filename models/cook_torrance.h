// Cook-Torrance: facets that mirror, metals that have a colour.
//
//   Kd (N.L) + Ks k D G F / (N.V)
//
// Robert L. Cook, Kenneth E. Torrance, "A reflectance model for computer graphics", ACM
// Transactions on Graphics 1(1), 1982: Torrance and Sparrow's term (torrance_sparrow.h) with
// Beckmann's D and, as F, Fresnel's equations of a measured metal. models/microfacet/microfacet.h
// has the term, the files beside it the D and G to choose from, models/fresnel.h the F.
//
//   form=normalised   k = pi / 4: the light that is reflected is at most the light that came. The
//                     paper prints f_r = D G F / (pi (N.L)(N.V)), 1 / pi where 1 / 4 belongs: with
//                     a normalised D 4 / pi too bright, with its own D, which lacks 1 / pi, 4
//                     times.
//   form=lecture      k = 1 and D scaled to 1 at N, as on slides: D = exp(-(alpha / m)^2). The
//                     highlight's centre is as bright for every roughness. The normalised form is
//                     (pi / 4) D(N) times as bright: 2.8 times with Beckmann's m = .3, a quarter
//                     with m = 1.
//
//   kd   Kd, diffuse reflectance per channel
//   ks   Ks, factor of the glossy part per channel
#pragma once

#include "models/microfacet/microfacet.h"

namespace scanlit::models {

template <class P = double>
struct CookTorrance : microfacet::Microfacet<P> {
  enum : int { normalised, lecture };
  int form = normalised;

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    const T k(form == lecture ? P(1.0) / this->peak() : P(std::numbers::pi / 4));
    return this->reflection(k, c, f);
  }

  static Description<CookTorrance> describe() {
    auto parameters = microfacet::microfacet_parameters<CookTorrance>();
    parameters.push_back({"form",
                          &CookTorrance::form,
                          {"normalised", "lecture"},
                          "k = pi/4, or k = 1 with D = 1 at N"});
    return {.name = "cook-torrance",
            .year = 1982,
            .title = "Cook-Torrance (D G F)",
            .source = "Cook and Torrance 1982, A reflectance model for computer graphics",
            .reciprocal = true,
            .energy_bounded = false,
            .parameters = std::move(parameters),
            .exceptions =
                "bounded in energy where kd + ks <= 1 and form=normalised and G=vcavity, "
                "or smith or smith-correlated with a D of Beckmann or GGX"};
  }
};

inline const Registered<CookTorrance<>> cook_torrance_registered;

}  // namespace scanlit::models
