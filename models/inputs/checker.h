// Input: a checkerboard in texture coordinates.
#pragma once

#include "models/input.h"

namespace scanlit::models {

struct Checker {
  Rgb<double> a{0.8}, b{0.2};
  double count = 8;

  template <class T>
  Rgb<T> operator()(const SurfacePoint<T>& p) const {
    const auto half = [](const T& x) { return x - floor(x) < T(0.5); };
    const T u(p.u * T(0.5 * count)), v(p.v * T(0.5 * count));
    const T same = select(half(u), T(1), T(-1)) * select(half(v), T(1), T(-1));
    const auto mask = same > T(0);
    return {select(mask, T(a.r), T(b.r)), select(mask, T(a.g), T(b.g)),
            select(mask, T(a.b), T(b.b))};
  }

  static InputDescription<Checker> describe() {
    return {.name = "checker",
            .title = "a checkerboard in texture coordinates",
            .source = "",
            .parameters = {{"a", &Checker::a, 0, 1e5, "one field, that at (0, 0)"},
                           {"b", &Checker::b, 0, 1e5, "the other"},
                           {"count", &Checker::count, 0.01, 1e4, "fields from 0 to 1"}}};
  }
};

inline const RegisteredInput<Checker> checker_registered;

}  // namespace scanlit::models
