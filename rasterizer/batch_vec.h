// Vec3 and Rgb of Batch: from arrays of floats, from numbers, and what directions need.
#pragma once

#include <cstddef>

#include "rasterizer/batch.h"
#include "rasterizer/vec.h"

namespace scanlit {

// A vector of a span's points, from point i on.
inline Vec3<Batch> load_vec3(const float* const* a, std::size_t i) {
  return {Batch::load(a[0] + i), Batch::load(a[1] + i), Batch::load(a[2] + i)};
}
inline Rgb<Batch> load_rgb(const float* const* a, std::size_t i) {
  return {Batch::load(a[0] + i), Batch::load(a[1] + i), Batch::load(a[2] + i)};
}

template <class V>
Vec3<Batch> broadcast(const V& v) {
  return {Batch(float(v.x)), Batch(float(v.y)), Batch(float(v.z))};
}

inline Vec3<Batch> select(Batch::Mask m, const Vec3<Batch>& a, const Vec3<Batch>& b) {
  return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}

/// Whether a vector of this squared length has a direction that float can tell.
inline Batch::Mask has_direction(const Batch& length2) {
  return (length2 > Batch(1e-30f)) & (length2 < Batch(1e36f));
}

/// v / |v|, or `otherwise` where v has no direction: a normal interpolated to zero, a light or an
/// eye that lies on the surface. There 1/|v| would be infinite or NaN.
inline Vec3<Batch> normalize_or(const Vec3<Batch>& v, const Vec3<Batch>& otherwise) {
  const Batch length2 = dot(v, v);
  return select(has_direction(length2), v * inverse_sqrt(length2), otherwise);
}

}  // namespace scanlit
