// Cook-Torrance as a seed draws it: how roughness is given, which D, G and F, what is returned.
#pragma once

#include <cstdint>

#include "lessons/assignments/judge/assignment.h"
#include "lessons/assignments/judge/model_questions.h"

namespace scanlit::assignments::cook_torrance {

struct Variant {
  enum class Roughness { angle, exponent, slope, smoothness } roughness;
  enum class Facets { beckmann, ggx, blinn } distribution;
  enum class Masking { v_cavity, smith, smith_correlated, kelemen } masking;
  enum class Fresnel { conductor, schlick } fresnel;
  bool density;  // the integral of D (N.H) is 1; else D is 1 at N
  bool braces;   // pi f_r (N.L) is returned; else f_r
  double given;  // the roughness as it is given
  Rgb<double> wavelength_nm, n, k;

  explicit Variant(std::uint64_t seed);

  double m() const;
  double D_of(double n_h, double m) const;
  double G_of(const Cosines<double>& c, double m) const;
  Rgb<double> F_of(double v_h) const;
  Rgb<double> product(double D, double G, const Rgb<double>& F, const Cosines<double>& c) const;
  Rgb<double> whole(const Directions& d) const;

  Rgb<double> f0() const;
  Words words() const;
};

/// (exact) reflectance of n + i k.
double conductor(double c, double n, double k);
double schlick(double c, double f0);

}  // namespace scanlit::assignments::cook_torrance
