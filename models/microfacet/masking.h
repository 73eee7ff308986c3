// G(l, v): the share of the facets that mirror from l to v that both the light and the viewer see.
//
//   none               1
//   vcavity            min(1, 2 (N.H)(N.V) / (V.H), 2 (N.H)(N.L) / (V.H))
//   smith              1 / ((1 + Lambda(l)) (1 + Lambda(v)))
//   smith-correlated   1 / (1 + Lambda(l) + Lambda(v))
//
// V.H = L.H. V-cavity: facets are the sides of long symmetrical grooves; Torrance and Sparrow 1967,
// in this form Blinn 1977. Smith: heights and slopes of facets are independent, Lambda follows from
// D; B. G. Smith, "Geometrical shadowing of a random rough surface", IEEE Transactions on Antennas
// and Propagation 15(5), 1967. That takes what the light sees as independent of what the viewer
// sees, too; correlated, high facets are seen by both: Eric Heitz, "Understanding the
// masking-shadowing function in microfacet-based BRDFs", JCGT 3(2), 2014.
#pragma once

#include "models/microfacet/distribution.h"

namespace scanlit::models::microfacet {

/// N.H < 0 is for a viewer below the surface; at V.H = 0, where l = -v, 0/0 without the bound.
template <class T>
T v_cavity(const Cosines<T>& c) {
  const T scale = T(2) * max(c.n_h.cos, T(0)) * reciprocal(max(c.v_h, T(1e-20)));
  return min(T(1), scale * min(c.n_v, c.n_l));
}

template <class T>
T smith(const T& lambda_l, const T& lambda_v) {
  return T(1) / ((T(1) + lambda_l) * (T(1) + lambda_v));
}

template <class T>
T smith_correlated(const T& lambda_l, const T& lambda_v) {
  return T(1) / (T(1) + lambda_l + lambda_v);
}

/// A D and a G chosen by name.
template <class P = double>
struct Masking : Distribution<P> {
  enum : int { none, vcavity, smith_separable, smith_height_correlated };
  int masking = vcavity;

  template <class T>
  T G(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    if (masking == none) return T(1);
    if (masking == vcavity) return v_cavity(c);
    return this->with_distribution([&](const auto& d) {
      const T lambda_l = d.lambda(c.n_l, f.l), lambda_v = d.lambda(c.n_v, f.v);
      return masking == smith_separable ? smith(lambda_l, lambda_v)
                                        : smith_correlated(lambda_l, lambda_v);
    });
  }
};

template <class Formula>
std::vector<Parameter<Formula>> masking_parameters() {
  auto parameters = distribution_parameters<Formula>();
  parameters.push_back({"G",
                        &Formula::masking,
                        {"none", "vcavity", "smith", "smith-correlated"},
                        "masking and shadowing"});
  return parameters;
}

/// G alone, as a grey value.
template <class P = double>
struct MaskingPart : Masking<P> {
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    return {.diffuse = {}, .glossy = Rgb<T>(this->G(c, f))};
  }

  static Description<MaskingPart> describe() {
    return {.name = "masking",
            .year = 1967,
            .title = "G, masking and shadowing of microfacets",
            .source = "Torrance and Sparrow 1967; Smith 1967; Heitz 2014",
            .reciprocal = false,
            .energy_bounded = false,
            .parameters = masking_parameters<MaskingPart>(),
            .exceptions = "no reflection",
            .kind = Kind::part};
  }
};

inline const Registered<MaskingPart<>> masking_registered;

}  // namespace scanlit::models::microfacet
