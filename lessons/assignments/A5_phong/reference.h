// Phong and Blinn-Phong as a seed draws them: how shininess is given, what normal, light and viewer
// are, whether the glossy term has a cosine.
#pragma once

#include <array>
#include <cstdint>

#include "lessons/assignments/judge/assignment.h"
#include "lessons/assignments/judge/model_questions.h"

namespace scanlit::assignments::phong {

struct Variant {
  enum class Shininess { exponent, half_width, gloss } given_as;
  double given;
  bool same_width;     // Blinn's exponent is 4 times Phong's, else the same
  bool with_cosine;    // the glossy term has the factor N.L
  bool light_travels;  // `light` points away from the light

  explicit Variant(std::uint64_t seed);

  double phong_exponent() const;
  double blinn_exponent() const { return (same_width ? 4 : 1) * phong_exponent(); }
  Words words() const;
};

/// What a term is asked for: normal, light and viewer in a common space, of Directions in the
/// shading frame.
struct Point {
  Vec3<double> normal, light, viewer;
};

/// Where the shading frame lies in that space, and how long the normal is, which is interpolated.
struct Placement {
  Vec3<double> t, b, n;
  double normal_length = 1;

  Vec3<double> placed(const Vec3<double>& a) const { return t * a.x + b * a.y + n * a.z; }
  Point point(const Variant& variant, const Directions& d) const;
};
Placement seeded_placement(std::uint64_t seed);

Vec3<double> unit(const Vec3<double>& a);
Vec3<double> mirrored(const Vec3<double>& n, const Vec3<double>& l);

double diffuse(const Directions& d);
double phong(const Variant& variant, const Directions& d);
double blinn(const Variant& variant, const Directions& d);

/// Colour forms 1 and 2. A surface is Ka, Kd, Ks; or ka, kd, ks, as greys, and the object's colour.
struct Surface {
  Rgb<double> ka, kd, ks, object_colour{1};
};
struct Lamp {
  double ambient, intensity;
  Rgb<double> colour;
};
Rgb<double> tinted(const Surface& s, const Lamp& lamp, double diffuse, double glossy);
Rgb<double> plastic(const Surface& s, const Lamp& lamp, double diffuse, double glossy);

}  // namespace scanlit::assignments::phong
