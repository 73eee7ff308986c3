// D(h): how the facets of a surface are turned. In 1/sr: of the area of facets over a unit of the
// macroscopic surface, D(h) dw has its normal within the solid angle dw about h. A surface without
// holes has facets that cover it, the hemisphere integral of D (N.H) is 1: the test of every D.
//
// Each distribution is a class of its own, in the file named after it, with
//
//   P peak() const;                                           D(N), 1/sr
//   T operator()(const Cosine<T>& n_h, const Vec3<T>& h);     D(h), 1/sr
//   T lambda(const T& n_d, const Vec3<T>& d);                 Smith's Lambda of the direction d
//
// h and d in the shading frame, which isotropic ones do not look at. To add one: its file, its
// enumerator and its word, its line in with_distribution(), and its parameters at the bottom; where
// it shares one, as GGX's a, "D=ggx|yours" there.
#pragma once

#include <cassert>
#include <iterator>
#include <string>
#include <vector>

#include "models/formula.h"
#include "models/microfacet/beckmann.h"
#include "models/microfacet/blinn.h"
#include "models/microfacet/gaussian.h"
#include "models/microfacet/ggx.h"

namespace scanlit::models::microfacet {

/// A D chosen by name, and the parameters of all of them. What a model inherits, so that one list
/// of parameters has everything.
template <class P = double>
struct Distribution {
  enum : int {  // isotropic ones first
    gaussian,
    beckmann,
    blinn,
    ggx,
    ashikhmin_shirley,
    anisotropic_beckmann,
    anisotropic_ggx,
    distributions
  };
  static constexpr const char* distribution_words[] = {  // in the same order
      "gaussian",       "beckmann", "blinn", "ggx", "ashikhmin-shirley", "anisotropic-beckmann",
      "anisotropic-ggx"};
  static_assert(std::size(distribution_words) == distributions);

  int distribution = beckmann;
  P m{0.3}, a{0.3}, n{40};
  P ex{10}, ey{200}, ax{0.1}, ay{0.4};
  Gaussian<P> gaussian_of_m{m};

  void prepare() {
    if (distribution == gaussian) gaussian_of_m = Gaussian<P>(m);
  }
  bool isotropic() const { return distribution < ashikhmin_shirley; }

  /// use(D), D the chosen distribution. The choice is the same for a whole span: a branch that the
  /// processor predicts.
  template <class Use>
  auto with_distribution(const Use& use) const {
    switch (distribution) {
      case gaussian: return use(gaussian_of_m);
      case beckmann: break;  // at the end: a function returns on every path
      case blinn: return use(Blinn<P>{n});
      case ggx: return use(Ggx<Isotropic<P>>{{a}});
      case ashikhmin_shirley: return use(AshikhminShirley<P>{ex, ey});
      case anisotropic_beckmann: return use(Beckmann<Anisotropic<P>>{{ax, ay}});
      case anisotropic_ggx: return use(Ggx<Anisotropic<P>>{{ax, ay}});
      default: assert(false);  // an enumerator without its line here
    }
    return use(Beckmann<Isotropic<P>>{{m}});
  }

  /// 1/sr.
  template <class T>
  T D(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    return with_distribution([&](const auto& d) { return d(c.n_h, f.h); });
  }
  P peak() const {
    return with_distribution([](const auto& d) { return d.peak(); });
  }
};

template <class Formula>
std::vector<Parameter<Formula>> distribution_parameters() {
  const auto& words = Distribution<>::distribution_words;
  return {
      {"D", &Formula::distribution, {std::begin(words), std::end(words)}, "distribution of facets"},
      {"m", &Formula::m, 1e-3, 1, "roughness: rms slope times sqrt(2)", "D=gaussian|beckmann"},
      {"n", &Formula::n, 0, 1e5, "exponent of N.H", "D=blinn"},
      {"a", &Formula::a, 1e-3, 1, "roughness", "D=ggx"},
      {"ex", &Formula::ex, 0, 1e5, "exponent along the tangent", "D=ashikhmin-shirley"},
      {"ey", &Formula::ey, 0, 1e5, "exponent along the bitangent", "D=ashikhmin-shirley"},
      {"ax", &Formula::ax, 1e-3, 1, "roughness along the tangent",
       "D=anisotropic-beckmann|anisotropic-ggx"},
      {"ay", &Formula::ay, 1e-3, 1, "roughness along the bitangent",
       "D=anisotropic-beckmann|anisotropic-ggx"}};
}

/// D alone, as a grey value, to be looked at.
template <class P = double>
struct DistributionPart : Distribution<P> {
  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    return {.diffuse = {}, .glossy = Rgb<T>(this->D(c, f))};
  }

  static Description<DistributionPart> describe() {
    return {.name = "distribution",
            .year = 1967,
            .title = "D, the distribution of microfacets (1/sr)",
            .source = "Torrance and Sparrow 1967; the others: see models/microfacet",
            .reciprocal = false,
            .energy_bounded = false,
            .parameters = distribution_parameters<DistributionPart>(),
            .exceptions = "no reflection",
            .kind = Kind::part};
  }
};

inline const Registered<DistributionPart<>> distribution_registered;

}  // namespace scanlit::models::microfacet
