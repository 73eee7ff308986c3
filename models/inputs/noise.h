// Input: solid noise, a cloudy mixture of two values that the object is carved from.
#pragma once

#include "models/input.h"
#include "models/inputs/lattice_noise.h"

namespace scanlit::models {

struct Noise {
  Rgb<double> a{0.2}, b{0.8};
  double scale = 0.25, octaves = 4;

  template <class T>
  Rgb<T> operator()(const SurfacePoint<T>& p) const {
    const T share = T(0.5) + T(0.5) * fractal_noise(p.object_position * T(1 / scale), int(octaves));
    const Rgb<T> from = a * T(1);
    return from + (b * T(1) - from) * share;
  }

  static InputDescription<Noise> describe() {
    return {.name = "noise",
            .title = "solid noise in object space",
            .source = "Perlin 1985, An image synthesizer; 2002, Improving noise",
            .parameters = {
                {"a", &Noise::a, 0, 1e5, "the value where the noise is -1"},
                {"b", &Noise::b, 0, 1e5, "the value where it is 1; half-way at 0"},
                {"scale", &Noise::scale, 1e-6, 1e6, "size of its largest features"},
                {"octaves", &Noise::octaves, 1, 8, "how many noises, each twice as fine; whole"}}};
  }
};

inline const RegisteredInput<Noise> noise_registered;

}  // namespace scanlit::models
