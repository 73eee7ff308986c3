#include "lessons/assignments/A5_phong/reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lessons/assignments/judge/dice.h"
#include "lessons/assignments/judge/worded.h"

namespace scanlit::assignments::phong {

Variant::Variant(std::uint64_t seed) {
  Dice dice(seed, "A5");
  given_as = Shininess(dice.between(0, 2));
  same_width = dice.coin();
  with_cosine = dice.coin();
  light_travels = dice.coin();
  switch (given_as) {
    case Shininess::exponent: given = 2 * dice.between(4, 12); break;
    case Shininess::half_width: given = dice.between(24, 40) / 2.0; break;
    case Shininess::gloss: given = dice.between(30, 46) / 100.0; break;
  }
}

double Variant::phong_exponent() const {
  switch (given_as) {
    case Shininess::exponent: return given;
    case Shininess::half_width:
      return std::log(.5) / std::log(std::cos(given * std::numbers::pi / 180));
    default: return std::exp2(10 * given);
  }
}

Words Variant::words() const {
  const char* const rules[] = {"as Phong's exponent n itself",
                               "as the angle between R and V, in degrees, at which (R.V)^n is 1/2",
                               "as gloss g from 0 to 1: Phong's exponent n is 2^(10 g)"};
  const auto yes = [](bool b) { return std::string(b ? "true" : "false"); };
  return {
      {"shininess", worded("%g", given)},
      {"shininess.case", std::to_string(int(given_as))},
      {"shininess.rule", rules[int(given_as)]},
      {"same_width", yes(same_width)},
      {"with_cosine", yes(with_cosine)},
      {"light_travels", yes(light_travels)},
      {"blinn", same_width ? "4 times Phong's, so that both highlights are about as wide"
                           : "the same as Phong's, so that its highlight is wider"},
      {"cosine", with_cosine
                     ? "(R.V)^n (N.L) and (N.H)^n (N.L): with the cosine, unlike the lecture's"
                     : "(R.V)^n and (N.H)^n: without a cosine, as the lecture's"},
      {"phong.formula", with_cosine ? "max(0, R.V)^n (N.L)" : "max(0, R.V)^n"},
      {"blinn.formula", with_cosine ? "max(0, N.H)^n (N.L)" : "max(0, N.H)^n"},
      {"light", light_travels ? "the direction in which the light **travels**, from the light to "
                                "the surface: L is its opposite"
                              : "the direction L, from the surface to the light"}};
}

Vec3<double> unit(const Vec3<double>& a) { return a * (1 / std::sqrt(dot(a, a))); }

Vec3<double> mirrored(const Vec3<double>& n, const Vec3<double>& l) {
  return 2 * dot(n, l) * n - l;
}

Placement seeded_placement(std::uint64_t seed) {
  Dice dice(seed, "A5 placement");
  const Vec3<double> n = direction(dice.real(20, 160), dice.real(0, 360));
  const Vec3<double> t = unit(cross(n, direction(dice.real(80, 100), dice.real(0, 360))));
  return {t, cross(n, t), n, dice.real(.75, .9)};
}

Point Placement::point(const Variant& variant, const Directions& d) const {
  const Vec3<double> l = placed(d.l);
  return {n * normal_length, variant.light_travels ? -l : l, placed(d.v)};
}

double diffuse(const Directions& d) { return std::max(0., d.l.z); }

double phong(const Variant& variant, const Directions& d) {
  if (!(d.l.z > 0)) return 0;
  const double r_v = dot(mirrored({0, 0, 1}, d.l), d.v);
  const double lobe = std::pow(std::max(0., r_v), variant.phong_exponent());
  return variant.with_cosine ? lobe * d.l.z : lobe;
}

double blinn(const Variant& variant, const Directions& d) {
  if (!(d.l.z > 0)) return 0;
  const double lobe = std::pow(std::max(0., unit(d.l + d.v).z), variant.blinn_exponent());
  return variant.with_cosine ? lobe * d.l.z : lobe;
}

Rgb<double> tinted(const Surface& s, const Lamp& lamp, double diffuse, double glossy) {
  return s.ka * lamp.ambient + (s.kd * diffuse + s.ks * glossy) * lamp.colour * lamp.intensity;
}

Rgb<double> plastic(const Surface& s, const Lamp& lamp, double diffuse, double glossy) {
  return (s.ka * lamp.ambient + s.kd * (diffuse * lamp.intensity)) * s.object_colour +
         s.ks * (glossy * lamp.intensity) * lamp.colour;
}

}  // namespace scanlit::assignments::phong
