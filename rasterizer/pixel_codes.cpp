#include "rasterizer/pixel_codes.h"

#include "rasterizer/image/image_encoding.h"

namespace scanlit {

namespace {

const EightBitEncoder& encoder(bool srgb) {
  static const EightBitEncoder encoders[] = {EightBitEncoder(Encoding::linear),
                                             EightBitEncoder(Encoding::srgb)};
  return encoders[srgb];
}

}  // namespace

Batch srgb_from_linear(const Batch& x) {
  // Below 0.0031308 the power is not used, and near 0 its logarithm would be costly subnormals'.
  const Batch power = exp(Batch(1 / 2.4) * log(max(x, Batch(0.003f))));
  return select(x <= Batch(0.0031308f), Batch(12.92f) * x, mul_add(1.055f, power, -0.055f));
}

// limit_: half a code less 255 times the error above, or what rounding the product (2^-17) and the
// border to float adds.
PixelEncoder::PixelEncoder(ColourFormat format)
    : colour_(encoder(format == ColourFormat::srgb_8bit)),
      alpha_(encoder(false)),
      srgb_(format == ColourFormat::srgb_8bit),
      limit_(0.5f - (srgb_ ? 2.5e-4f : 6e-5f)) {}

Rgb<Batch> PixelEncoder::srgb_codes(const Rgb<Batch>& linear) {
  return Rgb<Batch>{srgb_from_linear(linear.r), srgb_from_linear(linear.g),
                    srgb_from_linear(linear.b)} *
         Batch(255);
}

hn::Vec<PixelEncoder::Tag> PixelEncoder::exact(const Rgb<Batch>& linear) const {
  const auto codes = [&](const Batch& channel) {
    float values[Batch::lanes];
    std::uint32_t result[Batch::lanes];
    channel.store(values);
    for (int i = 0; i < Batch::lanes; ++i) result[i] = colour_(values[i]);
    return hn::LoadU(Tag(), result);
  };
  return packed(codes(linear.r), codes(linear.g), codes(linear.b));
}

void PixelEncoder::row(std::span<const float> rgba, std::uint8_t* out) const {
  for (std::size_t i = 0; i < rgba.size(); ++i)
    out[i] = i % 4 == 3 ? alpha_(rgba[i]) : colour_(rgba[i]);
}

}  // namespace scanlit
