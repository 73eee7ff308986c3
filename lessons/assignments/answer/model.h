// What a reflection model of yours is written in, and how the judge asks it.
//
// The vocabulary is the engine's own: Vec3 and Rgb (rasterizer/vec.h), exp, pow, min, select ...
// (rasterizer/scalar_math.h), Cosines and ShadingFrame (rasterizer/cosines.h), Reflection
// (rasterizer/reflection_model.h).
//
// A question holds pairs of unit directions in the shading frame (x tangent, y bitangent, z
// normal), l towards the light and v towards the viewer, both above the surface; an answer so many
// numbers a pair. A number that is not finite is sent as what it is, so that the judge can say
// where it arose.
#pragma once

#include <cmath>
#include <numbers>

#include "answer/serve.h"
#include "rasterizer/cosines.h"
#include "rasterizer/vec.h"

namespace scanlit::answer {

/// One pair of directions, and what formulas see of it.
template <class T>
struct Pair {
  Vec3<T> l, v;
  Cosines<T> cosines;
  ShadingFrame<T> frame;
};

template <class T>
Pair<T> make_pair(const Vec3<T>& l, const Vec3<T>& v) {
  const Vec3<T> n{T(0), T(0), T(1)}, t{T(1), T(0), T(0)};
  return {l, v, cosines(n, l, v), shading_frame(n, t, l, v)};
}

/// The next one of a question.
template <class T = double>
Pair<T> pair(Received& question) {
  const auto vector = [&question] {
    const double x = question.real(), y = question.real(), z = question.real();
    return Vec3<T>{T(x), T(y), T(z)};
  };
  const Vec3<T> l = vector(), v = vector();
  return make_pair(l, v);
}

/// Adds a number to the answer: a whole number that is 0 where it is finite, 1 for NaN, 2 for an
/// infinity; and the real one.
inline void put(Sent& answer, double value) {
  const bool finite = std::isfinite(value);
  answer.integers.push_back(finite ? 0 : std::isnan(value) ? 1 : 2);
  answer.reals.push_back(finite ? value : 0);
}
template <class T>
void put(Sent& answer, const Rgb<T>& value) {
  put(answer, double(value.r)), put(answer, double(value.g)), put(answer, double(value.b));
}
template <class T>
void put(Sent& answer, const Reflection<T>& value) {
  put(answer, value.diffuse), put(answer, value.glossy);
}

/// `reply(pair)` for every pair of a question whose first whole number says how many there are.
template <class T = double, class Reply>
void for_each_pair(Received& question, Sent& answer, const Reply& reply) {
  for (std::int64_t left = question.integer(); left > 0; --left)
    put(answer, reply(pair<T>(question)));
}

}  // namespace scanlit::answer
