#include "rasterizer/reference/flip.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

namespace scanlit {

namespace {

using Plane = std::vector<double>;
using Colour = Vec3<double>;
constexpr double pi = std::numbers::pi;

struct Size {
  int width, height;
};

// ------------------------------------------------------------------------------------ colour
// spaces

/// From linear sRGB to CIE XYZ, and back; over the white of D65, which is all that is ever needed.
constexpr Colour white{0.950428545, 1.0, 1.088900371};
Colour xyz_over_white(const Colour& c) {
  return {(0.41238656 * c.x + 0.35759149 * c.y + 0.18045049 * c.z) / white.x,
          0.21263682 * c.x + 0.71518298 * c.y + 0.0721802 * c.z,
          (0.01933062 * c.x + 0.11919716 * c.y + 0.95037259 * c.z) / white.z};
}
Colour linear_rgb(const Colour& over_white) {
  const double x = over_white.x * white.x, y = over_white.y, z = over_white.z * white.z;
  return {3.241003275 * x - 1.537398934 * y - 0.498615861 * z,
          -0.969224334 * x + 1.875930071 * y + 0.041554224 * z,
          0.055639423 * x - 0.204011202 * y + 1.057148933 * z};
}

/// The linear opponent space in which the eye's contrast sensitivity is modelled (section 4.1.1).
Colour ycxcz(const Colour& rgb) {
  const Colour c = xyz_over_white(rgb);
  return {116 * c.y - 16, 500 * (c.x - c.y), 200 * (c.y - c.z)};
}
Colour rgb_of_ycxcz(const Colour& c) {
  const double y = (c.x + 16) / 116;
  return linear_rgb({y + c.y / 500, y, y - c.z / 200});
}

/// L*a*b*, with a* and b* made smaller where it is dark, as chroma is seen there: the Hunt effect.
Colour hunt_lab(const Colour& rgb) {
  const auto f = [](double t) {
    constexpr double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
  };
  const Colour c = xyz_over_white(rgb);
  const double lightness = 116 * f(c.y) - 16;
  return {lightness, 0.01 * lightness * 500 * (f(c.x) - f(c.y)),
          0.01 * lightness * 200 * (f(c.y) - f(c.z))};
}

/// A distance for large colour differences: city-block in lightness, Euclidean in chroma.
double hyab(const Colour& a, const Colour& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// ---------------------------------------------------------------------------------------- filters

/// weight(k) for k = -radius .. radius.
std::vector<double> kernel(int radius, const std::function<double(double)>& weight) {
  std::vector<double> result;
  for (int k = -radius; k <= radius; ++k) result.push_back(weight(k));
  return result;
}

/// Filtered along rows by one kernel and along columns by the other; beyond its border a picture
/// goes on as at the border.
Plane filtered(const Plane& in, Size size, const std::vector<double>& across,
               const std::vector<double>& down) {
  const auto pass = [&](const Plane& from, const std::vector<double>& weights, int dx, int dy) {
    const int radius = int(weights.size()) / 2;
    Plane to(from.size());
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        double sum = 0;
        for (int k = -radius; k <= radius; ++k) {
          const int column = std::clamp(x + k * dx, 0, size.width - 1);
          const int row = std::clamp(y + k * dy, 0, size.height - 1);
          sum += weights[std::size_t(k + radius)] *
                 from[std::size_t(row) * std::size_t(size.width) + std::size_t(column)];
        }
        to[std::size_t(y) * std::size_t(size.width) + std::size_t(x)] = sum;
      }
    return to;
  };
  return pass(pass(in, across, 1, 0), down, 0, 1);
}

/// Contrast sensitivity of a channel as a sum of Gaussians a sqrt(pi / b) exp(-pi^2 d^2 / b), d in
/// degrees (equations 3 to 5 and table 1).
struct Sensitivity {
  double a1, b1, a2, b2;
};
constexpr Sensitivity achromatic{1, 0.0047, 0, 1e-5}, red_green{1, 0.0053, 0, 1e-5},
    blue_yellow{34.1, 0.04, 13.5, 0.025};

Plane as_seen(const Plane& channel, Size size, const Sensitivity& s, double per_degree) {
  const int radius = int(std::ceil(3 * std::sqrt(blue_yellow.b1 / (2 * pi * pi)) * per_degree));
  Plane result(channel.size());
  double total = 0;
  for (const auto& [a, b] : {std::pair(s.a1, s.b1), std::pair(s.a2, s.b2)}) {
    if (a == 0) continue;
    const auto gaussian = kernel(radius, [&, b = b](double k) {
      return std::exp(-pi * pi * (k / per_degree) * (k / per_degree) / b);
    });
    const double sum = std::accumulate(gaussian.begin(), gaussian.end(), 0.0);
    const double weight = a * std::sqrt(pi / b);
    const Plane part = filtered(channel, size, gaussian, gaussian);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += weight * part[i];
    total += weight * sum * sum;
  }
  for (double& value : result) value /= total;
  return result;
}

// --------------------------------------------------------------------------- colour and features

/// The picture in YCxCz.
std::vector<Plane> opponent_planes(const ExactPicture& picture) {
  std::vector<Plane> planes(3, Plane(picture.pixel_count()));
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
    const auto shown = [](double c) { return std::clamp(c, 0.0, 1.0); };
    const Rgb<double>& c = picture.colour[i];
    const Colour opponent = ycxcz({shown(c.r), shown(c.g), shown(c.b)});
    planes[0][i] = opponent.x, planes[1][i] = opponent.y, planes[2][i] = opponent.z;
  }
  return planes;
}

/// The colours that are seen at this distance, in the Hunt-adjusted L*a*b*.
std::vector<Colour> seen_colours(const std::vector<Plane>& planes, Size size, double per_degree) {
  const Plane y = as_seen(planes[0], size, achromatic, per_degree);
  const Plane cx = as_seen(planes[1], size, red_green, per_degree);
  const Plane cz = as_seen(planes[2], size, blue_yellow, per_degree);
  std::vector<Colour> result;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const auto shown = [](double c) { return std::clamp(c, 0.0, 1.0); };
    const Colour rgb = rgb_of_ycxcz({y[i], cx[i], cz[i]});
    result.push_back(hunt_lab({shown(rgb.x), shown(rgb.y), shown(rgb.z)}));
  }
  return result;
}

/// A distance of colours to 0..1: the largest that two colours of a screen have, green's and
/// blue's, to 1; small ones spread out (section 4.1.4).
double colour_error(const Colour& a, const Colour& b) {
  constexpr double exponent = 0.7, knee = 0.4, knee_error = 0.95;
  static const double largest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), exponent);
  const double d = std::pow(hyab(a, b), exponent), at_knee = knee * largest;
  return d < at_knee ? d * knee_error / at_knee
                     : knee_error + (d - at_knee) / (largest - at_knee) * (1 - knee_error);
}

/// Edges and points of the luminance: how strong each is (section 4.2).
struct Features {
  Plane edge, point;
};
Features features(const Plane& luminance_y, Size size, double per_degree) {
  const double sigma = 0.5 * 0.082 * per_degree;
  const int radius = int(std::ceil(3 * sigma));
  const auto gauss = [&](double k) { return std::exp(-k * k / (2 * sigma * sigma)); };
  // Weights of one sign sum to 1, those of the other to -1.
  const auto normalised = [](std::vector<double> weights, double across) {
    double positive = 0, negative = 0;
    for (const double w : weights) (w > 0 ? positive : negative) += std::abs(w);
    for (double& w : weights) w /= (w > 0 ? positive : negative) * across;
    return weights;
  };
  const auto smooth = kernel(radius, gauss);
  const double across = std::accumulate(smooth.begin(), smooth.end(), 0.0);
  const auto first = normalised(kernel(radius, [&](double k) { return -k * gauss(k); }), across);
  const auto second = normalised(
      kernel(radius, [&](double k) { return (k * k / (sigma * sigma) - 1) * gauss(k); }), across);

  Plane luminance = luminance_y;
  for (double& y : luminance) y = (y + 16) / 116;
  const auto strength = [&](const std::vector<double>& derivative) {
    Plane x = filtered(luminance, size, derivative, smooth);
    const Plane y = filtered(luminance, size, smooth, derivative);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::hypot(x[i], y[i]);
    return x;
  };
  return {strength(first), strength(second)};
}

}  // namespace

std::vector<double> flip(const ExactPicture& reference, const ExactPicture& picture,
                         double pixels_per_degree) {
  const Size size{reference.width, reference.height};
  const auto a = opponent_planes(reference), b = opponent_planes(picture);
  const auto seen_a = seen_colours(a, size, pixels_per_degree);
  const auto seen_b = seen_colours(b, size, pixels_per_degree);
  const Features in_a = features(a[0], size, pixels_per_degree);
  const Features in_b = features(b[0], size, pixels_per_degree);
  std::vector<double> result;
  for (std::size_t i = 0; i < seen_a.size(); ++i) {
    const double strongest =
        std::max(std::abs(in_a.edge[i] - in_b.edge[i]), std::abs(in_a.point[i] - in_b.point[i]));
    const double feature_error = std::sqrt(strongest / std::numbers::sqrt2);
    result.push_back(std::pow(colour_error(seen_a[i], seen_b[i]), 1 - feature_error));
  }
  return result;
}

double mean_flip(const ExactPicture& reference, const ExactPicture& picture) {
  const auto errors = flip(reference, picture);
  return std::accumulate(errors.begin(), errors.end(), 0.0) / double(errors.size());
}

}  // namespace scanlit
