// Input: the mesh's own colours, linear; white where it has none.
#pragma once

#include "models/input.h"

namespace scanlit::models {

struct VertexColour {
  Rgb<double> tint{1.0};

  template <class T>
  Rgb<T> operator()(const SurfacePoint<T>& p) const {
    return tint * p.vertex_colour;
  }

  static InputDescription<VertexColour> describe() {
    return {.name = "vertex-colour",
            .title = "the colours of the mesh's vertices",
            .source = "",
            .parameters = {{"tint", &VertexColour::tint, 0, 1, "factor per channel"}}};
  }
};

inline const RegisteredInput<VertexColour> vertex_colour_registered;

}  // namespace scanlit::models
