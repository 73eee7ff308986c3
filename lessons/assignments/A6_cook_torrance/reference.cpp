#include "lessons/assignments/A6_cook_torrance/reference.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "lessons/assignments/judge/dice.h"
#include "models/metals.h"

namespace scanlit::assignments::cook_torrance {

using std::numbers::pi;

Variant::Variant(std::uint64_t seed) {
  Dice dice(seed, "A6");
  const auto draw = [&dice](double least, double most, double step) {
    return step * dice.between(int(std::lround(least / step)), int(std::lround(most / step)));
  };
  roughness = Roughness(dice.between(0, 3));
  distribution = Facets(dice.between(0, 2));
  masking = Masking(dice.between(0, 3));
  fresnel = Fresnel(dice.between(0, 1));
  density = dice.coin();
  braces = dice.coin();
  switch (roughness) {
    case Roughness::angle: given = draw(10, 22, .5); break;
    case Roughness::exponent: given = draw(12, 60, 1); break;
    case Roughness::slope: given = draw(.12, .28, .01); break;
    case Roughness::smoothness: given = draw(.38, .58, .01); break;
  }
  wavelength_nm = {draw(635, 680, 1), draw(515, 545, 1), draw(440, 475, 1)};
  const auto at = [](double nm) { return models::find_metal("copper").at(nm); };
  const auto rounded = [](double value) { return std::round(value * 1000) / 1000; };
  const auto red = at(wavelength_nm.r), green = at(wavelength_nm.g), blue = at(wavelength_nm.b);
  n = {rounded(red.n), rounded(green.n), rounded(blue.n)};
  k = {rounded(red.k), rounded(green.k), rounded(blue.k)};
}

double Variant::m() const {
  switch (roughness) {
    case Roughness::angle: return std::tan(given * pi / 180);
    case Roughness::exponent: return std::sqrt(2 / (given + 2));
    case Roughness::slope: return std::numbers::sqrt2 * given;
    default: return (1 - given) * (1 - given);
  }
}

double Variant::D_of(double c, double m) const {
  const double m2 = m * m, c2 = c * c;
  const auto of = [&](double cos) {
    const double cos2 = cos * cos;
    switch (distribution) {
      case Facets::beckmann: return std::exp((cos2 - 1) / (m2 * cos2)) / (pi * m2 * cos2 * cos2);
      case Facets::ggx: return m2 / (pi * std::pow((m2 - 1) * cos2 + 1, 2));
      default: return std::pow(cos, 2 / m2 - 2) / (pi * m2);  // (n + 2) / (2 pi) = 1 / (pi m^2)
    }
  };
  if (c2 < 1e-12) return distribution == Facets::ggx ? (density ? 1 : 1 / of(1)) * of(0) : 0;
  return density ? of(c) : of(c) / of(1);
}

double Variant::G_of(const Cosines<double>& c, double m) const {
  const auto lambda = [m](double cos) {
    return (std::sqrt(1 + m * m * (1 - cos * cos) / (cos * cos)) - 1) / 2;
  };
  switch (masking) {
    case Masking::v_cavity:
      return std::min({1.0, 2 * c.n_h.cos * c.n_v / c.v_h, 2 * c.n_h.cos * c.n_l / c.v_h});
    case Masking::smith: return 1 / ((1 + lambda(c.n_l)) * (1 + lambda(c.n_v)));
    case Masking::smith_correlated: return 1 / (1 + lambda(c.n_l) + lambda(c.n_v));
    default: return c.n_l * c.n_v / (c.v_h * c.v_h);
  }
}

double conductor(double c, double n, double k) {
  const std::complex<double> eta(n, k), q = std::sqrt(eta * eta - 1.0 + c * c);
  return (std::norm((c - q) / (c + q)) + std::norm((eta * eta * c - q) / (eta * eta * c + q))) / 2;
}

double schlick(double c, double f0) { return f0 + (1 - f0) * std::pow(1 - c, 5); }

Rgb<double> Variant::f0() const {
  const auto rounded = [](double value) { return std::round(value * 1000) / 1000; };
  return {rounded(conductor(1, n.r, k.r)), rounded(conductor(1, n.g, k.g)),
          rounded(conductor(1, n.b, k.b))};
}

Rgb<double> Variant::F_of(double v_h) const {
  if (fresnel == Fresnel::conductor)
    return {conductor(v_h, n.r, k.r), conductor(v_h, n.g, k.g), conductor(v_h, n.b, k.b)};
  const Rgb<double> f = f0();
  return {schlick(v_h, f.r), schlick(v_h, f.g), schlick(v_h, f.b)};
}

Rgb<double> Variant::product(double D, double G, const Rgb<double>& F,
                             const Cosines<double>& c) const {
  const double f_r = D * G / (c.n_l * c.n_v) * (density ? .25 : 1 / pi);
  return F * (braces ? f_r * pi * c.n_l : f_r);
}

Rgb<double> Variant::whole(const Directions& d) const {
  const Cosines<double> c = d.cosines();
  return product(D_of(c.n_h, m()), G_of(c, m()), F_of(c.v_h), c);
}

}  // namespace scanlit::assignments::cook_torrance
