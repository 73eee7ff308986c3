// A9, a mutant hunt: what your tests are written with. Yours is mutant_hunt.cpp.
#pragma once

#include <cstdint>
#include <vector>

namespace a9 {

/// On the screen, in 1/256 pixel; |x|, |y| < 2^24.
struct Point {
  std::int64_t x, y;
};

struct Triangle {
  Point corners[3];  // in any order
};

struct Fragment {
  int column, row;
};

/// The stage under test: which pixels of a picture of 1 to 64 columns and rows the triangle covers,
/// each once, in any order. It is somewhere else, and you do not know whether it is right.
std::vector<Fragment> scan_convert(const Triangle& triangle, int width, int height);

/// Ends the test, which has failed, where the condition does not hold.
void check(bool condition);

struct Test {
  const char* name;
  void (*run)();
};

/// Yours: at most 64.
const std::vector<Test>& tests();

}  // namespace a9
