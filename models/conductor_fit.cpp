#include "models/conductor_fit.h"

#include <cmath>
#include <complex>

namespace scanlit::models {

ConductorFit::Channel::Channel(double eta, double k)
    : re_q2_at_grazing(float((eta - 1) * (eta + 1) - k * k)) {
  const auto c2 = chebyshev_nodes<std::tuple_size_v<decltype(re_q)>>();
  auto values = c2;
  const std::complex<double> n(eta, k);
  for (double& value : values) value = std::sqrt(n * n - 1.0 + value).real();
  re_q = interpolate(c2, values);

  // Grazing angles are those where F changes fast.
  constexpr int angles = 256;
  close = true;
  for (int i = 0; i <= angles; ++i) {
    const double root = double(i) / angles, c = root * root;
    const double error = std::abs(reflectance(c) - conductor_reflectance(c, eta, k));
    close = close && error <= tolerance;  // false where it is NaN
  }
}

}  // namespace scanlit::models
