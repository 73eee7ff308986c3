#include "lessons/assignments/A5_phong/mistakes.h"

#include <algorithm>
#include <cmath>

namespace scanlit::assignments::phong {

namespace {

/// A term with something about it wrong.
struct Wrong {
  double normal_length = 1;    // N as it comes
  bool reversed = false;       // `light` taken for what it is not
  bool behind = false;         // lit also where N.L < 0
  bool late = false;           // clamped after the power
  double exponent = 1;         // times this
  bool other_cosine = false;   // with N.L where it should not be, or without
  bool other_term = false;     // N.H for R.V, R.V for N.H
  bool half_not_unit = false;  // H = (L + V) / 2

  double operator()(Term term, const Variant& variant, const Directions& d) const {
    const Vec3<double> n{0, 0, normal_length}, l = reversed ? -d.l : d.l;
    const double n_l = dot(n, l);
    if (term == Term::diffuse) return behind ? n_l : late ? std::abs(n_l) : std::max(0., n_l);
    if (!behind && !(n_l > 0)) return 0;
    const Vec3<double> s = l + d.v;
    const double n_h = dot(n, half_not_unit ? s * .5 : unit(s)), r_v = dot(mirrored(n, l), d.v);
    const double cosine = (term == Term::phong) != other_term ? r_v : n_h;
    const double power =
        exponent * (term == Term::phong ? variant.phong_exponent() : variant.blinn_exponent());
    const double lobe = std::pow(late ? cosine : std::max(0., cosine), power);
    return variant.with_cosine != other_cosine ? lobe * n_l : lobe;
  }
};

}  // namespace

std::vector<Mistake> mistakes_of(Term term, const Variant& variant, double normal_length) {
  std::vector<Mistake> all;
  const auto add = [&](const Wrong& wrong, double share, const char* message) {
    all.push_back(
        {[=](const Directions& d) { return Values{wrong(term, variant, d)}; }, share, message});
  };
  const char* const unnormalised =
      "The normal is used as it comes: it is interpolated, and not of unit length.";
  add({.normal_length = normal_length}, .4, unnormalised);
  add({.reversed = true}, 0,
      variant.light_travels ? "`light` is the direction in which the light travels: L is -light."
                            : "`light` points to the light: it is L, not -L.");
  if (term == Term::diffuse) {
    add({.behind = true}, .4, "N.L below 0 is not clamped: the light is behind the surface.");
    add({.late = true}, .4, "The light is behind the surface where N.L < 0; |N.L| lights it.");
    return all;
  }
  add({.behind = true}, .5,
      "There is a highlight where the light is behind the surface (N.L < 0).");
  add({.late = true}, .4,
      "A negative cosine is raised to a power, which gives NaN, or, where the power is even, a "
      "highlight: clamp first, then the power.");
  add({.behind = true, .late = true}, .3,
      "A negative cosine is raised to a power (clamp first, then the power), and there is a "
      "highlight where the light is behind the surface.");
  add({.exponent = .5}, .4, "The exponent is half of the one that is given.");
  add({.exponent = 2}, .4, "The exponent is twice the one that is given.");
  add({.exponent = 4}, .4, "The exponent is 4 times the one that is given.");
  add({.exponent = .25}, .4, "The exponent is a quarter of the one that is given.");
  add({.other_cosine = true}, .4,
      variant.with_cosine ? "The factor N.L of your variant is missing."
                          : "The factor N.L is not part of your variant's glossy term.");
  add({.other_term = true}, .2,
      term == Term::phong ? "That is Blinn's term, on N.H; Phong's is on R.V."
                          : "That is Phong's term, on R.V; Blinn's is on N.H.");
  if (term == Term::blinn)
    add({.half_not_unit = true}, .4,
        "H is not of unit length: (L + V) / |L + V|, not (L + V) / 2.");
  return all;
}

std::vector<FormMistake> mistakes_of_tinted() {
  using L = Lighting;
  return {
      {[](const L& l) {
         return l.surface.ka * l.lamp.ambient +
                (l.surface.kd * l.diffuse + l.surface.ks * l.glossy) * l.lamp.intensity;
       },
       .5, "The light's colour is missing."},
      {[](const L& l) {
         return l.surface.ka * l.lamp.ambient +
                l.surface.kd * (l.diffuse * l.lamp.intensity) * l.lamp.colour +
                l.surface.ks * l.glossy * l.lamp.colour;
       },
       .5, "Ii multiplies the glossy term, too: it stands after the braces."},
      {[](const L& l) {
         return (l.surface.ka * l.lamp.ambient + l.surface.kd * l.diffuse +
                 l.surface.ks * l.glossy) *
                l.lamp.colour * l.lamp.intensity;
       },
       .5,
       "The ambient term is outside of the braces: neither Ii nor the light's colour is in it."},
      {[](const L& l) {
         return (l.surface.kd * l.diffuse + l.surface.ks * l.glossy) * l.lamp.colour *
                l.lamp.intensity;
       },
       .5, "The ambient term is missing."},
      {[](const L& l) {
         return l.surface.ka * l.lamp.ambient +
                (l.surface.kd * l.diffuse + l.surface.ks * l.glossy) * l.diffuse * l.lamp.colour *
                    l.lamp.intensity;
       },
       .4, "It is multiplied by N.L once more: the terms hold the cosines that they want."},
  };
}

std::vector<FormMistake> mistakes_of_plastic() {
  using L = Lighting;
  return {
      {[](const L& l) {
         return (l.surface.ka * l.lamp.ambient + l.surface.kd * (l.diffuse * l.lamp.intensity) +
                 l.surface.ks * (l.glossy * l.lamp.intensity)) *
                l.surface.object_colour;
       },
       .4,
       "The highlight has the object's colour: in form 2 it has the light's, which makes it "
       "look like plastic."},
      {[](const L& l) {
         return (l.surface.ka * l.lamp.ambient + l.surface.kd * (l.diffuse * l.lamp.intensity)) *
                    l.surface.object_colour * l.lamp.colour +
                l.surface.ks * (l.glossy * l.lamp.intensity) * l.lamp.colour;
       },
       .5, "The light's colour multiplies the highlight alone in this form."},
      {[](const L& l) {
         return (l.surface.ka * l.lamp.ambient + l.surface.kd * (l.diffuse * l.lamp.intensity)) *
                    l.surface.object_colour +
                l.surface.ks * (l.glossy * l.lamp.intensity);
       },
       .5, "The highlight lacks the light's colour."},
      {[](const L& l) {
         return l.surface.kd * (l.diffuse * l.lamp.intensity) * l.surface.object_colour +
                l.surface.ks * (l.glossy * l.lamp.intensity) * l.lamp.colour;
       },
       .5, "The ambient term is missing."},
      {[](const L& l) {
         return (l.surface.ka * l.lamp.ambient + l.surface.kd * (l.diffuse * l.lamp.intensity)) *
                    l.surface.object_colour +
                l.surface.ks * l.glossy * l.lamp.colour;
       },
       .5, "The highlight lacks Ii."},
  };
}

}  // namespace scanlit::assignments::phong
