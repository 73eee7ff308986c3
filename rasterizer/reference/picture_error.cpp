#include "rasterizer/reference/picture_error.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace scanlit {

namespace {

/// Sums, until all pixels are in.
struct Gathering {
  PixelErrors errors;
  double linear2 = 0, steps2 = 0;

  void add(const Rgb<double>& reference, const Rgb<double>& picture, Encoding encoding) {
    bool differs = false;
    for (const auto channel : {&Rgb<double>::r, &Rgb<double>::g, &Rgb<double>::b}) {
      const double wanted = reference.*channel, found = picture.*channel;
      const double linear = std::abs(found - wanted);
      const double wanted_code = 255 * encoded(wanted, encoding);
      const double found_code = 255 * encoded(found, encoding);
      const double steps = std::abs(found_code - wanted_code);
      errors.max_linear = std::max(errors.max_linear, linear), linear2 += linear * linear;
      errors.max_steps = std::max(errors.max_steps, steps), steps2 += steps * steps;
      differs |= std::round(wanted_code) != std::round(found_code);
    }
    ++errors.pixels;
    errors.differing += differs;
  }
  PixelErrors finished() const {
    PixelErrors result = errors;
    const double values = 3 * std::max(1.0, double(errors.pixels));
    result.rms_linear = std::sqrt(linear2 / values);
    result.rms_steps = std::sqrt(steps2 / values);
    return result;
  }
};

/// In world units, at a distance from the eye.
double pixel_width(const Camera& camera, int picture_height, double distance) {
  if (camera.projection == Projection::orthographic) return camera.height / picture_height;
  return 2 * std::tan(glm::radians(camera.fov_deg) / 2) * distance / picture_height;
}

}  // namespace

double encoded(double linear, Encoding encoding) {
  const double x = std::clamp(linear, 0.0, 1.0);
  if (encoding == Encoding::linear) return x;
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

std::vector<bool> silhouettes(const ExactPicture& a, const ExactPicture& b, const Camera& camera) {
  constexpr double leap = 10, other_part = 50;  // pixel widths
  const double crease = std::sqrt(0.75);        // cosine of 30 degrees
  std::vector<bool> result(a.pixel_count());
  const auto apart = [&](const ExactPicture& p, std::size_t i, const ExactPicture& q, std::size_t j,
                         double widths) {
    if (p.object[i] != q.object[j]) return true;
    if (p.object[i] == no_id) return false;
    if (glm::dot(p.normal[i], q.normal[j]) < crease) return true;
    const double nearest = std::min(p.distance[i], q.distance[j]);
    return std::abs(p.distance[i] - q.distance[j]) >
           widths * pixel_width(camera, a.height, nearest);
  };
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const auto pixel = [&](int column, int row) {
        return std::size_t(row) * std::size_t(a.width) + std::size_t(column);
      };
      const std::size_t i = pixel(x, y);
      bool edge = apart(a, i, b, i, other_part);
      for (int row = std::max(y - 1, 0); row <= std::min(y + 1, a.height - 1); ++row)
        for (int column = std::max(x - 1, 0); column <= std::min(x + 1, a.width - 1); ++column)
          edge |=
              apart(a, i, a, pixel(column, row), leap) || apart(b, i, b, pixel(column, row), leap);
      result[i] = edge;
    }
  return result;
}

PictureError compare(const ExactPicture& reference, const ExactPicture& picture, Encoding encoding,
                     const std::vector<bool>& silhouette) {
  const bool with_ids = std::ranges::any_of(picture.object, [](auto id) { return id != no_id; });
  PictureError result;
  Gathering interior, border;
  for (std::size_t i = 0; i < reference.pixel_count(); ++i) {
    const Rgb<double>& wanted = reference.colour[i];
    result.peak = std::max({result.peak, wanted.r, wanted.g, wanted.b});
    const bool in_reference = reference.object[i] != no_id;
    const bool in_picture = with_ids ? picture.object[i] != no_id : in_reference;
    if (!in_reference && !in_picture) continue;
    if (with_ids)
      result.different_ids +=
          reference.object[i] != picture.object[i] || reference.triangle[i] != picture.triangle[i];
    const bool kept_apart = in_reference != in_picture || (!silhouette.empty() && silhouette[i]);
    (kept_apart ? border : interior).add(wanted, picture.colour[i], encoding);
  }
  result.interior = interior.finished(), result.silhouette = border.finished();
  return result;
}

}  // namespace scanlit
