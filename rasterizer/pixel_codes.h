// (10) Linear light to the 8-bit codes of a framebuffer's pixels, in vectors.
#pragma once

#include <cstdint>
#include <span>

#include "rasterizer/batch.h"
#include "rasterizer/framebuffer.h"

namespace scanlit {

class EightBitEncoder;

/// Where the colours of a tile's fragments go.
struct ColourTarget {
  float* linear = nullptr;        // RGBA; a pixel's fragments add up
  std::uint8_t* codes = nullptr;  // else RGBA8; each pixel is written once
  std::size_t first_pixel = 0;    // the pixel that is first there, as FragmentSpan::pixel counts
  ColourFormat format = ColourFormat::linear_float;  // of codes
};

/// The same codes as EightBitEncoder's, to the last float. NaN becomes 0.
class PixelEncoder {
 public:
  /// Of an 8-bit format.
  explicit PixelEncoder(ColourFormat format);

  using Tag = hn::RebindToUnsigned<Batch::Tag>;
  /// R in the lowest 8 bits, then G, B, and alpha 255.
  hn::Vec<Tag> opaque(const Batch& r, const Batch& g, const Batch& b) const;
  /// RGBA pixels to as many bytes; alpha is linear.
  void row(std::span<const float> rgba, std::uint8_t* out) const;

 private:
  hn::Vec<Tag> codes(const Batch& linear) const;

  const EightBitEncoder& colour_;
  const EightBitEncoder& alpha_;
  bool srgb_;
};

}  // namespace scanlit
