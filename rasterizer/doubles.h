// Vectors of doubles beside those of floats: for whole numbers that float does not hold.
#pragma once

#include "rasterizer/batch.h"

namespace scanlit {

/// As many doubles as a Batch has floats.
struct Doubles {
  using Ints = hn::Vec<hn::RebindToSigned<Batch::Tag>>;
  using Tag = hn::ScalableTag<double>;
  hn::Vec<Tag> low, high;

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
  static Doubles all(double v) { return {hn::Set(Tag(), v), hn::Set(Tag(), v)}; }

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
};

}  // namespace scanlit
