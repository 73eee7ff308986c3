// Lafortune: a sum of cosine lobes, each a Phong lobe about a direction of its own. Few numbers,
// fitted to measurements, describe many real surfaces.
//
//   f = rd / pi + sum over lobes max(0, Cx lx vx + Cy ly vy + Cz lz vz)^n
//
// Eric P. F. Lafortune, Sing-Choong Foo, Kenneth E. Torrance, Donald P. Greenberg, "Non-linear
// approximation of reflectance functions", SIGGRAPH 1997. What is returned is pi f (N.L).
//
//   rd       diffuse reflectance per channel
//   C, n     of a lobe, each per channel. Cx = Cy makes it isotropic. -Cx = -Cy = Cz is Phong's
//            lobe; Cz relatively larger, one that leaves more upright than the mirror direction;
//            all positive, one that goes back to the light
#pragma once

#include <array>
#include <vector>

#include "models/formula.h"

namespace scanlit::models {

/// A lobe of one channel, in a form that does not cancel. The dot product D(l, v) of C is at most
/// C0 = max(|Cx|, |Cy|, |Cz|). With k = |C| / C0, and s the sign of C,
///
///   1 - D / C0 = sum over axes of [(1 - k) (l^2 + v^2) + k (l - s v)^2] / 2
///
/// is a sum of squares: Cosine's versine, so that (D / C0)^n is exact to float also for n = 1e5.
class LafortuneLobe {
 public:
  /// Throws Error where C0^n is above max_peak.
  LafortuneLobe(const Vec3<double>& c, double n);

  static constexpr double max_peak = 1e6;  // far above any fit, and no product with it overflows

  /// pi D^n.
  template <class T>
  T operator()(const Vec3<T>& l, const Vec3<T>& v) const {
    const auto axis = [](double k, double s, const T& a, const T& b) {
      const T difference = a - T(s) * b;
      return T(0.5 * (1 - k)) * (a * a + b * b) + T(0.5 * k) * (difference * difference);
    };
    const T versine = axis(share_.x, sign_.x, l.x, v.x) + axis(share_.y, sign_.y, l.y, v.y) +
                      axis(share_.z, sign_.z, l.z, v.z);
    return T(pi_peak_) * pow(Cosine<T>::of_versine(versine), T(n_));
  }

 private:
  Vec3<double> share_, sign_;  // k, s
  double n_, pi_peak_;         // pi C0^n
};

struct Lafortune {
  Rgb<double> rd{0.3};
  std::vector<std::array<LafortuneLobe, 3>> lobes;  // of red, green, blue

  template <class T>
  Reflection<T> operator()(const Cosines<T>& c, const ShadingFrame<T>& f) const {
    const Vec3<T> l{f.l.x, f.l.y, c.n_l}, v{f.v.x, f.v.y, c.n_v};
    Rgb<T> sum(T(0));
    for (const auto& [red, green, blue] : lobes)
      sum = sum + Rgb<T>(red(l, v), green(l, v), blue(l, v));
    return {.diffuse = rd * c.n_l, .glossy = sum * c.n_l};
  }
};

Entry lafortune_entry();
inline const bool lafortune_registered = add(lafortune_entry());

}  // namespace scanlit::models
