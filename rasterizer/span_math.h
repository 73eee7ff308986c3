// (9) Vectors over a span's points: from arrays of floats to Vec3<Batch> and back.
#pragma once

#include <glm/mat3x3.hpp>

#include "rasterizer/batch_vec.h"
#include "rasterizer/fragment_span.h"

namespace scanlit {

using FloatArray = float[FragmentSpan::padded];
using Vec3Array = FloatArray[3];

inline Vec3<Batch> load(const Vec3Array& a, int i) {
  return {Batch::load(a[0] + i), Batch::load(a[1] + i), Batch::load(a[2] + i)};
}

inline void store(const Vec3<Batch>& v, Vec3Array& a, int i) {
  v.x.store(a[0] + i), v.y.store(a[1] + i), v.z.store(a[2] + i);
}

inline Vec3<Batch> transform(const glm::mat3& m, const Vec3<Batch>& v) {
  const auto row = [&](int i) {
    return mul_add(Batch(m[0][i]), v.x, mul_add(Batch(m[1][i]), v.y, Batch(m[2][i]) * v.z));
  };
  return {row(0), row(1), row(2)};
}

}  // namespace scanlit
