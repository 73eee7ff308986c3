// A5, Phong and Blinn-Phong. README.md says what each function is to do; `scanlit check .` says how
// far you are. This file is all that you hand in.
//
// T is double or float; a number is written T(2), and dot, cross, exp, pow, sqrt, min, max are
// there. Vec3 has + - and * with a number, Rgb + and * with a number or another Rgb.
#pragma once

#include "answer/model.h"
#include "variant.h"

namespace scanlit {

/// What colour form 1 is made of: colour lives in the surface's three.
struct Tinted {
  Rgb<double> ka, kd, ks;  // Ka, Kd, Ks
};
/// And form 2: the surface has one colour, and the highlight the light's.
struct Plastic {
  double ka, kd, ks;
  Rgb<double> object_colour;
};
struct Lamp {
  double ambient, intensity;  // Ia, Ii
  Rgb<double> colour;
};

struct Phong {
  /// Of Phong's (R.V)^n.
  static double phong_exponent() {
    //<< TODO(A5.1) The exponent n, from how your course gives it.
    const double given = variant::shininess;
    switch (variant::shininess_given_as) {
      case 0: return given;
      case 1: return std::log(0.5) / std::log(std::cos(given * std::numbers::pi / 180));
      default: return std::exp2(10 * given);
    }
    //== return 1;
    //>>
  }
  /// Of Blinn's (N.H)^n.
  static double blinn_exponent() {
    //<< TODO(A5.1) And Blinn's.
    return variant::same_width ? 4 * phong_exponent() : phong_exponent();
    //== return 1;
    //>>
  }

  /// Half-way between two unit directions; unit.
  template <class T>
  static Vec3<T> half_vector(const Vec3<T>& l, const Vec3<T>& v) {
    //<< TODO(A5.2) H
    const Vec3<T> sum = l + v;
    return sum * (T(1) / sqrt(dot(sum, sum)));
    //== return l;
    //>>
  }
  /// Where a mirror of unit normal n sends the light from l.
  template <class T>
  static Vec3<T> mirrored(const Vec3<T>& n, const Vec3<T>& l) {
    //<< TODO(A5.2) R
    return T(2) * dot(n, l) * n - l;
    //== return l;
    //>>
  }

  /// The three terms: normal, light and viewer as your variant has them.
  template <class T>
  static T diffuse(const Vec3<T>& normal, const Vec3<T>& light) {
    //<< TODO(A5.3) N.L
    return max(T(0), dot(unit(normal), to_light(light)));
    //== return T(0.5);
    //>>
  }
  template <class T>
  static T phong(const Vec3<T>& normal, const Vec3<T>& light, const Vec3<T>& viewer, const T& n) {
    //<< TODO(A5.4) (R.V)^n
    const Vec3<T> N = unit(normal), L = to_light(light);
    if (!(dot(N, L) > T(0))) return T(0);
    const T lobe = pow(max(T(0), dot(mirrored(N, L), viewer)), n);
    return variant::with_cosine ? lobe * dot(N, L) : lobe;
    //== return T(0);
    //>>
  }
  template <class T>
  static T blinn(const Vec3<T>& normal, const Vec3<T>& light, const Vec3<T>& viewer, const T& n) {
    //<< TODO(A5.5) (N.H)^n
    const Vec3<T> N = unit(normal), L = to_light(light);
    if (!(dot(N, L) > T(0))) return T(0);
    const T lobe = pow(max(T(0), dot(N, half_vector(L, viewer))), n);
    return variant::with_cosine ? lobe * dot(N, L) : lobe;
    //== return T(0);
    //>>
  }

  /// Colour form 1, of the diffuse and the glossy term.
  template <class T>
  static Rgb<T> tinted(const Tinted& surface, const Lamp& lamp, const T& diffuse, const T& glossy) {
    //<< TODO(A5.6) I = Ka Ia + {Kd (N.L) + Ks (N.H)^n} Ii
    const Rgb<T> lit = surface.kd * diffuse + surface.ks * glossy;
    return surface.ka * T(lamp.ambient) + lamp.colour * lit * T(lamp.intensity);
    //== return Rgb<T>(T(diffuse));
    //>>
  }
  /// Colour form 2.
  template <class T>
  static Rgb<T> plastic(const Plastic& surface, const Lamp& lamp, const T& diffuse,
                        const T& glossy) {
    //<< TODO(A5.7) I = {Ka Ia + Kd (N.L) Ii} object_colour + Ks (N.H)^n Ii light_colour
    const T body = T(surface.ka * lamp.ambient) + T(surface.kd * lamp.intensity) * diffuse;
    return surface.object_colour * body + lamp.colour * (T(surface.ks * lamp.intensity) * glossy);
    //== return Rgb<T>(T(diffuse));
    //>>
  }
  //<<

 private:
  template <class T>
  static Vec3<T> unit(const Vec3<T>& a) {
    return a * (T(1) / sqrt(dot(a, a)));
  }
  template <class T>
  static Vec3<T> to_light(const Vec3<T>& light) {
    return variant::light_travels ? -light : light;
  }
  //>>
};

}  // namespace scanlit
