#include "lessons/assignments/A6_cook_torrance/mistakes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scanlit::assignments::cook_torrance {

using std::numbers::pi;

namespace {

Values of(const Rgb<double>& c) { return {c.r, c.g, c.b}; }

}  // namespace

std::vector<Mistake> mistakes_of_D(const Variant& variant) {
  const double m = variant.m();
  const auto D = [&variant, m](double change_of_m) {
    return [variant, m, change_of_m](const Directions& d) {
      return Values{variant.D_of(d.cosines().n_h, std::pow(m, change_of_m))};
    };
  };
  Variant other = variant;
  other.density = !variant.density;
  const auto exponential = [variant, m](double factor, bool fourth_power) {
    return [variant, m, factor, fourth_power](const Directions& d) {
      const Cosines<double> c = d.cosines();
      const double c2 = c.n_h * c.n_h, peak = variant.density ? 1 / (pi * m * m) : 1;
      return Values{peak * std::exp(-factor * c.n_h.sin2() / (m * m * c2)) /
                    (fourth_power ? c2 * c2 : 1)};
    };
  };
  std::vector<Mistake> all{
      {[other, m](const Directions& d) { return Values{other.D_of(d.cosines().n_h, m)}; }, .5,
       variant.density ? "This D is 1 where H is N: it wants to be normalised to a density."
                       : "This D is a density: it should be scaled to 1 where H is N."},
      {D(2), .25, "Where m^2 belongs stands m^4."},
      {D(.5), .25, "Where m^2 belongs stands m: the square is missing."},
  };
  if (variant.distribution == Variant::Facets::beckmann) {
    all.push_back({exponential(1, false), .5, "The division by (N.H)^4 is missing."});
    all.push_back({exponential(.5, true), .25, "The exponent is half of what it should be."});
    all.push_back({[variant, m](const Directions& d) {
                     const double alpha = std::acos(d.cosines().n_h.cos);
                     const double peak = variant.density ? 1 / (pi * m * m) : 1;
                     return Values{peak * std::exp(-alpha * alpha / (m * m))};
                   },
                   .25, "That is the Gaussian of alpha; Beckmann's D has tan(alpha)."});
  }
  if (variant.distribution == Variant::Facets::blinn)
    all.push_back({[variant, m](const Directions& d) {
                     const double n = 1 / (m * m) - 1,
                                  peak = variant.density ? 1 / (pi * m * m) : 1;
                     return Values{peak * std::pow(d.cosines().n_h.cos, n)};
                   },
                   .25, "The exponent n is half of what it should be."});
  if (variant.distribution == Variant::Facets::ggx)
    all.push_back({[variant, m](const Directions& d) {
                     const double c = d.cosines().n_h, below = (m * m - 1) * c * c + 1;
                     return Values{variant.density ? m * m / (pi * below) : m * m / below};
                   },
                   .25, "The square of the denominator is missing."});
  return all;
}

std::vector<Mistake> mistakes_of_G(const Variant& variant) {
  const double m = variant.m();
  std::vector<Mistake> all;
  const auto add = [&all](auto formula, double share, const char* message) {
    all.push_back(
        {[formula](const Directions& d) { return Values{formula(d.cosines())}; }, share, message});
  };
  using C = Cosines<double>;
  add([](const C&) { return 1.0; }, 0, "It is 1 everywhere.");
  if (variant.masking == Variant::Masking::v_cavity) {
    const auto term = [](const C& c, double n_w) { return 2 * c.n_h * n_w / c.v_h; };
    add([=](const C& c) { return std::min(term(c, c.n_v), term(c, c.n_l)); }, .4,
        "The min with 1 is missing: more facets than there are cannot be seen.");
    add([=](const C& c) { return std::min(1.0, term(c, c.n_v)); }, .4,
        "Only masking is there: shadowing, the term with N.L, is missing.");
    add([=](const C& c) { return std::min(1.0, term(c, c.n_l)); }, .4,
        "Only shadowing is there: masking, the term with N.V, is missing.");
    add(
        [=](const C& c) {
          return std::min({1.0, term(c, c.n_v) / 2, term(c, c.n_l) / 2});
        },
        .4, "The factor 2 is missing.");
    add(
        [](const C& c) {
          return std::min({1.0, 2 * c.n_h * c.n_v / c.n_l, 2 * c.n_h * c.n_l / c.n_l});
        },
        .4, "N.L stands where V.H belongs.");
    add(
        [](const C& c) {
          return std::min({1.0, 2 * c.n_h * c.n_v / c.n_v, 2 * c.n_h * c.n_l / c.n_v});
        },
        .4, "N.V stands where V.H belongs.");
  }
  const auto with = [&](Variant::Masking masking, double roughness, double share,
                        const char* message) {
    Variant other = variant;
    other.masking = masking;
    add([other, roughness](const C& c) { return other.G_of(c, roughness); }, share, message);
  };
  with(variant.masking, m * m, .4, "Where m^2 belongs stands m^4.");
  with(variant.masking, std::sqrt(m), .4, "Where m^2 belongs stands m.");
  with(Variant::Masking::v_cavity, m, .2,
       "That is the G of V-shaped grooves, not the one asked for.");
  with(Variant::Masking::smith, m, .4, "That is Smith's G as a product, not the one asked for.");
  with(Variant::Masking::smith_correlated, m, .4,
       "That is Smith's G with heights correlated, not the one asked for.");
  with(Variant::Masking::kelemen, m, .2, "That is Kelemen's G, not the one asked for.");
  return all;
}

std::vector<Mistake> mistakes_of_F(const Variant& variant) {
  std::vector<Mistake> all;
  const auto at = [&](auto cosine, const char* message) {
    all.push_back(
        {[variant, cosine](const Directions& d) { return of(variant.F_of(cosine(d.cosines()))); },
         .4, message});
  };
  at([](const Cosines<double>& c) { return c.n_l; },
     "That is F at N.L: the normal of a facet that mirrors L to V is H.");
  at([](const Cosines<double>& c) { return c.n_v; },
     "That is F at N.V: the normal of a facet that mirrors L to V is H.");
  at([](const Cosines<double>& c) { return c.n_h.cos; },
     "That is F at N.H: the angle of incidence on the facet is that between V and H.");
  at([](const Cosines<double>&) { return 1.0; },
     "It is F at normal incidence, whatever the angle.");
  const auto each = [&](auto formula, double share, const char* message) {
    all.push_back({[variant, formula](const Directions& d) {
                     const double c = d.cosines().v_h;
                     const Rgb<double> f0 = variant.f0();
                     return Values{formula(c, f0.r, variant.n.r, variant.k.r),
                                   formula(c, f0.g, variant.n.g, variant.k.g),
                                   formula(c, f0.b, variant.n.b, variant.k.b)};
                   },
                   share, message});
  };
  each([](double, double, double, double) { return 1.0; }, 0, "It is 1 everywhere.");
  if (variant.fresnel == Variant::Fresnel::conductor) {
    each([](double c, double, double n, double) { return conductor(c, n, 0); }, .25,
         "k is left out: that is F of a glass.");
    each([](double c, double f0, double, double) { return schlick(c, f0); }, .4,
         "That is Schlick's approximation; the exact F is asked for.");
    each([](double c, double, double n, double k) { return schlick(c, conductor(1, n, k)); }, .4,
         "That is Schlick's approximation; the exact F is asked for.");
  } else {
    each([](double c, double, double n, double k) { return conductor(c, n, k); }, .4,
         "That is the exact F of n + i k; the one of F0 is asked for.");
    each([](double c, double f0, double, double) { return f0 + (1 - f0) * (1 - std::pow(c, 5)); },
         .4, "It is (1 - c)^5, not 1 - c^5.");
    each([](double c, double f0, double, double) { return f0 + (1 - f0) * std::pow(1 - c, 4); }, .4,
         "The power is 4, not 5.");
    each([](double c, double f0, double, double) { return f0 + std::pow(1 - c, 5); }, .4,
         "(1 - c)^5 wants the factor 1 - F0: else F exceeds 1 at grazing angles.");
  }
  return all;
}

std::vector<Mistake> mistakes_of_product(const Variant& variant) {
  std::vector<Mistake> all;
  const auto scaled = [&](auto factor, double share, const char* message) {
    all.push_back({[variant, factor](const Directions& d) {
                     return of(variant.whole(d) * double(factor(d.cosines())));
                   },
                   share, message});
  };
  using C = Cosines<double>;
  if (variant.braces) {
    scaled([](const C& c) { return c.n_l; }, .4,
           "N.L stands in the product once more: pi f_r (N.L) holds it already, and it cancels "
           "against that of the denominator (the cosine is counted twice).");
    scaled([](const C& c) { return 1 / (pi * c.n_l); }, .4,
           "That is f_r itself: pi (N.L) is missing.");
    scaled([](const C& c) { return 1 / c.n_l; }, .4,
           "It is divided by N.L, which cancels against the cosine in the braces.");
  } else {
    scaled([](const C& c) { return pi * c.n_l; }, .4,
           "Those are the braces, pi f_r (N.L): f_r itself is asked for.");
    scaled([](const C& c) { return c.n_l; }, .4,
           "That is f_r (N.L): the cosine is not part of f_r (it would be counted twice).");
  }
  scaled([](const C& c) { return c.n_v / c.n_l; }, .4, "N.L stands where N.V belongs.");
  scaled([](const C&) { return 4 / pi; }, .4,
         "It is 4/pi times too large: 1/pi, as Cook and Torrance printed it, stands where 1/4 "
         "belongs.");
  return all;
}

}  // namespace scanlit::assignments::cook_torrance
