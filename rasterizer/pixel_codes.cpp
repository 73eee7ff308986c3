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

namespace {

/// The codes of srgb_from_linear, within .026. As pow, but with polynomials of lower degree,
/// through Chebyshev's nodes: log2(m) / 2.4 for m in [1, 2] is within 4.8e-5, 2^r for |r| <= 1/2
/// within 1e-4 of itself.
Batch near_srgb_code(const Batch& x) {
  const hn::RebindToSigned<Batch::Tag> ints;
  const auto bits = hn::BitCast(ints, x.raw);
  const Batch exponent = hn::ConvertTo(Batch::tag, hn::ShiftRight<23>(bits));
  const auto mantissa = hn::And(bits, hn::Set(ints, 0x007fffff));
  const Batch m = hn::BitCast(Batch::tag, hn::Or(mantissa, hn::Set(ints, 0x3f800000)));
  const Batch log_m = mul_add(
      mul_add(mul_add(mul_add(m, -0.0326836151f, 0.260846743f), m, -0.865972987f), m, 1.67883808f),
      m, Batch(-1.04098048 + 8.07159644 - 127 / 2.4));  // with log2(255 * 1.055)
  const Batch y = mul_add(exponent, 1 / 2.4, log_m);
  const Batch whole(12582912.0f), shifted = y + whole, r = y - (shifted - whole);
  const Batch power =
      mul_add(mul_add(mul_add(r, 0.0558382829f, 0.242639479f), r, 0.693136734f), r, 0.999924557f);
  const auto scale = hn::ShiftLeft<23>(hn::BitCast(ints, shifted.raw));
  const Batch scaled = hn::BitCast(Batch::tag, hn::Add(hn::BitCast(ints, power.raw), scale));
  return select(x <= Batch(0.0031308f), Batch(255 * 12.92) * x, scaled - Batch(255 * 0.055));
}

}  // namespace

Rgb<Batch> PixelEncoder::near_srgb_codes(const Rgb<Batch>& linear) {
  return {near_srgb_code(linear.r), near_srgb_code(linear.g), near_srgb_code(linear.b)};
}

// limit_: half a code less 255 times the error above, or what rounding the product (2^-17) and the
// border to float adds.
PixelEncoder::PixelEncoder(ColourFormat format, bool near)
    : colour_(encoder(format == ColourFormat::srgb_8bit)),
      alpha_(encoder(false)),
      srgb_(format == ColourFormat::srgb_8bit),
      near_(near),
      limit_(0.5f - (srgb_ ? 2.5e-4f : 6e-5f)) {}

Rgb<Batch> PixelEncoder::srgb_codes(const Rgb<Batch>& linear) {
  return Rgb<Batch>{srgb_from_linear(linear.r), srgb_from_linear(linear.g),
                    srgb_from_linear(linear.b)} *
         Batch(255);
}

/// Where rounding errors may decide between two codes, by the table.
hn::Vec<PixelEncoder::Tag> PixelEncoder::checked(const Rgb<Batch>& linear) const {
  const Rgb<Batch> scaled = !srgb_  ? linear * Batch(255)
                            : near_ ? near_srgb_codes(linear)
                                    : srgb_codes(linear);
  const Rounded red(scaled.r), green(scaled.g), blue(scaled.b);
  if (!near_ && !none(max(max(red.off, green.off), blue.off) > limit_)) return exact(linear);
  return packed(red.code, green.code, blue.code);
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
