// How rough a surface is, and in which direction: all that an isotropic distribution of facets and
// its anisotropic twin differ in.
//
// Facets are steep where tan(alpha) is large, alpha the angle from N to the facet's normal H. A
// roughness m scales slopes: Beckmann's distribution is exp(-(tan(alpha) / m)^2). A brushed surface
// has two: ax along x, the tangent, and ay along y, the bitangent; smaller along its grooves than
// across them.
#pragma once

#include <numbers>

#include "rasterizer/formula_model.h"

namespace scanlit::models::microfacet {

/// tan^2 of a direction's angle to N. In the surface, where the cosine is 0, it is 1e36: with the
/// square of a still smaller cosine float would divide by 0, and 0 * inf is NaN.
template <class T>
T bounded_tan2(const T& sin2, const T& cosine) {
  return sin2 / max(cosine * cosine, T(1e-36));
}

template <class P>
struct Isotropic {
  P m;

  /// 1 / (pi m^2): what D is at N, for Beckmann's and for GGX.
  P peak() const { return P(std::numbers::inv_pi) / (m * m); }

  /// (sin(alpha) / m)^2 of a facet. sin2() keeps its precision near N.
  template <class T>
  T scaled_sin2(const Cosine<T>& n_h, const Vec3<T>&) const {
    return n_h.sin2() * T(P(1.0) / (m * m));
  }

  /// (m tan(theta))^2 of the direction d to the light or viewer, theta = acos(n_d).
  template <class T>
  T projected_tan2(const T& n_d, const Vec3<T>&) const {
    return bounded_tan2(T(m * m) * ((T(1) - n_d) * (T(1) + n_d)), n_d);
  }
};

template <class P>
struct Anisotropic {
  P ax, ay;

  P peak() const { return P(std::numbers::inv_pi) / (ax * ay); }

  /// (hx / ax)^2 + (hy / ay)^2. Widths are at most 1, so it is at least sin^2(alpha), except where
  /// l = -v: there h has no length, n_h = 0 and sin2() = 1, and without the bound the facets in
  /// the surface would be as frequent as those along N.
  template <class T>
  T scaled_sin2(const Cosine<T>& n_h, const Vec3<T>& h) const {
    const T x = h.x * T(P(1.0) / ax), y = h.y * T(P(1.0) / ay);
    return max(x * x + y * y, n_h.sin2());
  }

  /// tan^2(theta) times the squared roughness in d's azimuth, ax^2 cos^2(phi) + ay^2 sin^2(phi).
  template <class T>
  T projected_tan2(const T& n_d, const Vec3<T>& d) const {
    const T x = d.x * T(ax), y = d.y * T(ay);
    return bounded_tan2(x * x + y * y, n_d);
  }
};

}  // namespace scanlit::models::microfacet
