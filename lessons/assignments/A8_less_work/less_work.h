// A8, less work: what is yours to write, in less_work.cpp. README.md says what it is to do.
#pragma once

#include <vector>

namespace a8 {

struct Vector {
  double x, y, z;
};

/// Linear light.
struct Colour {
  double r, g, b;
};

/// Of one row of pixels, in the order in which triangles were drawn. Several may lie at one pixel.
struct Fragment {
  int column;       // 0 .. width - 1
  double depth;     // which of two is nearer, your variant says
  Vector position;  // world space
  Vector normal;    // unit
};

/// A point light. At distance d it is seen with share (1 - (d / reach)^inner)^outer, powers of your
/// variant, and not at all from `reach` on. What it adds to a fragment is at most
/// intensity * share * peak in each channel, and nothing where it stands behind the surface.
struct Light {
  Vector position;
  double intensity, reach;
};

struct Row {
  int width;
  std::vector<Fragment> fragments;
  std::vector<Light> lights;
  double peak;       // the most that the reflection model gives
  double tolerance;  // by how much a channel of a pixel may be off
};

/// What a light adds to a fragment: indices in Row.
struct Pair {
  int fragment, light;
};

/// The reflection model, at all of these. Each pair counts as one evaluation; calls cost nothing.
std::vector<Colour> evaluate(const std::vector<Pair>& pairs);

/// The row's pixels: of each the nearest fragment, as the sum of what all lights add to it; black
/// where there is none.
std::vector<Colour> shade(const Row& row);

}  // namespace a8
