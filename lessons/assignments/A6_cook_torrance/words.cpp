// What the page and the student's file say of the variant.
#include <cstdio>

#include "lessons/assignments/A6_cook_torrance/reference.h"
#include "lessons/assignments/judge/worded.h"

namespace scanlit::assignments::cook_torrance {

namespace {

constexpr const char* roughness_rules[] = {
    "as an angle in degrees, whose tangent is m",
    "as the exponent e of the power of N.H that is about as wide: m^2 = 2 / (e + 2)",
    "as the standard deviation s of the facets' slope: m = sqrt(2) s",
    "as a smoothness s from 0 (rough) to 1 (a mirror): m = (1 - s)^2"};

constexpr const char* D_names[] = {"Beckmann", "GGX (Trowbridge and Reitz)", "Blinn"};
constexpr const char* D_density[] = {"D = exp(-tan^2(alpha) / m^2) / (pi m^2 cos^4(alpha))",
                                     "D = m^2 / (pi ((m^2 - 1) cos^2(alpha) + 1)^2)",
                                     "D = (n + 2) / (2 pi) cos^n(alpha),   n = 2 / m^2 - 2"};
constexpr const char* D_peak[] = {"D = exp(-tan^2(alpha) / m^2) / cos^4(alpha)",
                                  "D = m^4 / ((m^2 - 1) cos^2(alpha) + 1)^2",
                                  "D = cos^n(alpha),   n = 2 / m^2 - 2"};
constexpr const char* D_sources[] = {
    "Petr Beckmann and Andre Spizzichino, *The Scattering of Electromagnetic Waves from Rough "
    "Surfaces*, 1963",
    "T. S. Trowbridge and K. P. Reitz, *Average irregularity representation of a rough surface for "
    "ray reflection*, JOSA 65(5), 1975; Walter, Marschner, Li, Torrance, *Microfacet models for "
    "refraction through rough surfaces*, EGSR 2007",
    "James F. Blinn, *Models of light reflection for computer synthesized pictures*, SIGGRAPH "
    "1977"};

constexpr const char* G_names[] = {"of V-shaped grooves", "Smith's, as a product",
                                   "Smith's, with heights correlated",
                                   "Kelemen's and Szirmay-Kalos'"};
constexpr const char* G_rules[] = {"G = min(1, 2 (N.H)(N.V) / (V.H), 2 (N.H)(N.L) / (V.H))",
                                   "G = 1 / ((1 + Lambda(N.L)) (1 + Lambda(N.V)))\n"
                                   "    Lambda(c) = (sqrt(1 + m^2 (1 - c^2) / c^2) - 1) / 2",
                                   "G = 1 / (1 + Lambda(N.L) + Lambda(N.V))\n"
                                   "    Lambda(c) = (sqrt(1 + m^2 (1 - c^2) / c^2) - 1) / 2",
                                   "G = (N.L)(N.V) / (V.H)^2"};
constexpr const char* G_sources[] = {
    "Blinn 1977, after Torrance and Sparrow 1967",
    "B. Smith, *Geometrical shadowing of a random rough surface*, 1967; this Lambda: Walter et al. "
    "2007",
    "Eric Heitz, *Understanding the masking-shadowing function in microfacet-based BRDFs*, JCGT "
    "3(2), 2014",
    "Csaba Kelemen and Laszlo Szirmay-Kalos, *A microfacet based coupled specular-matte BRDF model "
    "with importance sampling*, Eurographics 2001"};

std::string triple(const char* format, const Rgb<double>& c) {
  const auto one = [format](double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return std::string(text);
  };
  return one(c.r) + ", " + one(c.g) + ", " + one(c.b);
}

}  // namespace

Words Variant::words() const {
  const auto r = std::size_t(roughness), d = std::size_t(distribution), g = std::size_t(masking);
  const bool exact = fresnel == Fresnel::conductor;
  const std::string f_r = density ? "D G F / (4 (N.L)(N.V))" : "D G F / (pi (N.L)(N.V))";
  const std::string in_braces = density ? "pi D G F / (4 (N.V))" : "D G F / (N.V)";
  return {
      {"roughness.value", worded("%g", given)},
      {"roughness.rule", roughness_rules[r]},
      {"roughness.case", std::to_string(r)},
      {"D.name", D_names[d]},
      {"D.formula", density ? D_density[d] : D_peak[d]},
      {"D.source", D_sources[d]},
      {"D.normalisation", density
                              ? "It is a density: the integral of D (N.H) over the hemisphere is 1."
                              : "It is scaled so that D is 1 where H is N, for every m."},
      {"D.case", std::to_string(d)},
      {"D.density", density ? "true" : "false"},
      {"G.name", G_names[g]},
      {"G.formula", G_rules[g]},
      {"G.source", G_sources[g]},
      {"G.case", std::to_string(g)},
      {"F.n", "{" + triple("%.3f", n) + "}"},
      {"F.k", "{" + triple("%.3f", k) + "}"},
      {"F.F0", "{" + triple("%.3f", f0()) + "}"},
      {"F.given", exact ? "as the complex index of refraction n + i k, one for each channel"
                        : "as reflectance F0 at normal incidence, one for each channel"},
      {"F.wavelengths", triple("%.0f", wavelength_nm)},
      {"F.formula", exact ? "q   = sqrt((n + i k)^2 - 1 + c^2)\n"
                            "    r_s = (c - q) / (c + q)\n"
                            "    r_p = ((n + i k)^2 c - q) / ((n + i k)^2 c + q)\n"
                            "    F   = (|r_s|^2 + |r_p|^2) / 2"
                          : "F = F0 + (1 - F0) (1 - c)^5"},
      {"F.source", exact ? "Fresnel's equations for metals: Max Born and Emil Wolf, *Principles of "
                           "Optics*, 1.5.2 and 14.2"
                         : "Christophe Schlick, *An inexpensive BRDF model for physically-based "
                           "rendering*, Eurographics 1994"},
      {"F.case", exact ? "0" : "1"},
      {"product.name", braces ? "the lecture's braces, pi f_r (N.L), a number without a unit"
                              : "f_r itself, in 1/sr, without the cosine"},
      {"product.formula", braces ? in_braces : f_r},
      {"product.f_r", f_r},
      {"product.braces", braces ? "true" : "false"},
  };
}

}  // namespace scanlit::assignments::cook_torrance
