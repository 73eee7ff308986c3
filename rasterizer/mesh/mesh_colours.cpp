#include "rasterizer/mesh/mesh_colours.h"

#include <algorithm>
#include <array>

#include "rasterizer/image/image_encoding.h"

namespace scanlit::detail {

namespace {

/// Of the 256 codes: a power function for every channel would take longer than all the reading.
const std::array<float, 256>& linear_of_code() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> linear{};
    for (std::size_t code = 0; code < 256; ++code)
      linear[code] = float(linear_from_srgb(double(code) / 255));
    return linear;
  }();
  return table;
}

double largest(ColourCode code) {
  switch (code) {
    case ColourCode::fraction: return 1;
    case ColourCode::eight_bit: return 255;
    case ColourCode::sixteen_bit: return 65535;
  }
  return 1;
}

float linear(double value, ColourCode code) {
  switch (code) {
    case ColourCode::fraction: return float(value);
    case ColourCode::eight_bit: return linear_of_code()[std::size_t(value)];
    case ColourCode::sixteen_bit: return float(linear_from_srgb(value / 65535));
  }
  return 1;
}

}  // namespace

std::vector<glm::vec3> linear_colours(const std::vector<glm::dvec3>& colours, ColourCode code,
                                      Repairs& repairs) {
  std::vector<glm::vec3> result;
  result.reserve(colours.size());
  for (const glm::dvec3& colour : colours) {
    glm::vec3& out = result.emplace_back();
    bool clamped = false;
    for (int c = 0; c < 3; ++c) {
      const double held = colour[c] > 0 ? std::min(colour[c], largest(code)) : 0;  // NaN: 0
      clamped |= held != colour[c];
      out[c] = linear(held, code);
    }
    repairs.clamped_colours += clamped;
  }
  return result;
}

}  // namespace scanlit::detail
