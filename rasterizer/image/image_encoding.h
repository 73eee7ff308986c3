// How linear light becomes the 0..255 of an integer image file, and back. Used by stage (11).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "rasterizer/image.h"

namespace scanlit {

/// IEC 61966-2-1, sRGB: from an encoded value 0..1 to linear light.
inline double linear_from_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// Linear light to the nearest of the 256 codes, nearest meaning after encoding.
class EightBitEncoder {
 public:
  explicit EightBitEncoder(Encoding encoding) {
    const auto linear = [&](double code) {
      return encoding == Encoding::srgb ? linear_from_srgb(code / 255) : code / 255;
    };
    for (int code = 1; code <= 256; ++code) {
      const double threshold = linear(code - 0.5);
      threshold_[code] = float(threshold);
      if (threshold_[code] < threshold) threshold_[code] = std::nextafterf(threshold_[code], 2);
    }
    for (int i = 0, code = 0; i < guess_count; ++i) {
      while (float(i) / guess_count >= threshold_[code + 1]) ++code;
      guess_[i] = std::uint8_t(code);
    }
  }

  /// 0 for NaN and below 0, 255 above 1.
  std::uint8_t operator()(float value) const {
    if (!(value > 0)) return 0;
    if (value >= 1) return 255;
    // A table alone would be off by one near a threshold; a power function per channel would take
    // longer than rendering the picture.
    int code = guess_[int(value * guess_count)];
    while (value >= threshold_[code + 1]) ++code;
    return std::uint8_t(code);
  }

  /// Whether the value is more than the format can hold, by at least half a code: a white surface
  /// lit head-on is 1 up to rounding and not too bright.
  bool clips(float value) const { return value >= threshold_[256]; }

 private:
  static constexpr int guess_count = 4096;
  std::array<float, 257> threshold_{};  // [code]: the least value with that code; [0] unused
  std::array<std::uint8_t, guess_count> guess_{};  // the code of i / guess_count
};

}  // namespace scanlit
