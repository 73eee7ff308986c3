// Vectors of doubles beside those of floats: for whole numbers that float does not hold.
#pragma once

#include "rasterizer/batch.h"

namespace scanlit {

/// As many doubles as a Batch has floats.
struct Doubles {
  using Ints = hn::Vec<hn::RebindToSigned<Batch::Tag>>;
  using Tag = hn::ScalableTag<double>;
  using Half = hn::Vec<Tag>;
  Half low, high;

  Doubles(Half lower, Half upper) : low(lower), high(upper) {}
  Doubles(double v) : low(hn::Set(Tag(), v)), high(low) {}

  static Doubles from(Ints v) {
    const hn::Rebind<std::int32_t, Tag> half;
    return {hn::PromoteTo(Tag(), hn::LowerHalf(half, v)),
            hn::PromoteTo(Tag(), hn::UpperHalf(half, v))};
  }
  static Doubles from(Batch v) {
    const hn::Rebind<float, Tag> half;
    return {hn::PromoteTo(Tag(), hn::LowerHalf(half, v.raw)),
            hn::PromoteTo(Tag(), hn::UpperHalf(half, v.raw))};
  }
  Batch rounded() const {
    const hn::Rebind<float, Tag> half;
    return hn::Combine(Batch::tag, hn::DemoteTo(half, high), hn::DemoteTo(half, low));
  }
  /// Of whole numbers; the nearest int where they are beyond its range.
  Ints ints() const {
    const hn::Rebind<std::int32_t, Tag> half;
    return hn::Combine(hn::RebindToSigned<Batch::Tag>(), hn::DemoteTo(half, high),
                       hn::DemoteTo(half, low));
  }

  friend Doubles operator+(const Doubles& a, const Doubles& b) {
    return {hn::Add(a.low, b.low), hn::Add(a.high, b.high)};
  }
  friend Doubles operator-(const Doubles& a, const Doubles& b) {
    return {hn::Sub(a.low, b.low), hn::Sub(a.high, b.high)};
  }
  friend Doubles operator*(const Doubles& a, const Doubles& b) {
    return {hn::Mul(a.low, b.low), hn::Mul(a.high, b.high)};
  }
  friend Doubles operator/(const Doubles& a, const Doubles& b) {
    return {hn::Div(a.low, b.low), hn::Div(a.high, b.high)};
  }
  friend Doubles min(const Doubles& a, const Doubles& b) {
    return {hn::Min(a.low, b.low), hn::Min(a.high, b.high)};
  }
  friend Doubles max(const Doubles& a, const Doubles& b) {
    return {hn::Max(a.low, b.low), hn::Max(a.high, b.high)};
  }
  friend Doubles ceil(const Doubles& a) { return {hn::Ceil(a.low), hn::Ceil(a.high)}; }
};

}  // namespace scanlit
