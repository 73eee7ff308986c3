#include "rasterizer/pixel_codes.h"


#include "rasterizer/image/image_encoding.h"

namespace scanlit {

namespace {

const EightBitEncoder& encoder(bool srgb) {
  static const EightBitEncoder encoders[] = {EightBitEncoder(Encoding::linear),
                                             EightBitEncoder(Encoding::srgb)};
  return encoders[srgb];
}

/// IEC 61966-2-1, from linear light 0..1. Maximum error: 5e-7.
Batch srgb_from_linear(const Batch& x) {
  // Below 0.0031308 the power is not used, and near 0 its logarithm would be costly subnormals'.
  const Batch power = exp(Batch(1 / 2.4) * log(max(x, Batch(0.003f))));
  return select(x <= Batch(0.0031308f), Batch(12.92f) * x, mul_add(1.055f, power, -0.055f));
}

}  // namespace

PixelEncoder::PixelEncoder(ColourFormat format)
    : colour_(encoder(format == ColourFormat::srgb_8bit)),
      alpha_(encoder(false)),
      srgb_(format == ColourFormat::srgb_8bit) {}

hn::Vec<PixelEncoder::Tag> PixelEncoder::codes(const Batch& linear) const {
  const hn::RebindToSigned<Batch::Tag> ints;
  const Batch clamped = min(max(linear, Batch(0)), Batch(1));  // NaN becomes 0
  const Batch encoded = srgb_ ? srgb_from_linear(clamped) : clamped;
  const Batch shifted = mul_add(encoded, 255.0f, 0.5f);
  const auto whole = hn::ConvertTo(ints, shifted.raw);
  // How near a value may be to the border of two codes before rounding decides between them: 255
  // times the error above, and what rounding `shifted` (2^-16) and the border to float adds.
  const Batch doubtful(srgb_ ? 2.5e-4f : 6e-5f);
  const auto near_border = abs(shifted - Batch(hn::Round(shifted.raw))) < doubtful;
  if (none(near_border)) return hn::BitCast(Tag(), whole);
  float values[Batch::lanes];
  std::uint32_t exact[Batch::lanes];
  clamped.store(values);
  for (int i = 0; i < Batch::lanes; ++i) exact[i] = colour_(values[i]);
  return hn::LoadU(Tag(), exact);
}

hn::Vec<PixelEncoder::Tag> PixelEncoder::opaque(const Batch& r, const Batch& g,
                                                const Batch& b) const {
  const auto high = hn::Or(hn::ShiftLeft<16>(codes(b)), hn::Set(Tag(), 0xff000000u));
  return hn::Or(hn::Or(codes(r), hn::ShiftLeft<8>(codes(g))), high);
}

void PixelEncoder::row(std::span<const float> rgba, std::uint8_t* out) const {
  for (std::size_t i = 0; i < rgba.size(); ++i)
    out[i] = i % 4 == 3 ? alpha_(rgba[i]) : colour_(rgba[i]);
}

}  // namespace scanlit
