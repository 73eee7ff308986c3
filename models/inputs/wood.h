// Inputs: wood, as a solid that the object is carved from. A trunk is a stack of yearly rings about
// its pith, of pale early and dark late wood; its fibres run along the trunk, and where they wave
// they come out of the surface in places and dive in others (curly figure, as in maple).
//
//   wood-colour   for kd and kf of finished-wood
//   wood-fibre    for u, the fibres' axis
//
// Both describe the same trunk if they are given the same trunk: its parameters have the same names
// and defaults. Lengths are in units of the object. The geometry is a sketch, chosen by eye; that
// an object is carved from a texture in space is Darwyn R. Peachey's idea, "Solid texturing of
// complex surfaces", SIGGRAPH 1985.
#pragma once

#include <numbers>

#include "models/input.h"
#include "models/inputs/lattice_noise.h"

namespace scanlit::models {

/// Where a point lies in the trunk.
template <class T>
struct InTrunk {
  T along;         // along the axis, length
  T rings;         // from the pith, counted in rings
  Vec3<T> radial;  // unit, away from the pith
  Vec3<T> streak;  // a space where fibres, long and thin, are as long as wide
};

struct Trunk {
  Vec3<double> axis{1, 0, 0};      // unit
  Vec3<double> towards{0, -1, 0};  // unit; of it the part across the axis counts
  double pith = 0.6;
  double ring = 0.09;
  double wander = 0.8;
  double streak = 0.012;

  template <class T>
  InTrunk<T> operator()(const Vec3<T>& point) const {
    const Vec3<T> trunk{T(axis.x), T(axis.y), T(axis.z)};
    const Vec3<T> to_pith{T(towards.x * pith), T(towards.y * pith), T(towards.z * pith)};
    const T along = dot(point, trunk);
    const Vec3<T> across = point - trunk * along;
    const Vec3<T> from_pith = across - (to_pith - trunk * dot(to_pith, trunk));
    const T radius = sqrt(dot(from_pith, from_pith));
    // What varies in a trunk varies slowly along it: by how much, by eye.
    const T stray = fractal_noise((across + trunk * (along * T(0.15))) * T(0.2 / ring), 3);
    return {.along = along,
            .rings = radius * T(1 / ring) + T(wander) * stray,
            // On the pith no direction is radial: 0 there, not 0/0.
            .radial = from_pith * (T(1) / max(radius, T(1e-6 * ring))),
            .streak = (across + trunk * (along * T(0.02))) * T(1 / streak)};
  }

  /// A list of parameters, with the trunk's added.
  template <class Function>
  static std::vector<Parameter<Function>> add_to(std::vector<Parameter<Function>> parameters) {
    const auto trunk = std::vector<Parameter<Function>>{
        {"axis", &Function::axis, "axis of the trunk, in object space"},
        {"towards", &Function::towards, "direction of the pith from the object's origin"},
        {"pith", &Function::pith, 0, 1e6, "its distance"},
        {"ring", &Function::ring, 1e-6, 1e6, "width of a yearly ring"},
        {"wander", &Function::wander, 0, 10, "how far rings stray from circles, in rings"},
        {"streak", &Function::streak, 1e-6, 1e6, "width of the streaks of fibres"}};
    parameters.insert(parameters.end(), trunk.begin(), trunk.end());
    return parameters;
  }
};

struct WoodColour : Trunk {
  Rgb<double> early{0.5, 0.3, 0.14}, late{0.25, 0.12, 0.05};
  double streaks = 0.3, pores = 0;

  template <class T>
  Rgb<T> operator()(const SurfacePoint<T>& p) const {
    const InTrunk<T> at = Trunk::operator()(p.object_position);
    const T year = floor(at.rings), season = at.rings - year;
    // Late wood comes gradually and ends with the winter. Years differ.
    const T vigour = T(0.75) + T(0.25) * lattice_gradient(Vec3<T>{year, T(0), T(0)}).x;
    const T dark =
        vigour * smooth_step(0.25, 0.85, season) * (T(1) - smooth_step(0.92, 1.0, season));
    const T fibres = fractal_noise(at.streak, 2);
    const T share = min(max(dark + T(streaks) * fibres, T(0)), T(1));
    const Rgb<T> pale = early * T(1);
    const Rgb<T> wood = pale + (late * T(1) - pale) * share;
    if (pores == 0) return wood;
    // Pores of early wood, cut open lengthwise: short dark dashes.
    const Vec3<T> dash = at.streak * T(0.7) + at.radial * T(31.7);
    const T open = smooth_step(0.25, 0.5, gradient_noise(dash)) * (T(1) - dark);
    return wood * (T(1) - T(pores) * open);
  }

  static InputDescription<WoodColour> describe() {
    return {.name = "wood-colour",
            .title = "rings of early and late wood",
            .source = "solid texture: Peachey 1985, Solid texturing of complex surfaces",
            .parameters = Trunk::add_to<WoodColour>(
                {{"early", &WoodColour::early, 0, 1, "colour of early wood"},
                 {"late", &WoodColour::late, 0, 1, "colour of late wood"},
                 {"streaks", &WoodColour::streaks, 0, 1, "how much fibres differ in colour"},
                 {"pores", &WoodColour::pores, 0, 1, "how dark pores are"}})};
  }
};

struct WoodFibre : Trunk {
  double curl_deg = 0, wave = 0.12, unrest_deg = 3;

  template <class T>
  Rgb<T> operator()(const SurfacePoint<T>& p) const {
    const InTrunk<T> at = Trunk::operator()(p.object_position);
    const Vec3<T> trunk{T(axis.x), T(axis.y), T(axis.z)};
    const Vec3<T> tangential = cross(trunk, at.radial);
    // Waves keep step over a few wave lengths, across the trunk and along it.
    const Vec3<T> at_wave = p.object_position * T(0.25 / wave);
    const T phase = at.along * T(2 * pi / wave) + T(4) * fractal_noise(at_wave, 2);
    const T strength = T(0.7) + T(0.6) * gradient_noise(at_wave * T(0.7));
    const T curl = T(curl_deg * pi / 180) * strength * sin(phase);
    const T unrest = T(unrest_deg * pi / 180);
    const Vec3<T> u = trunk + at.radial * (curl + unrest * fractal_noise(at.streak, 2)) +
                      tangential * (T(0.4) * curl + unrest * gradient_noise(at.streak * T(1.3)));
    return {u.x, u.y, u.z};
  }

  static InputDescription<WoodFibre> describe() {
    return {.name = "wood-fibre",
            .title = "direction of wood's fibres",
            .source = "for the model of Marschner, Westin, Arbree, Moon 2005",
            .parameters = Trunk::add_to<WoodFibre>(
                {{"curl", &WoodFibre::curl_deg, 0, 45, "how far fibres wave, in degrees"},
                 {"wave", &WoodFibre::wave, 1e-6, 1e6, "length of a wave"},
                 {"unrest", &WoodFibre::unrest_deg, 0, 45, "how far each strays, in degrees"}})};
  }

 private:
  static constexpr double pi = std::numbers::pi;
};

inline const RegisteredInput<WoodColour> wood_colour_registered;
inline const RegisteredInput<WoodFibre> wood_fibre_registered;

}  // namespace scanlit::models
