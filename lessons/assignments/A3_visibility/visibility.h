// A3, depth and visibility: what is yours to write, in visibility.cpp. README.md says what each
// function is to do.
#pragma once

#include <cstdint>
#include <vector>

namespace a3 {

/// As it is kept: a whole number of the variant's bits.
using StoredDepth = std::uint32_t;

/// On the screen, in pixels; depth 0..1.
struct Corner {
  double x, y, depth;
};

struct Fragment {
  int column, row;  // in the picture or outside of it
  double depth;
  int id;  // whose it is, 0 or more
};

/// The functions below, for draw() to call. While A3.5 is judged these are right, whatever yours
/// are; in the picture of A3.6 they are your own.
struct Stages {
  StoredDepth (*stored)(double depth);
  StoredDepth (*farthest)();
  bool (*replaces)(StoredDepth fresh, StoredDepth there);
};

/// A3.1
double depth_of(double distance, double near, double far);
/// A3.2
double depth_at(const Corner (&triangle)[3], double x, double y);
/// A3.3
StoredDepth stored(double depth);
/// A3.4
StoredDepth farthest();
bool replaces(StoredDepth fresh, StoredDepth there);
/// A3.5: what is seen at pixel (column, row) is element row * width + column; -1: nothing.
std::vector<int> draw(const std::vector<Fragment>& fragments, int width, int height,
                      const Stages& stages);

}  // namespace a3
