// A7, a model of your choice. README.md says what each function is to do; `scanlit check .` says
// how far you are. This file is all that you hand in.
//
// c holds the cosines c.n_l, c.n_v, c.n_h and c.v_h: N.L, N.V, N.H and V.H. f holds unit directions
// in the shading frame (x along the brush, z along N): f.l, f.v and f.h are L, V and H. T is double
// or float; a number is written T(2), and exp, pow, sqrt, tan, min, max are there.
#pragma once

#include "answer/model.h"
#include "variant.h"

namespace scanlit {

/// Which one you hand in. The other two may stay as they are.
enum class Choice { ward = 1, lafortune, oren_nayar };
constexpr Choice choice = Choice::ward;

struct Ward {
  /// How many facets face H: 1 where H is N.
  template <class T>
  static T first(const Cosines<T>& c, const ShadingFrame<T>& f) {
    //<< TODO(A7.1) The exponential, if you have chosen Ward.
    const T x = f.h.x / (T(width(variant::ward::x)) * f.h.z);
    const T y = f.h.y / (T(width(variant::ward::y)) * f.h.z);
    return exp(-(x * x + y * y));
    //== return T(0.5);
    //>>
  }

  /// f_r, from the right exponential.
  template <class T>
  static Rgb<T> second(const T& exponential, const Cosines<T>& c, const ShadingFrame<T>& f) {
    //<< TODO(A7.2) And f_r.
    const T a(width(variant::ward::x) * width(variant::ward::y)), pi(std::numbers::pi);
    const T cosines = c.n_l * c.n_v;
    if (variant::ward::normalisation == 0)
      return variant::ward::rho * (exponential / (T(4) * pi * a * sqrt(cosines)));
    if (variant::ward::normalisation == 1)
      return variant::ward::rho * (exponential / (T(4) * pi * a * cosines));
    const Vec3<T> h = f.l + f.v;
    const T hz2 = h.z * h.z;
    return variant::ward::rho * (exponential * dot(h, h) / (pi * a * hz2 * hz2));
    //== return Rgb<T>(exponential * c.n_v);
    //>>
  }
  //<<

 private:
  static double width(double given) {
    return variant::ward::given_as_angles ? std::tan(given * std::numbers::pi / 180)
                                          : std::numbers::sqrt2 * given;
  }
  //>>
};

struct Lafortune {
  /// Of the first lobe.
  template <class T>
  static Rgb<T> first(const Cosines<T>& c, const ShadingFrame<T>& f) {
    //<< TODO(A7.1) A lobe, if you have chosen Lafortune.
    return lobe(variant::lafortune::lobes[0], f);
    //== return Rgb<T>(T(0.5));
    //>>
  }

  /// f_r, from the right first lobe.
  template <class T>
  static Rgb<T> second(const Rgb<T>& lobe1, const Cosines<T>& c, const ShadingFrame<T>& f) {
    //<< TODO(A7.2) And f_r: there is a second lobe.
    return variant::lafortune::diffuse * T(1 / std::numbers::pi) + lobe1 +
           lobe(variant::lafortune::lobes[1], f);
    //== return lobe1 * c.n_v;
    //>>
  }
  //<<

 private:
  template <class T>
  static Rgb<T> lobe(const variant::lafortune::Lobe& lobe, const ShadingFrame<T>& f) {
    const auto channel = [&f](double cx, double cy, double cz, double n) {
      const T dot = T(cx) * f.l.x * f.v.x + T(cy) * f.l.y * f.v.y + T(cz) * f.l.z * f.v.z;
      return pow(max(T(0), dot), T(n));
    };
    return {channel(lobe.cx.r, lobe.cy.r, lobe.cz.r, lobe.n.r),
            channel(lobe.cx.g, lobe.cy.g, lobe.cz.g, lobe.n.g),
            channel(lobe.cx.b, lobe.cy.b, lobe.cz.b, lobe.n.b)};
  }
  //>>
};

struct OrenNayar {
  /// max(0, cos phi) sin A tan B.
  template <class T>
  static T first(const Cosines<T>& c, const ShadingFrame<T>& f) {
    //<< TODO(A7.1) What the grooves see of the light, if you have chosen Oren-Nayar.
    const T along = f.l.x * f.v.x + f.l.y * f.v.y;  // cos phi sin A sin B
    return max(T(0), along) / max(c.n_l, c.n_v);
    //== return T(0.5);
    //>>
  }

  /// f_r, from the right one of those.
  template <class T>
  static Rgb<T> second(const T& groove, const Cosines<T>& c, const ShadingFrame<T>& f) {
    //<< TODO(A7.2) And f_r.
    const double given = variant::oren_nayar::roughness;
    const double sigma =
        variant::oren_nayar::given_in_degrees ? given * std::numbers::pi / 180 : std::atan(given);
    const double s2 = sigma * sigma;
    const T flat(1 - 0.5 * s2 / (s2 + variant::oren_nayar::constant));
    const T rough(0.45 * s2 / (s2 + 0.09));
    return variant::oren_nayar::rho * ((flat + rough * groove) * T(1 / std::numbers::pi));
    //== return Rgb<T>(groove * c.n_v);
    //>>
  }
};

/// f_r, or the braces, as your variant has it, of the f_r that is right.
template <class T>
Rgb<T> returned(const Rgb<T>& f_r, const Cosines<T>& c) {
  //<< TODO(A7.3) What is returned.
  return variant::wants_braces ? f_r * (T(std::numbers::pi) * c.n_l) : f_r;
  //== return f_r * (c.n_v * c.n_v);
  //>>
}

/// The model. Nothing is to be done here.
template <class Model, class T>
Rgb<T> whole(const Cosines<T>& c, const ShadingFrame<T>& f) {
  return returned(Model::second(Model::first(c, f), c, f), c);
}

}  // namespace scanlit
