// (10) Linear light to the 8-bit codes of a framebuffer's pixels, in vectors.
#pragma once

#include <cstdint>
#include <span>

#include "rasterizer/batch.h"
#include "rasterizer/fragment_span.h"
#include "rasterizer/vec.h"

namespace scanlit {

class EightBitEncoder;

/// Where the colours of a tile's fragments go.
struct ColourTarget {
  float* linear = nullptr;                           // RGBA; a pixel's fragments add up
  std::uint8_t* codes = nullptr;                     // else RGBA8; fragments replace what was there
  std::size_t width = 0;                             // of the picture
  std::size_t first_pixel = 0;                       // the pixel that is first there, y * width + x
  std::size_t first_in_planes = 0;                   // and in the other planes of the framebuffer
  ColourFormat format = ColourFormat::linear_float;  // of codes
  bool near = false;                                 // codes may be off by near_codes

  /// Where a pixel of a FragmentSpan begins in `linear` or `codes`.
  std::size_t element(std::uint32_t packed_pixel) const {
    return 4 * (index_of_pixel(packed_pixel, width) - first_pixel);
  }
};

/// The encoding of IEC 61966-2-1, from linear light 0..1. Maximum error: 5e-7.
Batch srgb_from_linear(const Batch& x);

/// By how much a code may be off, before it is rounded, where RenderSettings::tolerance allows it.
constexpr double near_codes = 0.035;

/// The same codes as EightBitEncoder's, to the last float; or near ones, in half the time. NaN
/// becomes 0.
class PixelEncoder {
 public:
  /// Of an 8-bit format.
  explicit PixelEncoder(ColourFormat format, bool near = false);

  using Tag = hn::RebindToUnsigned<Batch::Tag>;
  /// R in the lowest 8 bits, then G, B, and alpha 255.
  hn::Vec<Tag> opaque(const Batch& r, const Batch& g, const Batch& b) const {
    const Rgb<Batch> linear{clamped(r), clamped(g), clamped(b)};
    if (srgb_ || !fused) return checked(linear);
    return packed(product_code(linear.r), product_code(linear.g), product_code(linear.b));
  }
  /// RGBA pixels to as many bytes; alpha is linear.
  void row(std::span<const float> rgba, std::uint8_t* out) const;

 private:
  static constexpr bool fused = HWY_NATIVE_FMA;  // mul_add is

  hn::Vec<Tag> checked(const Rgb<Batch>& linear) const;
  /// 255 x to the nearest whole number, where mul_add is fused: rounded once, it needs no check.
  static hn::Vec<Tag> product_code(const Batch& x) {
    return lowest_byte(mul_add(x, Batch(255), Batch(rounder)));
  }
  /// Adding 1.5 * 2^23 rounds to a whole number, which then stands in the lowest bits.
  static constexpr float rounder = 12582912.0f;
  static hn::Vec<Tag> lowest_byte(const Batch& shifted) {
    return hn::And(hn::BitCast(Tag(), shifted.raw), hn::Set(Tag(), 255));
  }
  /// NaN becomes 0.
  static Batch clamped(const Batch& linear) { return min(max(linear, Batch(0)), Batch(1)); }

  /// 0..255 to the nearest whole number, and how far off that is: at most 1/2.
  struct Rounded {
    hn::Vec<Tag> code;
    Batch off;

    explicit Rounded(const Batch& x) {
      const Batch whole(rounder), shifted = x + whole;
      code = lowest_byte(shifted);
      off = abs(x - (shifted - whole));
    }
  };
  static hn::Vec<Tag> packed(hn::Vec<Tag> r, hn::Vec<Tag> g, hn::Vec<Tag> b) {
    const auto high = hn::Or(hn::ShiftLeft<16>(b), hn::Set(Tag(), 0xff000000u));
    return hn::Or(hn::Or(r, hn::ShiftLeft<8>(g)), high);
  }
  // 0..255, not rounded.
  static Rgb<Batch> srgb_codes(const Rgb<Batch>& linear);
  static Rgb<Batch> near_srgb_codes(const Rgb<Batch>& linear);
  hn::Vec<Tag> exact(const Rgb<Batch>& linear) const;

  const EightBitEncoder& colour_;
  const EightBitEncoder& alpha_;
  bool srgb_, near_;
  Batch limit_;  // so far off, rounding errors may decide between two codes
};

}  // namespace scanlit
