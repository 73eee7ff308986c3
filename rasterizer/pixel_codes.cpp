#include "rasterizer/pixel_codes.h"

#include <cmath>

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

/// Of each half of an octave from 2^-8 to 1, split in its middle: the parabola through the codes of
/// srgb_from_linear at Chebyshev's nodes, within .034. The first begins at 0.0031308.
struct Parabolas {
  static constexpr int count = 16, first_bits = (127 - 8) << 1;  // exponent and highest bit
  float coefficient[3][count];

  Parabolas() {
    for (int k = 0; k < count; ++k) {
      const double octave = std::exp2(k / 2 - 8), from = k % 2 ? 1.5 : 1;
      const double begin = k == 0 ? 0.0031308 : octave * from, end = octave * (from + .5);
      const double middle = (begin + end) / 2, away = (end - begin) / 2 * std::sqrt(.75);
      const auto code = [](double x) { return 255 * (1.055 * std::pow(x, 1 / 2.4) - .055); };
      const double low = code(middle - away), high = code(middle + away);
      const double slope = (high - low) / (2 * away),
                   bend = ((high + low) / 2 - code(middle)) / (away * away);
      coefficient[0][k] = float(code(middle) - middle * (slope - middle * bend));
      coefficient[1][k] = float(slope - 2 * middle * bend);
      coefficient[2][k] = float(bend);
    }
  }
};
const Parabolas parabolas;

Batch code_by_parabolas(const Batch& x) {
  const hn::RebindToSigned<Batch::Tag> ints;
  const Batch below_1 = min(x, Batch(0x1.fffffep-1f));
  const auto place = hn::Sub(hn::ShiftRight<22>(hn::BitCast(ints, below_1.raw)),
                             hn::Set(ints, Parabolas::first_bits));
  const auto number = hn::IndicesFromVec(Batch::tag, hn::Max(place, hn::Zero(ints)));
  const auto coefficient = [&](int k) -> Batch {
    return hn::TableLookupLanes(hn::LoadU(Batch::tag, parabolas.coefficient[k]), number);
  };
  const Batch code = mul_add(mul_add(coefficient(2), x, coefficient(1)), x, coefficient(0));
  return select(x <= Batch(0.0031308f), Batch(255 * 12.92) * x, code);
}

/// The codes of srgb_from_linear, within near_codes: by parabolas, where one vector holds them all.
/// Else as pow, but with polynomials of lower degree, through Chebyshev's nodes: log2(m) / 2.4 for
/// m in [1, 2] is within 4.8e-5, 2^r for |r| <= 1/2 within 1e-4 of itself, the code within .026.
Batch near_srgb_code(const Batch& x) {
  if constexpr (Batch::lanes == Parabolas::count) return code_by_parabolas(x);
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
