// F(V.H): the share of light that a facet mirrors, chosen by name. The formulas are in
// models/fresnel.h, the metals in models/metals.h. In double a conductor is exact; what is drawn of
// it may be fitted: models/conductor_fit.h.
#pragma once

#include <concepts>
#include <string>
#include <vector>

#include "models/conductor_fit.h"
#include "models/formula.h"
#include "models/fresnel.h"
#include "models/metals.h"

namespace scanlit::models::microfacet {

inline std::vector<std::string> fresnel_names() {
  std::vector<std::string> names{"one", "schlick", "dielectric", "conductor"};
  names.insert(names.end(), metal_names().begin(), metal_names().end());
  return names;
}

template <class P = double>
struct Fresnel {
  enum : int { one, schlick, dielectric, conductor, first_metal };
  int fresnel = first_metal + metal_index("copper");
  Rgb<P> f0{P(0.04)};
  // Glass; as a conductor aluminium at 641 nm (models/metals.cpp).
  Rgb<P> eta{P(1.5)}, extinction{P(7.62)};
  const MetalFresnel* metal = nullptr;
  ConductorFit conductor_fit{};

  // The name of a metal does not vary: what varies makes this run again for every vector.
  void prepare() {
    if constexpr (std::same_as<P, double>)
      if (fresnel == conductor) conductor_fit = ConductorFit(eta, extinction);
    if (fresnel >= first_metal && !metal)
      metal = &models::metal(metal_names()[std::size_t(fresnel - first_metal)]);
  }

  template <class T>
  Rgb<T> F(const T& v_h) const {
    switch (fresnel) {
      case one: return UnitFresnel{}(v_h);
      case schlick: return SchlickFresnel<P>{f0}(v_h);
      case dielectric: return DielectricFresnel<P>{eta}(v_h);
      case conductor:
        if constexpr (!std::same_as<T, double>)
          if (conductor_fit.close()) return conductor_fit(v_h);
        return ConductorFresnel<P>{eta, extinction}(v_h);
      default: return (*metal)(v_h);
    }
  }
};

template <class Formula>
std::vector<Parameter<Formula>> fresnel_parameters() {
  return {{"F", &Formula::fresnel, fresnel_names(), "Fresnel reflectance: a formula or a metal"},
          {"f0", &Formula::f0, 0, 1, "reflectance at normal incidence", "F=schlick"},
          {"eta", &Formula::eta, 0.01, 20, "index of refraction", "F=dielectric|conductor"},
          {"k", &Formula::extinction, 0, 20, "extinction coefficient", "F=conductor"}};
}

/// F alone.
template <class P = double>
struct FresnelPart : Fresnel<P> {
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c) const {
    return {.diffuse = {}, .glossy = this->F(c.v_h)};
  }

  static Description<FresnelPart> describe() {
    return {.name = "fresnel",
            .year = 1823,
            .title = "F, Fresnel reflectance of a microfacet",
            .source = "Fresnel's equations (Born and Wolf, Principles of Optics); Schlick 1994",
            .reciprocal = false,
            .energy_bounded = false,
            .parameters = fresnel_parameters<FresnelPart>(),
            .exceptions = "no reflection",
            .kind = Kind::part};
  }
};

inline const Registered<FresnelPart<>> fresnel_registered;

}  // namespace scanlit::models::microfacet
